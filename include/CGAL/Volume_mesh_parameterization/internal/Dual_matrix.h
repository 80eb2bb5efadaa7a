// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DUAL_MATRIX_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DUAL_MATRIX_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The Laplacian of the dual graph for the cells as unknowns, with floor and ceiling held: four conductances for each cell.
class Dual_matrix {
public:
  const int size;

  template <typename Mesh>
  Dual_matrix(const Mesh& mesh, const std::vector<double>& volumes)
      : size(int(mesh.number_of_cells())), m_diagonal(Eigen::VectorXd::Zero(size)), m_rows(mesh.number_of_cells()),
        m_pull_of_ceiling(Eigen::VectorXd::Zero(size)) {
    for (Cell_index c : mesh.cells()) m_rows[c].neighbors.fill(c);
    for (Facet_index f : mesh.facets()) {
      const int label = mesh.label(f);
      if (mesh.is_boundary(f) && label != FLOOR && label != CEILING) continue;
      const double conductance = dual_conductance(mesh, f, volumes);
      const Half_facet inner = mesh.half_facet(f);
      m_diagonal[inner.cell] += conductance;
      if (label == CEILING) m_pull_of_ceiling[inner.cell] += conductance;
      if (mesh.is_boundary(f)) continue;
      const Half_facet outer = mesh.half_facet(f, 1);
      m_diagonal[outer.cell] += conductance;
      m_rows[inner.cell].join(inner.index, outer.cell, conductance);
      m_rows[outer.cell].join(outer.index, inner.cell, conductance);
    }
  }

  // the product of row i with a vector
  template <typename Vector>
  double times(int i, const Vector& x) const {
    const Row& row = m_rows[i];
    double sum = m_diagonal[i] * x[i];
    for (int k = 0; k < 4; ++k) sum -= row.conductances[k] * x[row.neighbors[k]];
    return sum;
  }

  // By how much the currents out of each cell fail to vanish.
  Eigen::VectorXd residual(const Eigen::VectorXd& x) const {
    Eigen::VectorXd result = m_pull_of_ceiling;
    for (int i = 0; i < size; ++i) result[i] -= times(i, x);
    return result;
  }

  const Eigen::VectorXd& diagonal() const { return m_diagonal; }

private:
  struct Row {
    std::array<double, 4> conductances = {0, 0, 0, 0};
    std::array<std::uint32_t, 4> neighbors; // the cell itself where there is none

    void join(int k, std::uint32_t neighbor, double conductance) {
      conductances[k] = conductance;
      neighbors[k] = neighbor;
    }
  };

  Eigen::VectorXd m_diagonal;
  std::vector<Row> m_rows; // but for the diagonal, which is needed alone, too
  Eigen::VectorXd m_pull_of_ceiling;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DUAL_MATRIX_H
