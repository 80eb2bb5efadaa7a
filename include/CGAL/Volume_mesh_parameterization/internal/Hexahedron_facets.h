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
#include <tuple>
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
  /// The facets, counterclockwise seen from outside, in the order of Abaqus: its faces S1 to S6.
  static constexpr int facets[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                       {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
};

// A facet of a hexahedron, by its number in Reference_hexahedron.
struct Hexahedron_side {
  using Quadrilateral = std::array<std::size_t, 4>;

  std::size_t hexahedron;
  int facet;
  Quadrilateral vertices;        // counterclockwise seen from outside
  Quadrilateral sorted_vertices; // the same for all sides on one facet of the mesh

  bool operator<(const Hexahedron_side& s) const {
    return std::tie(sorted_vertices, hexahedron) < std::tie(s.sorted_vertices, s.hexahedron);
  }
};

inline Hexahedron_side::Quadrilateral sorted(Hexahedron_side::Quadrilateral vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

// All sides; those on one facet of the mesh follow each other.
inline std::vector<Hexahedron_side> sorted_sides(const std::vector<std::array<std::size_t, 8>>& hexahedra) {
  std::vector<Hexahedron_side> sides;
  sides.reserve(6 * hexahedra.size());
  for (std::size_t h = 0; h < hexahedra.size(); ++h)
    for (int facet = 0; facet < 6; ++facet) {
      const auto& v = hexahedra[h];
      const auto& f = Reference_hexahedron::facets[facet];
      const Hexahedron_side::Quadrilateral vertices = {v[f[0]], v[f[1]], v[f[2]], v[f[3]]};
      sides.push_back({h, facet, vertices, sorted(vertices)});
    }
  std::sort(sides.begin(), sides.end());
  return sides;
}

// Calls visit(sides, n) for each facet of the mesh: a pointer to the n sides on it.
template <typename Visit>
void for_each_facet(const std::vector<Hexahedron_side>& sides, const Visit& visit) {
  for (std::size_t k = 0, end; k < sides.size(); k = end) {
    for (end = k + 1; end < sides.size() && sides[end].sorted_vertices == sides[k].sorted_vertices;) ++end;
    visit(&sides[k], end - k);
  }
}

// The facets of hexahedra by the number of hexahedra that they are in.
struct Hexahedron_facets {
  using Quadrilateral = Hexahedron_side::Quadrilateral;

  std::vector<Quadrilateral> boundary; // in one hexahedron; counterclockwise seen from outside
  std::size_t non_manifold = 0;        // number of those in more than two

  explicit Hexahedron_facets(const std::vector<std::array<std::size_t, 8>>& hexahedra)
      : Hexahedron_facets(sorted_sides(hexahedra)) {}

  explicit Hexahedron_facets(const std::vector<Hexahedron_side>& sorted_sides) {
    for_each_facet(sorted_sides, [&](const Hexahedron_side* sides, std::size_t n) {
      if (n == 1) boundary.push_back(sides->vertices);
      non_manifold += n > 2;
    });
  }
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRON_FACETS_H
