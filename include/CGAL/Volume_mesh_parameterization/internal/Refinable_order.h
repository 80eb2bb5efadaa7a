// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINABLE_ORDER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINABLE_ORDER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Splittable_mesh.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
The beginning of a sweep from the floor, of a mesh whose edges may be bisected.

Lemma: let s_x = +1, 0, -1 if the facet opposite to x is an entry, a wall or an exit facet of a swept cell with the edge
ab. If the half at b takes the place of the cell just before the half at a if s_a > s_b, and just after it otherwise,
then the longer order obeys the rules of the sweep as the shorter one did.
*/
template <typename GeomTraits>
class Refinable_order {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;

  Refinable_order(const Mesh& mesh, const std::vector<Cell_index>& order)
      : m_mesh(mesh),
        m_signs(mesh.number_of_cells(), Signs{0, 0, 0, 0}),
        m_next(mesh.number_of_cells()),
        m_previous(mesh.number_of_cells()),
        m_is_swept(mesh.number_of_cells(), 0) {
    for (Cell_index c : order) {
      append(c);
      for (int i = 0; i < 4; ++i) m_signs[c][i] = sign_of(mesh, {c, i});
    }
  }

  Status bisect(Vertex_index a, Vertex_index b) {
    // the first child, in which a is moved, is the half at b and keeps the number of the parent
    Signs parent_signs{};
    int slot_a = 0, slot_b = 0;
    return m_mesh.insert_barycentre({a, b}, [&](Cell_index parent, Cell_index child, Vertex_index moved) {
      if (moved == a) {
        parent_signs = m_signs[parent];
        slot_a = slot_of_last_vertex(child);
        slot_b = slot(child, b);
        return;
      }
      add_child(child);
      if (m_is_swept[parent]) order_halves(child, parent, parent_signs, slot_a, slot_b);
    });
  }

  const Splittable_mesh<GeomTraits>& mesh() const { return m_mesh; }

  // Hands out the refined mesh and the refined order.
  Status write_to(Mesh& mesh, std::vector<Cell_index>& order) && {
    order.clear();
    for (Cell_index c = m_first; c.is_valid(); c = m_next[c]) order.push_back(c);
    return std::move(m_mesh).write_to(mesh);
  }

private:
  using Signs = std::array<std::int8_t, 4>;

  // Called while the cells are appended: later neighbours are not swept yet.
  std::int8_t sign_of(const Mesh& mesh, Half_facet h) const {
    const int label = mesh.label(h.cell, h.index);
    if (label != INTERIOR) return label == FLOOR ? 1 : label == CEILING ? -1 : 0;
    return m_is_swept[mesh.neighbor(h.cell, h.index)] ? 1 : -1;
  }

  int slot(Cell_index c, Vertex_index v) const {
    const auto& cell = m_mesh.cell(c);
    return int(std::find(cell.begin(), cell.end(), v) - cell.begin());
  }
  // The inserted vertex has the greatest number.
  int slot_of_last_vertex(Cell_index c) const {
    const auto& cell = m_mesh.cell(c);
    return int(std::max_element(cell.begin(), cell.end()) - cell.begin());
  }

  void add_child(Cell_index child) {
    CGAL_assertion(child == m_next.size());
    m_signs.push_back({0, 0, 0, 0});
    m_next.emplace_back();
    m_previous.emplace_back();
    m_is_swept.push_back(0);
    static_cast<void>(child);
  }

  void order_halves(Cell_index half_a, Cell_index half_b, const Signs& parent, int slot_a, int slot_b) {
    const bool b_first = parent[slot_a] > parent[slot_b];
    m_signs[half_a] = m_signs[half_b] = parent;
    m_signs[half_a][slot_a] = b_first ? 1 : -1; // the facet between the halves
    m_signs[half_b][slot_b] = b_first ? -1 : 1;
    m_is_swept[half_a] = 1;
    if (b_first)
      insert_after(half_b, half_a);
    else
      insert_before(half_b, half_a);
  }

  void append(Cell_index c) {
    m_is_swept[c] = 1;
    if (m_last.is_valid())
      insert_after(m_last, c);
    else
      m_first = m_last = c;
  }
  void insert_after(Cell_index place, Cell_index c) {
    link(c, m_next[place]);
    link(place, c);
  }
  void insert_before(Cell_index place, Cell_index c) {
    link(m_previous[place], c);
    link(c, place);
  }
  void link(Cell_index before, Cell_index after) {
    if (before.is_valid())
      m_next[before] = after;
    else
      m_first = after;
    if (after.is_valid())
      m_previous[after] = before;
    else
      m_last = before;
  }

  Splittable_mesh<GeomTraits> m_mesh;
  std::vector<Signs> m_signs;
  std::vector<Cell_index> m_next, m_previous; // the order as a list
  std::vector<char> m_is_swept;
  Cell_index m_first, m_last;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINABLE_ORDER_H
