// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRON_FACETS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRON_FACETS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The cube with vertices 0 1 2 3 counterclockwise around its bottom and 4 5 6 7 above them.
struct Reference_hexahedron {
  /// The neighbours of each corner, positively oriented.
  static constexpr int neighbors[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                          {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  /// The four edges along each axis.
  static constexpr int axis_edges[3][4][2] = {
      {{0, 1}, {3, 2}, {4, 5}, {7, 6}}, {{0, 3}, {1, 2}, {4, 7}, {5, 6}}, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  /// The facets, counterclockwise seen from outside.
  static constexpr int facets[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                       {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
};

// The facets of hexahedra by the number of hexahedra that they are in.
struct Hexahedron_facets {
  using Quadrilateral = std::array<std::size_t, 4>;

  std::vector<Quadrilateral> boundary; // in one hexahedron; counterclockwise seen from outside
  std::size_t non_manifold = 0;        // number of those in more than two

  explicit Hexahedron_facets(const std::vector<std::array<std::size_t, 8>>& hexahedra) {
    std::vector<std::pair<Quadrilateral, Quadrilateral>> facets; // sorted vertices, oriented vertices
    facets.reserve(6 * hexahedra.size());
    for (const auto& v : hexahedra)
      for (const auto& f : Reference_hexahedron::facets) {
        const Quadrilateral oriented = {v[f[0]], v[f[1]], v[f[2]], v[f[3]]};
        facets.emplace_back(oriented, oriented);
        std::sort(facets.back().first.begin(), facets.back().first.end());
      }
    std::sort(facets.begin(), facets.end());
    for (std::size_t k = 0, end; k < facets.size(); k = end) {
      for (end = k + 1; end < facets.size() && facets[end].first == facets[k].first;) ++end;
      if (end - k == 1) boundary.push_back(facets[k].second);
      non_manifold += end - k > 2;
    }
  }
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRON_FACETS_H
