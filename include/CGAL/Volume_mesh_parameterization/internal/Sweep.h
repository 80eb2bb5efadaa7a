// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SWEEP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SWEEP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Sweep_guide_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Edge_numbering.h>
#include <CGAL/Volume_mesh_parameterization/internal/Index_queue.h>
#include <CGAL/Volume_mesh_parameterization/internal/sort_in_parallel.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
A front that sweeps the cells of a mesh from one base to the other. What is swept is kept as three sets of reached
facets, edges and vertices, which start with those of the base. A cell may be swept when

(1) it meets the reached set in one to three whole facets that are not on walls, its entry facets, and in no further
    edge or vertex;
(2) at least one facet is left that is neither entry facet nor on a wall: its exit facets;
(3) its vertices and edges on walls that are not reached yet lie in its own wall facets.
*/
template <typename GeomTraits>
class Sweep {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;

  // base: FLOOR or CEILING
  Sweep(const Mesh& mesh, const Edge_numbering& edges, int base)
      : m_mesh(mesh),
        m_edges(edges),
        m_upwards(base == FLOOR ? 1 : -1),
        m_swept(mesh.number_of_cells(), 0),
        m_facets(mesh.number_of_facets(), 0),
        m_edge_flags(edges.number_of_edges(), 0),
        m_vertex_flags(mesh.number_of_vertices(), 0) {
    for (Facet_index f : mesh.boundary_facets()) {
      if (mesh.label(f) >= FIRST_WALL) flag_closure(mesh.half_facet(f), ON_WALL);
      if (mesh.label(f) == base) {
        m_facets[f] = 1;
        flag_closure(mesh.half_facet(f), REACHED);
      }
    }
  }

  // Leaves out a cell that another sweep has taken.
  void exclude(Cell_index c) { m_swept[c] = 1; }

  // Sweeps whatever can be swept: first cells that are entered and left as they wish, and among those the one of least
  // potential. A cell is queued again whenever something around it changes; what is out of date is skipped.
  template <typename ConcurrencyTag = Sequential_tag>
  void run(const Sweep_guide_3& guide) {
    const std::vector<Cell_index> cells = sorted_cells<ConcurrencyTag>(guide);
    std::vector<std::uint32_t> places(cells.size());
    for (std::uint32_t k = 0; k < cells.size(); ++k) places[cells[k]] = k;
    Index_queue wished(cells.size()), unwished(cells.size());
    const auto push_if_free = [&](Cell_index c) {
      if (!m_swept[c] && is_free(c)) (is_entered_as_wished(c, guide) ? wished : unwished).push(places[c]);
    };
    for (Cell_index c : m_mesh.cells()) push_if_free(c);
    while (!wished.empty() || !unwished.empty()) {
      const bool as_wished = !wished.empty();
      const Cell_index c = cells[(as_wished ? wished : unwished).pop()];
      if (m_swept[c] || as_wished != is_entered_as_wished(c, guide) || !is_free(c)) continue;
      sweep(c);
      for (Cell_index changed : m_changed) push_if_free(changed);
      m_changed.clear();
    }
  }

  bool is_complete() const { return m_order.size() == m_mesh.number_of_cells(); }
  bool is_swept(Cell_index c) const { return m_swept[c] != 0; }
  const std::vector<Cell_index>& order() const { return m_order; }

  bool is_free(Cell_index c) const {
    Closure entry, wall;
    int exits = 0;
    for (int i = 0; i < 4; ++i) {
      const Facet_index f = m_mesh.facet(c, i);
      if (m_mesh.label(f) >= FIRST_WALL)
        wall.add(i);
      else if (m_facets[f])
        entry.add(i);
      else
        ++exits;
    }
    if (entry.vertices == 0 || exits == 0) return false;
    for (int i = 0; i < 4; ++i)
      if (!is_allowed(m_vertex_flags[m_mesh.vertex(c, i)], entry.vertices >> i & 1, wall.vertices >> i & 1)) return false;
    for (int k = 0; k < 6; ++k)
      if (!is_allowed(m_edge_flags[m_edges.edge(c, k)], entry.edges >> k & 1, wall.edges >> k & 1)) return false;
    return true;
  }

  // requires is_free(c)
  void sweep(Cell_index c) {
    m_swept[c] = 1;
    m_order.push_back(c);
    std::array<bool, 4> is_exit;
    for (int i = 0; i < 4; ++i) {
      const Facet_index f = m_mesh.facet(c, i);
      is_exit[i] = !m_facets[f] && m_mesh.label(f) < FIRST_WALL;
    }
    for (int i = 0; i < 4; ++i)
      if (is_exit[i]) reach({c, i});
  }

private:
  enum : char { REACHED = 1, ON_WALL = 2 };

  // All cells in the order in which they are preferred.
  template <typename ConcurrencyTag>
  std::vector<Cell_index> sorted_cells(const Sweep_guide_3& guide) const {
    std::vector<Cell_index> cells(m_mesh.cells().begin(), m_mesh.cells().end());
    sort_in_parallel<ConcurrencyTag>(cells.begin(), cells.end(), [&](Cell_index c, Cell_index d) {
      const double a = m_upwards * guide.potential[c], b = m_upwards * guide.potential[d];
      if (a != b) return a < b;
      const auto rank = [&](Cell_index e) { return guide.ranks.empty() ? 0 : guide.ranks[e]; };
      return rank(c) != rank(d) ? rank(c) < rank(d) : c < d;
    });
    return cells;
  }

  bool is_entered_as_wished(Cell_index c, const Sweep_guide_3& guide) const {
    if (guide.signs.empty()) return true;
    for (int i = 0; i < 4; ++i) {
      const Facet_index f = m_mesh.facet(c, i);
      const int sign = m_mesh.label(f) >= FIRST_WALL ? 0 : m_facets[f] ? m_upwards : -m_upwards;
      if (sign != guide.signs[c][i]) return false;
    }
    return true;
  }

  // the vertices and edges of some facets of a cell, as bits
  struct Closure {
    unsigned vertices = 0, edges = 0;
    void add(int facet) {
      static constexpr unsigned facet_edges[4] = {0b111000, 0b100110, 0b010101, 0b001011};
      vertices |= 0b1111u & ~(1u << facet);
      edges |= facet_edges[facet];
    }
  };

  // rules (1) and (3) for one vertex or edge
  static bool is_allowed(char flags, bool in_entry, bool in_wall_facet) {
    return flags & REACHED ? in_entry : in_wall_facet || !(flags & ON_WALL);
  }

  void flag_closure(Half_facet h, char flag) {
    Closure closure;
    closure.add(h.index);
    for (int i = 0; i < 4; ++i)
      if (closure.vertices >> i & 1) m_vertex_flags[m_mesh.vertex(h.cell, i)] |= flag;
    for (int k = 0; k < 6; ++k)
      if (closure.edges >> k & 1) m_edge_flags[m_edges.edge(h.cell, k)] |= flag;
  }

  // Adds an exit facet to the reached set. Only the cell above it may have become free: what is reached of any other cell
  // is in none of its entry facets, against rule (1).
  void reach(Half_facet h) {
    m_facets[m_mesh.facet(h.cell, h.index)] = 1;
    const Cell_index above = m_mesh.neighbor(h.cell, h.index);
    if (above.is_valid()) m_changed.push_back(above);
    flag_closure(h, REACHED);
  }

  const Mesh& m_mesh;
  const Edge_numbering& m_edges;
  int m_upwards;
  std::vector<char> m_swept, m_facets, m_edge_flags, m_vertex_flags;
  std::vector<Cell_index> m_order, m_changed;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SWEEP_H
