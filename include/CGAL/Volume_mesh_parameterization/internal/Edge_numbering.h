// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EDGE_NUMBERING_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EDGE_NUMBERING_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <CGAL/tags.h>

#include <boost/range/irange.hpp>
#include <boost/range/adaptor/transformed.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Numbers the edges of a tetrahedral mesh in the lexicographic order of their ends, in linear time (but for the sorting
// of each vertex's neighbors).
class Edge_numbering {
public:
  using Ends = std::array<Vertex_index, 2>;
  using Cell_edges = std::array<Edge_index, 6>;

  Edge_numbering() = default;

  // The numbers do not depend on the number of threads.
  template <typename Mesh, typename ConcurrencyTag = Sequential_tag>
  explicit Edge_numbering(const Mesh& mesh, ConcurrencyTag = {}) : m_cell_edges(mesh.number_of_cells()) {
    const std::size_t n = mesh.number_of_vertices();
    const Index_blocks blocks(n, vertices_per_block(n));
    const auto other_end = [&](std::uint32_t use) { return sorted_ends<Mesh>(mesh.cell(use / 6), use % 6)[1]; };
    const Uses uses(n, 6 * m_cell_edges.size(), [&](std::uint32_t use) {
      return std::array<Vertex_index, 1>{sorted_ends<Mesh>(mesh.cell(use / 6), use % 6)[0]};
    });
    std::vector<std::vector<Ends>> ends(blocks.size());
    const auto find = [&](std::size_t b) { ends[b] = find_ends(blocks[b], uses, other_end); };
    for_each_index<ConcurrencyTag>(blocks.size(), find, 1);
    join(n, ends);
    const auto number = [&](std::size_t b) { number_edges_of_cells(blocks[b], uses, other_end); };
    for_each_index<ConcurrencyTag>(blocks.size(), number, 1);
  }

  std::size_t number_of_cells() const { return m_cell_edges.size(); }
  std::size_t number_of_edges() const { return m_ends.size(); }

  auto edges() const {
    return boost::irange(std::size_t(0), number_of_edges()) |
           boost::adaptors::transformed([](std::size_t e) { return Edge_index(e); });
  }

  // returns edge k of a cell, in the order of Compact_tetrahedral_mesh_3::edge_vertices.
  Edge_index edge(Cell_index c, int k) const { return m_cell_edges[c][k]; }
  const Cell_edges& edges(Cell_index c) const { return m_cell_edges[c]; }

  // Leaves what find() needs, a third of the memory.
  void forget_cells() { m_cell_edges = std::vector<Cell_edges>(); }

  // returns the two ends, the smaller number first.
  const Ends& ends(Edge_index e) const { return m_ends[e]; }

  // returns the edge between two vertices, an invalid index if there is none.
  Edge_index find(Vertex_index v, Vertex_index w) const {
    if (w < v) std::swap(v, w);
    const auto begin = m_ends.begin() + m_first[v], end = m_ends.begin() + m_first[v + 1];
    const auto found = std::lower_bound(begin, end, Ends{v, w});
    return found != end && (*found)[1] == w ? Edge_index(found - m_ends.begin()) : Edge_index();
  }

private:
  // Each block takes an array of the size of the mesh for a while, so there are at most 64 blocks.
  static std::size_t vertices_per_block(std::size_t n) { return (std::max)(std::size_t(8192), n / 64 + 1); }

  using Uses = Incidence_lists<Vertex_index, std::uint32_t>; // six for each cell: of edges, by their smaller ends

  // The edges whose smaller ends are in a block, in order.
  template <typename Block, typename OtherEnd>
  static std::vector<Ends> find_ends(const Block& block, const Uses& uses, const OtherEnd& other_end) {
    std::vector<Ends> result;
    std::vector<Vertex_index> found_for(uses.size());
    for (std::size_t i : block) {
      const Vertex_index v(i);
      const std::size_t first = result.size();
      for (std::uint32_t use : uses[v])
        if (const Vertex_index w = other_end(use); std::exchange(found_for[w], v) != v) result.push_back({v, w});
      std::sort(result.begin() + first, result.end());
    }
    return result;
  }

  void join(std::size_t number_of_vertices, const std::vector<std::vector<Ends>>& blocks) {
    std::size_t size = 0;
    for (const std::vector<Ends>& block : blocks) size += block.size();
    m_ends.reserve(size);
    for (const std::vector<Ends>& block : blocks) m_ends.insert(m_ends.end(), block.begin(), block.end());
    m_first.reserve(number_of_vertices + 1);
    for (std::size_t e = 0; e < size; ++e)
      while (m_first.size() <= m_ends[e][0]) m_first.push_back(Edge_index(e));
    m_first.resize(number_of_vertices + 1, Edge_index(size));
  }

  template <typename Block, typename OtherEnd>
  void number_edges_of_cells(const Block& block, const Uses& uses, const OtherEnd& other_end) {
    std::vector<Edge_index> edge_to(uses.size());
    for (std::size_t v : block) {
      for (std::size_t e = m_first[v]; e < m_first[v + 1]; ++e) edge_to[m_ends[e][1]] = Edge_index(e);
      for (std::uint32_t use : uses[Vertex_index(v)]) m_cell_edges[use / 6][use % 6] = edge_to[other_end(use)];
    }
  }

  template <typename Mesh, typename Cell>
  static Ends sorted_ends(const Cell& cell, int k) {
    const Vertex_index v = cell[Mesh::edge_vertices[k][0]], w = cell[Mesh::edge_vertices[k][1]];
    return v < w ? Ends{v, w} : Ends{w, v};
  }

  std::vector<Cell_edges> m_cell_edges;
  std::vector<Ends> m_ends;
  std::vector<Edge_index> m_first; // the first edge whose smaller end is a given vertex
};

// The cells around each edge.
class Edge_stars {
public:
  Edge_stars() = default;

  explicit Edge_stars(const Edge_numbering& numbering)
      : m_cells(numbering.number_of_edges(), numbering.number_of_cells(),
                [&](Cell_index c) -> const Edge_numbering::Cell_edges& { return numbering.edges(c); }) {}

  // returns an iterator range of `Cell_index` in increasing order.
  auto cells(Edge_index e) const { return m_cells[e]; }

private:
  Incidence_lists<Edge_index, Cell_index> m_cells;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EDGE_NUMBERING_H
