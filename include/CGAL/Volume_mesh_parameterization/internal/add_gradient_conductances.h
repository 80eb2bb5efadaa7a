// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ADD_GRADIENT_CONDUCTANCES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ADD_GRADIENT_CONDUCTANCES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>
#include <CGAL/Volume_mesh_parameterization/internal/Dirichlet_problem.h>

#include <string>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

inline Status flat_in_double(Cell_index c) {
  return {ERROR_FLAT_TETRAHEDRON,
          "the volume of tetrahedron " + std::to_string(c) + " is not positive in double"};
}

// adds for each pair of vertices of each cell k_ij = - factor V grad lambda_i . grad lambda_j between the nodes
// node(c, i) and node(c, j). With factor 1 and vertices this is the finite-element Laplacian, k_ij = 1/6 l cot theta
// of the opposite edge (Xia et al. 2010, equation of the weights, with the edge corrected); with factor 9 and facets
// that of Crouzeix and Raviart.
template <typename Mesh, typename Solver, typename Node>
Status add_gradient_conductances(const Mesh& mesh, double factor, const Node& node,
                                 Dirichlet_problem<Solver>& problem) {
  problem.reserve(6 * mesh.number_of_cells());
  for (Cell_index c : mesh.cells()) {
    const Cell_gradients cell(mesh, c);
    if (!(cell.volume > 0)) return flat_in_double(c);
    for (const auto& e : Mesh::edge_vertices)
      problem.add_conductance(node(c, e[0]), node(c, e[1]),
                              -factor * cell.volume * (cell.gradients[e[0]] * cell.gradients[e[1]]));
  }
  return {};
}

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ADD_GRADIENT_CONDUCTANCES_H
