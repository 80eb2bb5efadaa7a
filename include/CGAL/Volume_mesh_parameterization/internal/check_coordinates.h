// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHECK_COORDINATES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHECK_COORDINATES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

inline bool are_finite(double x, double y, double z) {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
}

template <typename Point>
bool has_finite_coordinates(const Point& point) {
  const auto p = approximate(point);
  return are_finite(p.x(), p.y(), p.z());
}

// point_of(i) is vertex i.
template <typename PointOf>
Status check_coordinates(std::size_t number_of_vertices, const PointOf& point_of) {
  for (std::size_t v = 0; v < number_of_vertices; ++v)
    if (!has_finite_coordinates(point_of(v)))
      return {ERROR_COORDINATE_NOT_FINITE, "vertex " + std::to_string(v)};
  return {};
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHECK_COORDINATES_H
