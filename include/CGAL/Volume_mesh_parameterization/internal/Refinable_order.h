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

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
The beginning of a sweep from the floor, of a mesh whose edges, facets and cells may be split at their barycentres.

Lemma: let s_x = +1, 0, -1 if the facet opposite to x is an entry, a wall or an exit facet of a swept cell. Splitting a simplex of
it makes one child for each vertex x of the simplex, in which the barycentre is in the place of x. If they take the place of the
cell in an order of falling s_x, then the longer order obeys the rules of the sweep as the shorter one did: the first child is
entered somewhere and the last one left, as the cell was.
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

  // Inserts the barycentre of the simplex with the given 2, 3 or 4 vertices.
  Status insert_barycentre(const std::vector<Vertex_index>& simplex) {
    std::vector<Child> children; // of one parent
    return m_mesh.insert_barycentre(simplex, [&](Cell_index parent, Cell_index child, Vertex_index) {
      if (child == parent)
        children.clear();
      else
        add_child(parent, child);
      children.push_back({child, slot_of_last_vertex(child)});
      if (children.size() == simplex.size() && m_is_swept[parent]) order_children(parent, children);
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

  struct Child {
    Cell_index cell;
    int slot; // of the inserted vertex
  };

  // Called while the cells are appended: later neighbours are not swept yet.
  std::int8_t sign_of(const Mesh& mesh, Half_facet h) const {
    const int label = mesh.label(h.cell, h.index);
    if (label != INTERIOR) return label == FLOOR ? 1 : label == CEILING ? -1 : 0;
    return m_is_swept[mesh.neighbor(h.cell, h.index)] ? 1 : -1;
  }

  // The inserted vertex has the greatest number.
  int slot_of_last_vertex(Cell_index c) const {
    const auto& cell = m_mesh.cell(c);
    return int(std::max_element(cell.begin(), cell.end()) - cell.begin());
  }

  void add_child(Cell_index parent, Cell_index child) {
    CGAL_assertion(child == m_next.size());
    m_signs.push_back(m_signs[parent]);
    m_next.emplace_back();
    m_previous.emplace_back();
    m_is_swept.push_back(m_is_swept[parent]);
    static_cast<void>(child);
  }

  // The facet opposite to x of the child without x is that of the parent.
  void order_children(Cell_index parent, std::vector<Child>& children) {
    const Signs outer = m_signs[parent];
    std::sort(children.begin(), children.end(), [&](const Child& a, const Child& b) {
      return outer[a.slot] != outer[b.slot] ? outer[a.slot] > outer[b.slot] : a.cell > b.cell;
    });
    for (std::size_t i = 0; i < children.size(); ++i)
      for (std::size_t j = 0; j < children.size(); ++j)
        if (i != j) m_signs[children[i].cell][children[j].slot] = j < i ? 1 : -1;
    Cell_index before = m_previous[parent];
    const Cell_index after = m_next[parent];
    for (const Child& child : children) {
      link(before, child.cell);
      before = child.cell;
    }
    link(before, after);
  }

  void append(Cell_index c) {
    m_is_swept[c] = 1;
    link(m_last, c);
    m_last = c;
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
