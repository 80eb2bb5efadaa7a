// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COLOR_NODES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COLOR_NODES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Divides nodes into classes, in each of which no two nodes are in one hexahedron: so a class can be moved at a time. Each
// node gets the first class that it fits in.
inline std::vector<std::vector<std::size_t>>
color_nodes(const Incidence_lists<std::size_t, std::size_t>& stars, const std::vector<std::array<std::size_t, 8>>& hexahedra) {
  constexpr std::size_t none = std::size_t(-1);
  std::vector<std::vector<std::size_t>> classes;
  std::vector<std::size_t> color(stars.size(), none);
  for (std::size_t v = 0; v < stars.size(); ++v) {
    std::vector<char> is_taken(classes.size() + 1, 0);
    for (std::size_t h : stars[v])
      for (std::size_t w : hexahedra[h])
        if (color[w] != none) is_taken[color[w]] = 1;
    color[v] = std::size_t(std::find(is_taken.begin(), is_taken.end(), 0) - is_taken.begin());
    if (color[v] == classes.size()) classes.emplace_back();
    classes[color[v]].push_back(v);
  }
  return classes;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_COLOR_NODES_H
