// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_GEOMETRIC_ORDER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_GEOMETRIC_ORDER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

// Orders that depend on coordinates alone, so that results do not depend on how a mesh is numbered. If a mesh that has
// simplices of equal size is turned, another one may still come first: rounding makes their sizes differ anyway.

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A share of a whole below which a difference is taken for rounding: what it is the difference of counts as equal.
constexpr double rounding_share = 1. / (1ull << 40);

// Compares the points of two vertices lexicographically, and their numbers only where the points coincide.
template <typename Vertex, typename Point_of>
bool comes_before(Vertex v, Vertex w, const Point_of& point) {
  const Comparison_result order = CGAL::compare_lexicographically(point(v), point(w));
  return order == EQUAL ? v < w : order == SMALLER;
}

// Sorts edges or facets, each given by its vertices, by decreasing length of the longest edge, then lexicographically
// by their points; the vertices of each get sorted, too.
template <typename Simplex, typename Point_of>
void sort_longest_first(std::vector<Simplex>& simplices, const Point_of& point) {
  const auto before = [&](auto v, auto w) { return comes_before(v, w, point); };
  const auto squared_length = [&](const Simplex& s) {
    double longest = 0;
    for (std::size_t i = 1; i < s.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        longest = (std::max)(longest, (point(s[i]) - point(s[j])).squared_length());
    return longest;
  };
  std::vector<std::pair<double, Simplex>> keyed;
  keyed.reserve(simplices.size());
  for (Simplex& s : simplices) {
    std::sort(s.begin(), s.end(), before);
    keyed.emplace_back(squared_length(s), std::move(s));
  }
  std::sort(keyed.begin(), keyed.end(), [&](const auto& a, const auto& b) {
    if (a.first != b.first) return a.first > b.first;
    return std::lexicographical_compare(a.second.begin(), a.second.end(), b.second.begin(), b.second.end(),
                                        before);
  });
  std::transform(keyed.begin(), keyed.end(), simplices.begin(), [](auto& k) { return std::move(k.second); });
}

// The place of each cell in the lexicographic order of its points.
template <typename Mesh>
std::vector<std::uint32_t> geometric_ranks(const Mesh& mesh) {
  std::vector<Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::sort(vertices.begin(), vertices.end(), [&](Vertex_index v, Vertex_index w) {
    return comes_before(v, w, [&](Vertex_index u) { return approximate(mesh.point(u)); });
  });
  std::vector<std::uint32_t> rank_of_vertex(vertices.size());
  for (std::uint32_t k = 0; k < vertices.size(); ++k) rank_of_vertex[vertices[k]] = k;
  std::vector<std::pair<std::array<std::uint32_t, 4>, Cell_index>> cells;
  for (Cell_index c : mesh.cells()) {
    const auto& v = mesh.cell(c);
    cells.push_back(
        {{rank_of_vertex[v[0]], rank_of_vertex[v[1]], rank_of_vertex[v[2]], rank_of_vertex[v[3]]}, c});
    std::sort(cells.back().first.begin(), cells.back().first.end());
  }
  std::sort(cells.begin(), cells.end());
  std::vector<std::uint32_t> ranks(cells.size());
  for (std::uint32_t k = 0; k < cells.size(); ++k) ranks[cells[k].second] = k;
  return ranks;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_GEOMETRIC_ORDER_H
