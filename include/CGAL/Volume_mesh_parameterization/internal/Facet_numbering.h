// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FACET_NUMBERING_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FACET_NUMBERING_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Numbers the facets of tetrahedra: those of the boundary first, each kind in the lexicographic order of its vertices. Side
// 4 c + i of a facet is seen from cell c and opposite to its vertex i.
class Facet_numbering {
public:
  using Side = std::uint32_t;
  using Cell = std::array<Vertex_index, 4>;

  static constexpr Side none = Side(-1);

  // `opposites` are the other sides of all sides, or empty if these are to be found. The result does not depend on the number of
  // threads.
  template <typename ConcurrencyTag>
  Facet_numbering(const std::vector<Cell>& cells, std::size_t number_of_vertices, const std::vector<Side>& opposites,
                  ConcurrencyTag)
      : m_cells(cells), m_opposites(opposites) {
    const Lists lists = sides_by_first_vertex(number_of_vertices);
    const Index_blocks blocks(number_of_vertices, vertices_per_block);
    std::vector<Paired_sides> paired(blocks.size());
    const auto pair = [&](std::size_t b) { return pair_sides(lists, blocks[b], paired[b]); };
    m_status = try_each_index<ConcurrencyTag>(blocks.size(), pair, 1);
    if (!m_status.ok()) return;
    append(paired, &Paired_sides::boundary);
    m_number_of_boundary_facets = m_sides.size();
    append(paired, &Paired_sides::interior);
  }

  // `ERROR_NON_MANIFOLD` if a facet is in three cells, or in two that are no neighbors
  const Status& status() const { return m_status; }

  std::size_t number_of_boundary_facets() const { return m_number_of_boundary_facets; }

  // returns both sides of each facet; the second is `none` on the boundary.
  std::vector<std::array<Side, 2>> take_sides() && { return std::move(m_sides); }

private:
  static constexpr std::size_t vertices_per_block = 8192;
  using Lists = Incidence_lists<Vertex_index, Side>;
  // Of sides with the same smallest vertex: the other two, the smaller one first.
  using Keyed_side = std::pair<std::uint64_t, Side>;

  // The facets whose smallest vertices are in the same block.
  struct Paired_sides {
    std::vector<std::array<Side, 2>> boundary, interior;
  };

  std::array<Vertex_index, 3> sorted_vertices(Side side) const {
    std::array<Vertex_index, 3> result;
    const Cell& cell = m_cells[side / 4];
    for (Side i = 0, k = 0; i < 4; ++i)
      if (i != side % 4) result[k++] = cell[i];
    std::sort(result.begin(), result.end());
    return result;
  }

  Keyed_side keyed(Side side) const {
    const auto v = sorted_vertices(side);
    return {std::uint64_t(v[1]) << 32 | v[2], side};
  }

  // A few short lists are sorted instead of a long one. If opposites are known, one side of each facet is enough; the other
  // sides follow in a list of their own.
  Lists sides_by_first_vertex(std::size_t number_of_vertices) const {
    return {number_of_vertices + 1, 4 * m_cells.size(), [&](Side side) {
              const bool is_other_side = !m_opposites.empty() && m_opposites[side] < side;
              return std::array<Vertex_index, 1>{is_other_side ? Vertex_index(number_of_vertices) : sorted_vertices(side)[0]};
            }};
  }

  template <typename Block>
  Status pair_sides(const Lists& lists, const Block& first_vertices, Paired_sides& paired) const {
    std::vector<Keyed_side> list;
    for (std::size_t first : first_vertices) {
      list.clear();
      for (Side side : lists[Vertex_index(first)]) list.push_back(keyed(side));
      std::sort(list.begin(), list.end());
      const Status status = pair_sides(list, paired);
      if (!status.ok()) return status;
    }
    return {};
  }

  Status pair_sides(const std::vector<Keyed_side>& sorted, Paired_sides& paired) const {
    const bool is_paired = !m_opposites.empty();
    for (std::size_t k = 0, end; k < sorted.size(); k = end) {
      for (end = k + 1; end < sorted.size() && sorted[k].first == sorted[end].first;) ++end;
      if (end - k > (is_paired ? 1 : 2)) return not_manifold(sorted, k, end);
      const Side side = sorted[k].second, other = is_paired ? m_opposites[side] : end - k == 2 ? sorted[k + 1].second : none;
      (other == none ? paired.boundary : paired.interior).push_back({side, other});
    }
    return {};
  }

  static Status not_manifold(const std::vector<Keyed_side>& sides, std::size_t first, std::size_t end) {
    std::string text = "tetrahedra " + std::to_string(sides[first].second / 4);
    for (std::size_t k = first + 1; k < end; ++k)
      text += (k + 1 == end ? " and " : ", ") + std::to_string(sides[k].second / 4);
    return {ERROR_NON_MANIFOLD, text + " share a facet" + (end - first == 2 ? ", but are no neighbors" : "")};
  }

  void append(std::vector<Paired_sides>& paired, std::vector<std::array<Side, 2>> Paired_sides::*part) {
    std::size_t size = m_sides.size();
    for (const Paired_sides& p : paired) size += (p.*part).size();
    m_sides.reserve(size);
    for (Paired_sides& p : paired) {
      m_sides.insert(m_sides.end(), (p.*part).begin(), (p.*part).end());
      std::vector<std::array<Side, 2>>().swap(p.*part);
    }
  }

  const std::vector<Cell>& m_cells;
  const std::vector<Side>& m_opposites;
  std::vector<std::array<Side, 2>> m_sides;
  std::size_t m_number_of_boundary_facets = 0;
  Status m_status;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FACET_NUMBERING_H
