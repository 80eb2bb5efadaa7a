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
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>

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

// The place of each vertex in the lexicographic order of the points.
template <typename Mesh>
std::vector<std::uint32_t> geometric_ranks_of_vertices(const Mesh& mesh) {
  std::vector<Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::sort(vertices.begin(), vertices.end(), [&](Vertex_index v, Vertex_index w) {
    return comes_before(v, w, [&](Vertex_index u) { return approximate(mesh.point(u)); });
  });
  std::vector<std::uint32_t> ranks(vertices.size());
  for (std::uint32_t k = 0; k < vertices.size(); ++k) ranks[vertices[k]] = k;
  return ranks;
}

// The place of each cell in the lexicographic order of its points. Cells are first put into lists by the first of their
// points, so that short lists are sorted instead of a long one.
template <typename Mesh>
std::vector<std::uint32_t> geometric_ranks(const Mesh& mesh) {
  const std::vector<std::uint32_t> vertex_ranks = geometric_ranks_of_vertices(mesh);
  const auto sorted_ranks = [&](Cell_index c) {
    std::array<std::uint32_t, 4> ranks;
    std::transform(mesh.cell(c).begin(), mesh.cell(c).end(), ranks.begin(), [&](Vertex_index v) { return vertex_ranks[v]; });
    std::sort(ranks.begin(), ranks.end());
    return ranks;
  };
  const Incidence_lists<std::uint32_t, Cell_index> lists(
      mesh.number_of_vertices(), mesh.number_of_cells(),
      [&](Cell_index c) { return std::array<std::uint32_t, 1>{sorted_ranks(c)[0]}; });
  std::vector<std::uint32_t> ranks(mesh.number_of_cells());
  std::vector<std::pair<std::array<std::uint32_t, 4>, Cell_index>> list;
  std::uint32_t rank = 0;
  for (std::uint32_t first = 0; first < lists.size(); ++first) {
    list.clear();
    for (Cell_index c : lists[first]) list.emplace_back(sorted_ranks(c), c);
    std::sort(list.begin(), list.end());
    for (const auto& cell : list) ranks[cell.second] = rank++;
  }
  return ranks;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_GEOMETRIC_ORDER_H
