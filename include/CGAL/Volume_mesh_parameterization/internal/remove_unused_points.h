// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REMOVE_UNUSED_POINTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REMOVE_UNUSED_POINTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// for_each_use(visit) calls visit(std::size_t&) with every vertex number of a soup; they are changed to the new ones.
template <typename Point, typename ForEachUse>
void remove_unused_points(std::vector<Point>& points, const ForEachUse& for_each_use) {
  constexpr std::size_t unused = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> number(points.size(), unused);
  for_each_use([&](std::size_t v) { number[v] = 0; });
  std::size_t n = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != unused) {
      points[n] = points[v];
      number[v] = n++;
    }
  points.resize(n);
  for_each_use([&](std::size_t& v) { v = number[v]; });
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REMOVE_UNUSED_POINTS_H
