// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_HARMONIC_FUNCTION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_HARMONIC_FUNCTION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Default_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>
#include <CGAL/Volume_mesh_parameterization/internal/Dirichlet_problem.h>
#include <CGAL/Volume_mesh_parameterization/internal/Gradient_network.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationFields

is the harmonic function that is 0 on the floor, 1 on the ceiling and has no flux through the walls: continuous,
linear in each cell, one value per vertex (step 2 of Xia et al. 2010).

\tparam Mesh a `Compact_tetrahedral_mesh_3`; it must outlive the function
\tparam Solver a model of `SparseLinearAlgebraWithFactorTraits_d`
*/
template <typename Mesh, typename Solver = Default_solver_traits_3>
class Harmonic_function_3 {
public:
  using Vector_3 = Simple_cartesian<double>::Vector_3; ///< a vector of doubles

  /// is how far a value may leave [0, 1] by the rounding errors of the solver alone.
  static constexpr double solver_noise = 1e-12;

  /// keeps a reference to the mesh.
  explicit Harmonic_function_3(const Mesh& mesh) : m_mesh(&mesh) {}

  /// computes the values.
  /// \returns `ERROR_FLAT_TETRAHEDRON`, `ERROR_FLOOR_MEETS_CEILING`, `ERROR_NUMBER_OF_PATCHES` (no floor or no
  /// ceiling), `ERROR_SEVERAL_COMPONENTS` or `ERROR_CANNOT_SOLVE`
  Status solve() {
    std::vector<int> labels;
    std::vector<double> volumes;
    Status status = label_vertices(labels);
    if (status.ok()) status = internal::compute_volumes(*m_mesh, volumes);
    if (!status.ok()) return status;
    internal::Dirichlet_problem<Solver> problem("vertex", std::move(labels));
    status = problem.solve(network());
    if (!status.ok()) return status;
    m_residual = problem.residual();
    m_values = std::move(problem).take_values();
    return {};
  }

  /// returns the value at a vertex.
  double operator()(Vertex_index v) const { return m_values[v]; }

  /// returns the values, one for each vertex.
  const std::vector<double>& values() const { return m_values; }

  /// returns the gradient in `c` (step 3 of the paper, with the factor 1 / 3V).
  Vector_3 gradient(Cell_index c) const {
    const auto& v = m_mesh->cell(c);
    return internal::Cell_gradients(*m_mesh, c)
        .interpolate({m_values[v[0]], m_values[v[1]], m_values[v[2]], m_values[v[3]]});
  }

  /// returns the norm of the residual divided by that of the sums of the sizes of its terms.
  double residual() const { return m_residual; }

  /// returns the vertices with a value outside of [0, 1], which negative weights make possible.
  std::vector<Vertex_index> maximum_principle_violations() const {
    std::vector<Vertex_index> result;
    for (Vertex_index v : m_mesh->vertices())
      if (m_values[v] < -solver_noise || m_values[v] > 1 + solver_noise) result.push_back(v);
    return result;
  }

  /// returns the share of edges with a negative weight, in \f$ O(n \log n) \f$: where there are some, the maximum
  /// principle is not assured.
  /// \pre all cells are positive in double, as they are when `solve()` succeeded
  double share_of_negative_weights() const {
    std::vector<std::uint32_t> rows(m_mesh->number_of_vertices());
    std::iota(rows.begin(), rows.end(), 0);
    const internal::Laplacian laplacian(network(), rows, rows.size(), {});
    const auto& matrix = laplacian.matrix;
    std::size_t negative = 0, all = 0; // entries off the diagonal are the weights, with the opposite sign
    for (int i = 0; i < matrix.outerSize(); ++i)
      for (internal::Laplacian::Matrix::InnerIterator entry(matrix, i); entry; ++entry) {
        all += entry.row() != i;
        negative += entry.row() != i && entry.value() > 0;
      }
    return all == 0 ? 0 : double(negative) / double(all);
  }

private:
  Status label_vertices(std::vector<int>& labels) const {
    labels.assign(m_mesh->number_of_vertices(), INTERIOR);
    for (Facet_index f : m_mesh->boundary_facets()) {
      const int base = m_mesh->label(f);
      if (base != FLOOR && base != CEILING) continue;
      for (Vertex_index v : m_mesh->vertices(f)) {
        if (labels[v] != INTERIOR && labels[v] != base)
          return {ERROR_FLOOR_MEETS_CEILING, "vertex " + std::to_string(v)};
        labels[v] = base;
      }
    }
    return {};
  }

  auto network() const {
    const auto vertex = [this](Cell_index c, int i) { return m_mesh->vertex(c, i); };
    return internal::Gradient_network<Mesh, decltype(vertex)>(*m_mesh, 1, vertex);
  }

  const Mesh* m_mesh;
  std::vector<double> m_values;
  double m_residual = 0;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_HARMONIC_FUNCTION_3_H
