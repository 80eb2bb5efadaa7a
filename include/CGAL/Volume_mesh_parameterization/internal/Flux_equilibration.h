// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLUX_EQUILIBRATION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLUX_EQUILIBRATION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>
#include <CGAL/Volume_mesh_parameterization/internal/Sparse_rows.h>
#include <CGAL/Volume_mesh_parameterization/internal/Vertex_stars.h>
#include <CGAL/Volume_mesh_parameterization/internal/solve_by_conjugate_gradients.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Makes a conservative flux of a discrete gradient without a global system (Braess and Schöberl 2008). The gradient of the
// solution u of the finite-element equations of degree one jumps across facets, but its residual is orthogonal to the basis
// function phi_v of each unknown vertex v: around v, what phi_v grad u leaves too much in one cell is missing in others.
// There fluxes through the facets at v carry it: those of least energy on the dual graph, as in `Dual_potential_3`. Nothing
// passes through walls, anything through floor and ceiling.
template <typename Mesh>
class Flux_equilibration {
public:
  // `volumes` are those of the cells.
  Flux_equilibration(const Mesh& mesh, const std::vector<double>& volumes)
      : m_mesh(&mesh), m_stars(mesh), m_excess(mesh.number_of_facets(), 0), m_conductances(mesh.number_of_facets(), 0) {
    for (Facet_index f : mesh.facets())
      if (!is_wall(f)) m_conductances[f] = dual_conductance(mesh, f, volumes);
  }

  // returns the fluxes out of the cell of half_facet(f), for each facet; `gradient(c)` is that of u in the cell c.
  template <typename Gradient>
  std::vector<double> fluxes(const Gradient& gradient) {
    std::vector<double> result(m_mesh->number_of_facets(), 0);
    for (Cell_index c : m_mesh->cells()) add_means(c, gradient(c), result);
    for (Vertex_index v : m_mesh->vertices()) equilibrate(v, result);
    return result;
  }

private:
  // More than the residual of the solver makes no difference.
  static constexpr double tolerance = 1e-14;

  bool is_wall(Facet_index f) const {
    return m_mesh->is_boundary(f) && m_mesh->label(f) != FLOOR && m_mesh->label(f) != CEILING;
  }

  // The flux through a facet is the mean of both sides; at each of its corners a third of the difference is too much in one
  // cell and missing in the other, so both have half of the jump too much.
  void add_means(Cell_index c, const Double_kernel::Vector_3& gradient, std::vector<double>& fluxes) {
    const Cell_gradients cell(*m_mesh, c);
    for (int i = 0; i < 4; ++i) {
      const Facet_index f = m_mesh->facet(c, i);
      const double outflow_at_corner = -cell.volume * (cell.gradients[i] * gradient);
      const double share = m_mesh->is_boundary(f) ? 1 : 0.5;
      if (is_wall(f) || !m_mesh->is_boundary(f)) m_excess[f] += share * outflow_at_corner;
      if (!is_wall(f)) fluxes[f] += (m_mesh->half_facet(f).cell == c ? 3 : -3) * share * outflow_at_corner;
    }
  }

  // In the star of v each cell gets a potential, whose differences times the conductances are the fluxes.
  void equilibrate(Vertex_index v, std::vector<double>& fluxes) {
    const auto star = m_stars.cells(v);
    const int n = int(star.size());
    const auto number = [&](Cell_index c) { return int(std::lower_bound(star.begin(), star.end(), c) - star.begin()); };
    Sparse_rows rows(n);
    Eigen::VectorXd excess = Eigen::VectorXd::Zero(n), diagonal = Eigen::VectorXd::Zero(n), potential;
    bool touches_base = false;
    for (int a = 0; a < n; ++a) {
      for_each_side(star[a], v, [&](int i, Facet_index f) {
        excess[a] += m_excess[f];
        diagonal[a] += m_conductances[f];
        if (m_mesh->is_boundary(f))
          touches_base |= !is_wall(f);
        else
          rows.add(number(m_mesh->neighbor(star[a], i)), -m_conductances[f]);
      });
      rows.add(a, diagonal[a]);
      rows.end_row();
    }
    if (!touches_base) excess.array() -= excess.mean(); // which is the residual of the equation of v
    const auto jacobi = [&](const Eigen::VectorXd& r) { return r.cwiseQuotient(diagonal); };
    solve_by_conjugate_gradients(rows.view(), jacobi, excess, tolerance, 10 * n, potential);
    for (int a = 0; a < n; ++a)
      for_each_side(star[a], v, [&](int i, Facet_index f) {
        if (m_mesh->half_facet(f).cell != star[a]) return;
        const double beyond = m_mesh->is_boundary(f) ? 0 : potential[number(m_mesh->neighbor(star[a], i))];
        fluxes[f] += m_conductances[f] * (potential[a] - beyond);
      });
  }

  // calls f(i, facet) for the three facets of c that contain v
  template <typename Function>
  void for_each_side(Cell_index c, Vertex_index v, const Function& f) const {
    for (int i = 0; i < 4; ++i)
      if (m_mesh->vertex(c, i) != v) f(i, m_mesh->facet(c, i));
  }

  const Mesh* m_mesh;
  Vertex_stars m_stars;
  std::vector<double> m_excess;       // at each corner of a facet, of each of its cells
  std::vector<double> m_conductances; // 0 for walls
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLUX_EQUILIBRATION_H
