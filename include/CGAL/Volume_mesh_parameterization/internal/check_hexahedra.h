// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHECK_HEXAHEDRA_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHECK_HEXAHEDRA_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// `ERROR_EMPTY_MESH`, `ERROR_INDEX_OUT_OF_RANGE` or `ERROR_COORDINATE_NOT_FINITE`; labelled facets are not looked at.
template <typename Point>
Status check_hexahedra(const Hexahedron_soup_3<Point>& soup) {
  if (soup.hexahedra.empty()) return {ERROR_EMPTY_MESH, "it has no hexahedra"};
  for (std::size_t h = 0; h < soup.hexahedra.size(); ++h) {
    auto v = soup.hexahedra[h];
    std::sort(v.begin(), v.end());
    if (v.back() >= soup.points.size() || std::adjacent_find(v.begin(), v.end()) != v.end())
      return {ERROR_INDEX_OUT_OF_RANGE, "hexahedron " + std::to_string(h)};
  }
  return check_coordinates(soup.points.size(), [&](std::size_t v) -> const Point& { return soup.points[v]; });
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHECK_HEXAHEDRA_H
