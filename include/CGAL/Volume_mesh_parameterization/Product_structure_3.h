// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PRODUCT_STRUCTURE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PRODUCT_STRUCTURE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Sweep.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationStructure

is the certificate that a solid is the product of its floor with an interval: an order in which a front sweeps all
cells from the floor to the ceiling.

Each non-wall facet of a cell is then an *entry* or an *exit* facet of that cell, and what is an exit facet for one
cell is an entry facet for the other. A curve that in each cell goes from the entry facets to the exit facets, along
barycentric rates that are positive opposite entry facets, negative opposite exit facets and zero opposite wall
facets, can neither stop, nor return, nor leave through a wall.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Product_structure_3 {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>; ///< the mesh that is swept

  Product_structure_3() = default;

  /// takes an order of the cells of `mesh`; whether it is that of a sweep is not checked here: see `verify_product()`.
  /// \pre `order` names each cell once, every facet of the boundary has a label
  Product_structure_3(const Mesh& mesh, std::vector<Cell_index> order)
      : m_order(std::move(order)), m_positions(m_order.size()), m_signs(m_order.size()) {
    for (std::size_t k = 0; k < m_order.size(); ++k) m_positions[m_order[k]] = static_cast<std::uint32_t>(k);
    for (Cell_index c : mesh.cells())
      for (int i = 0; i < 4; ++i) m_signs[c][i] = sign_of(mesh, {c, i});
  }

  /// returns the cells from the floor to the ceiling.
  const std::vector<Cell_index>& order() const { return m_order; }

  /// returns the place of `c` in the order.
  std::size_t position(Cell_index c) const { return m_positions[c]; }

  /// returns for each facet of a cell +1 if it is an entry facet, -1 if it is an exit facet, 0 if it is on a wall.
  const std::array<std::int8_t, 4>& signs(Cell_index c) const { return m_signs[c]; }

private:
  std::int8_t sign_of(const Mesh& mesh, Half_facet h) const {
    const int label = mesh.label(h.cell, h.index);
    if (label >= FIRST_WALL) return 0;
    if (label != INTERIOR) return label == FLOOR ? 1 : -1;
    return m_positions[mesh.neighbor(h.cell, h.index)] < m_positions[h.cell] ? 1 : -1;
  }

  std::vector<Cell_index> m_order;
  std::vector<std::uint32_t> m_positions;
  std::vector<std::array<std::int8_t, 4>> m_signs;
};

/*!
\ingroup PkgVolumeMeshParameterizationStructure

sweeps the cells of `mesh` from the floor. See `sweep_with_repairs()` for what to do if that stops.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param mesh a mesh with a legal partition, prepared by `prepare_patches()`
\param guide the order to prefer: see `Dual_potential_3` for its potential and `Flux_field_3` for its signs
\param[out] structure the result; unchanged on failure
\returns `ERROR_SWEEP_STOPPED` with the number of cells that are left and one of them

Complexity: \f$ O(n \log n) \f$.
*/
template <typename GeomTraits>
Status sweep(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh, const Sweep_guide_3& guide,
             Product_structure_3<GeomTraits>& structure) {
  const internal::Edge_numbering edges(mesh);
  internal::Sweep<GeomTraits> front(mesh, edges, FLOOR);
  front.run(guide);
  if (front.is_complete()) {
    structure = {mesh, front.order()};
    return {};
  }
  const auto cells = mesh.cells();
  const auto left = std::find_if(cells.begin(), cells.end(), [&](Cell_index c) { return !front.is_swept(c); });
  return {ERROR_SWEEP_STOPPED, std::to_string(cells.size() - front.order().size()) +
                                   " tetrahedra are left, among them " + std::to_string(*left)};
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PRODUCT_STRUCTURE_3_H
