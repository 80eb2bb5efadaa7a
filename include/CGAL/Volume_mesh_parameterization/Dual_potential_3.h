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
#include <CGAL/Volume_mesh_parameterization/internal/Dual_matrix.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>
#include <CGAL/Volume_mesh_parameterization/internal/solve_by_conjugate_gradients.h>

#include <CGAL/tags.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationFields

is a harmonic function on the dual graph: one value per cell, weights area / (sum of the distances of the two
centroids to the facet), 0 behind the floor, 1 behind the ceiling.

As all weights are positive, every value of `solve()` lies between the values of its neighbors: no cell is a local extremum.
It approximates the harmonic function only roughly, but it is the best guide of the sweep; `approximate()` guides as well.

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
    Status status = internal::compute_volumes(*m_mesh, volumes);
    if (!status.ok()) return status;
    internal::Dirichlet_problem<Solver> problem("tetrahedron", label_nodes());
    status = problem.solve(Network{*this, volumes, crossed_facets()});
    if (!status.ok()) return status;
    m_residual = problem.residual();
    m_values = std::move(problem).take_values();
    m_values.resize(m_mesh->number_of_cells());
    return {};
  }

  /*!
  computes values that are locally as good: the means of a function over the cells, corrected by some steps of the method of
  conjugate gradients. What is left of the error varies slowly. So cells that are near each other come in the right order,
  which is what a sweep needs, in a fraction of the time and of the memory of `solve()`.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it
  \param values of the function at the vertices, best of a `Harmonic_function_3` of the same mesh

  \returns `ERROR_FLAT_TETRAHEDRON`; `ERROR_CANNOT_SOLVE` if coordinates are so large or small that a number overflows

  Complexity: linear.
  */
  template <typename ConcurrencyTag = Sequential_tag>
  Status approximate(const std::vector<double>& values) {
    std::vector<double> volumes;
    const Status status = internal::compute_volumes(*m_mesh, volumes);
    if (!status.ok()) return status;
    m_values.assign(m_mesh->number_of_cells() + 2, 0);
    m_values[ceiling_node()] = 1;
    for (Cell_index c : m_mesh->cells()) m_values[c] = mean_over_cell(c, values);
    correct_values<internal::Concurrency_for<ConcurrencyTag, typename Mesh::FT>>(volumes);
    m_residual = internal::relative_residual(Network{*this, volumes, crossed_facets()}, label_nodes(), m_values);
    m_values.resize(m_mesh->number_of_cells());
    if (!std::isfinite(m_residual)) return {ERROR_CANNOT_SOLVE, "the dual graph has conductances beyond those of a double"};
    return {};
  }

  /// returns the value in a cell.
  double operator()(Cell_index c) const { return m_values[c]; }

  /// returns the values, one for each cell.
  const std::vector<double>& values() const { return m_values; }

  /// returns the norm of the residual divided by that of the sums of the sizes of its terms.
  double residual() const { return m_residual; }

private:
  double mean_over_cell(Cell_index c, const std::vector<double>& values) const {
    double sum = 0;
    for (Vertex_index v : m_mesh->cell(c)) sum += values[v];
    return sum / 4;
  }

  // Apart from what calls it, so that the matrix is gone before the residual takes memory.
  template <typename ConcurrencyTag>
  void correct_values(const std::vector<double>& volumes) {
    constexpr int steps = 40; // as few sweeps stop as along the solution; with 20, some more
    constexpr double tolerance = 1e-10;
    const internal::Dual_matrix matrix(*m_mesh, volumes);
    Eigen::Map<Eigen::VectorXd> x(m_values.data(), matrix.size);
    Eigen::VectorXd correction, quotients;
    const auto precondition = [&](const Eigen::VectorXd& y) -> const Eigen::VectorXd& {
      return quotients = y.cwiseQuotient(matrix.diagonal());
    };
    internal::solve_by_conjugate_gradients<ConcurrencyTag>(matrix, precondition, matrix.residual(x), tolerance, steps,
                                                           correction);
    x += correction;
  }

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

  // Walls conduct nothing.
  std::vector<Facet_index> crossed_facets() const {
    std::vector<Facet_index> result;
    for (Facet_index f : m_mesh->facets()) {
      const int label = m_mesh->label(f);
      if (!m_mesh->is_boundary(f) || label == FLOOR || label == CEILING) result.push_back(f);
    }
    return result;
  }

  // Each facet joins its two cells, or its cell and the node of its base.
  struct Network {
    static constexpr int size_of_element = 2;

    const Dual_potential_3& potential;
    const std::vector<double>& volumes;
    std::vector<Facet_index> facets;

    std::size_t number_of_elements() const { return facets.size(); }

    std::array<std::uint32_t, 2> nodes(std::size_t e) const {
      const Mesh& mesh = *potential.m_mesh;
      const Facet_index f = facets[e];
      return {mesh.half_facet(f).cell,
              mesh.is_boundary(f) ? std::uint32_t(potential.base_node(f)) : mesh.half_facet(f, 1).cell};
    }

    std::array<double, 1> conductances(std::size_t e) const {
      return {internal::dual_conductance(*potential.m_mesh, facets[e], volumes)};
    }
  };

  const Mesh* m_mesh;
  std::vector<double> m_values;
  double m_residual = 0;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DUAL_POTENTIAL_3_H
