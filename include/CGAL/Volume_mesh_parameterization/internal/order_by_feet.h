// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ORDER_BY_FEET_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ORDER_BY_FEET_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Finds for cells the boundary facet at which one arrives who goes from cell to cell against most of the flow: roughly
// where the curves of the cell start. What is found is kept, so that all cells together take linear time. Where a field
// that is not certified leads round in a circle, the foot is facet 0.
template <typename Mesh, typename Field>
class Feet_of_cells {
public:
  Feet_of_cells(const Mesh& mesh, const Field& field)
      : m_mesh(mesh), m_field(field), m_feet(mesh.number_of_cells()) {}

  Facet_index operator()(Cell_index start) {
    Facet_index foot;
    for (Cell_index c = start; c.is_valid() && !foot.is_valid();) {
      foot = m_feet[c];
      m_feet[c] = Facet_index(0);
      m_way.push_back(c);
      const int entry = m_field.main_entry(c);
      c = m_field.cell(c).neighbors[entry];
      if (!c.is_valid() && !foot.is_valid()) foot = m_mesh.facet(m_way.back(), entry);
    }
    for (Cell_index c : m_way) m_feet[c] = foot;
    m_way.clear();
    return foot;
  }

private:
  const Mesh& m_mesh;
  const Field& m_field;
  std::vector<Facet_index> m_feet;
  std::vector<Cell_index> m_way;
};

// Sorts n seeds of curves by the feet of their cells: then many of the cells that a curve passes are still in the cache
// from the curves before.
template <typename Mesh, typename Field, typename CellOf>
std::vector<std::uint32_t> order_by_feet(const Mesh& mesh, const Field& field, std::size_t n, const CellOf& cell_of) {
  Feet_of_cells<Mesh, Field> foot_of(mesh, field);
  std::vector<Facet_index> feet(n);
  for (std::size_t i = 0; i < n; ++i) feet[i] = foot_of(cell_of(i));
  const auto foot = [&](std::uint32_t i) { return std::array<Facet_index, 1>{feet[i]}; };
  return Incidence_lists<Facet_index, std::uint32_t>(mesh.number_of_boundary_facets(), n, foot).cells();
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ORDER_BY_FEET_H
