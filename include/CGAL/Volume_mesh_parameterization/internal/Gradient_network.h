// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_GRADIENT_NETWORK_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_GRADIENT_NETWORK_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The weighted graph of a finite-element Laplacian: each cell joins its four nodes node(c, i) by
// k_ij = - factor V grad lambda_i . grad lambda_j. With factor 1 and vertices these are the elements of degree one,
// k_ij = 1/6 l cot theta of the opposite edge (Xia et al. 2010, equation of the weights, with the edge corrected); with
// factor 9 and facets those of Crouzeix and Raviart.
template <typename Mesh, typename Node>
class Gradient_network {
public:
  static constexpr int size_of_element = 4;

  // All cells have a positive volume in double.
  Gradient_network(const Mesh& mesh, double factor, const Node& node)
      : m_mesh(&mesh), m_factor(factor), m_node(node) {}

  std::size_t number_of_elements() const { return m_mesh->number_of_cells(); }

  std::array<std::uint32_t, 4> nodes(std::size_t c) const {
    return {m_node(Cell_index(c), 0), m_node(Cell_index(c), 1), m_node(Cell_index(c), 2), m_node(Cell_index(c), 3)};
  }

  std::array<double, 6> conductances(std::size_t c) const {
    const Cell_gradients cell(*m_mesh, Cell_index(c));
    std::array<double, 6> result;
    for (int k = 0; k < 6; ++k) {
      const auto& e = Mesh::edge_vertices[k];
      result[k] = -m_factor * cell.volume * (cell.gradients[e[0]] * cell.gradients[e[1]]);
    }
    return result;
  }

private:
  const Mesh* m_mesh;
  double m_factor;
  Node m_node;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_GRADIENT_NETWORK_H
