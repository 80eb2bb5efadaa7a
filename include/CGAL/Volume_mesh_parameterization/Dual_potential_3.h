// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DUAL_POTENTIAL_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DUAL_POTENTIAL_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Default_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>
#include <CGAL/Volume_mesh_parameterization/internal/Dirichlet_problem.h>
#include <CGAL/Volume_mesh_parameterization/internal/add_gradient_conductances.h>

#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationFields

is a harmonic function on the dual graph: one value per cell, weights area / (sum of the distances of the two
centroids to the facet), 0 behind the floor, 1 behind the ceiling.

As all weights are positive, every value lies between the values of its neighbors: no cell is a local extremum. It
approximates the harmonic function only roughly, but it is the best guide of the sweep.

\tparam Mesh a `Compact_tetrahedral_mesh_3`; it must outlive the potential
\tparam Solver a model of `SparseLinearAlgebraWithFactorTraits_d`
*/
template <typename Mesh, typename Solver = Default_solver_traits_3>
class Dual_potential_3 {
public:
  /// keeps a reference to the mesh.
  explicit Dual_potential_3(const Mesh& mesh) : m_mesh(&mesh) {}

  /// computes the values.
  /// \returns `ERROR_FLAT_TETRAHEDRON`, `ERROR_NUMBER_OF_PATCHES` (no floor or no ceiling),
  /// `ERROR_SEVERAL_COMPONENTS` or `ERROR_CANNOT_SOLVE`
  Status solve() {
    std::vector<double> volumes;
    Status status = compute_volumes(volumes);
    if (!status.ok()) return status;
    internal::Dirichlet_problem<Solver> problem("tetrahedron", label_nodes());
    add_conductances(volumes, problem);
    status = problem.solve();
    if (!status.ok()) return status;
    m_values.assign(problem.values().begin(), problem.values().begin() + m_mesh->number_of_cells());
    m_residual = problem.residual();
    return {};
  }

  /// returns the value in a cell.
  double operator()(Cell_index c) const { return m_values[c]; }

  /// returns the values, one for each cell.
  const std::vector<double>& values() const { return m_values; }

  /// returns the norm of the residual divided by the norm of the right-hand side.
  double residual() const { return m_residual; }

private:
  std::size_t floor_node() const { return m_mesh->number_of_cells(); }
  std::size_t ceiling_node() const { return m_mesh->number_of_cells() + 1; }

  // A base without facets gets no node, so that its absence is noticed.
  std::vector<int> label_nodes() const {
    std::vector<int> labels(m_mesh->number_of_cells() + 2, INTERIOR);
    for (Facet_index f : m_mesh->boundary_facets())
      if (m_mesh->label(f) == FLOOR || m_mesh->label(f) == CEILING) labels[base_node(f)] = m_mesh->label(f);
    return labels;
  }

  std::size_t base_node(Facet_index f) const {
    return m_mesh->label(f) == FLOOR ? floor_node() : ceiling_node();
  }

  Status compute_volumes(std::vector<double>& volumes) const {
    for (Cell_index c : m_mesh->cells()) {
      volumes.push_back(internal::Cell_gradients(*m_mesh, c).volume);
      if (!(volumes.back() > 0)) return internal::flat_in_double(c);
    }
    return {};
  }

  // The centroid of a cell of volume V lies 3V / 4A away from a facet of area A.
  void add_conductances(const std::vector<double>& volumes,
                        internal::Dirichlet_problem<Solver>& problem) const {
    problem.reserve(m_mesh->number_of_facets());
    for (Facet_index f : m_mesh->facets()) {
      const int label = m_mesh->label(f);
      if (m_mesh->is_boundary(f) && label != FLOOR && label != CEILING) continue;
      const Cell_index c = m_mesh->half_facet(f).cell;
      const Cell_index d = m_mesh->is_boundary(f) ? Cell_index() : m_mesh->half_facet(f, 1).cell;
      const double volume = volumes[c] + (d.is_valid() ? volumes[d] : 0);
      problem.add_conductance(c, d.is_valid() ? d : base_node(f),
                              internal::squared_area(*m_mesh, f) / (0.75 * volume));
    }
  }

  const Mesh* m_mesh;
  std::vector<double> m_values;
  double m_residual = 0;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DUAL_POTENTIAL_3_H
