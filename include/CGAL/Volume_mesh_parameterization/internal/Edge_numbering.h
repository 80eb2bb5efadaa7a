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

#include <boost/range/irange.hpp>
#include <boost/range/adaptor/transformed.hpp>

#include <algorithm>
#include <array>
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

  template <typename Mesh>
  explicit Edge_numbering(const Mesh& mesh) : m_cell_edges(mesh.number_of_cells()) {
    const auto other_end = [&](std::uint32_t use) {
      return sorted_ends<Mesh>(mesh.cell(use / 6), use % 6)[1];
    };
    const Incidence_lists<Vertex_index, std::uint32_t> uses(
        mesh.number_of_vertices(), 6 * m_cell_edges.size(), [&](std::uint32_t use) {
          return std::array<Vertex_index, 1>{sorted_ends<Mesh>(mesh.cell(use / 6), use % 6)[0]};
        });
    std::vector<Edge_index> edge_to(mesh.number_of_vertices());
    m_first.reserve(mesh.number_of_vertices() + 1);
    for (Vertex_index v(0); v < mesh.number_of_vertices(); ++v) {
      m_first.push_back(Edge_index(m_ends.size()));
      number_edges_from(v, uses[v], other_end, edge_to);
    }
    m_first.push_back(Edge_index(m_ends.size()));
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
  // `edge_to` is invalid everywhere, before and after.
  template <typename Uses, typename OtherEnd>
  void number_edges_from(Vertex_index v, const Uses& uses, const OtherEnd& other_end,
                         std::vector<Edge_index>& edge_to) {
    const std::size_t first = m_ends.size();
    for (std::uint32_t use : uses) {
      const Vertex_index w = other_end(use);
      if (edge_to[w].is_valid()) continue;
      edge_to[w] = Edge_index(0);
      m_ends.push_back({v, w});
    }
    std::sort(m_ends.begin() + first, m_ends.end());
    for (std::size_t e = first; e < m_ends.size(); ++e) edge_to[m_ends[e][1]] = Edge_index(e);
    for (std::uint32_t use : uses) m_cell_edges[use / 6][use % 6] = edge_to[other_end(use)];
    for (std::size_t e = first; e < m_ends.size(); ++e) edge_to[m_ends[e][1]] = Edge_index();
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
