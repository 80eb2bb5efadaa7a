// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DIRICHLET_PROBLEM_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DIRICHLET_PROBLEM_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Disjoint_sets.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Eigen's solvers for symmetric matrices tell which half they read: then the other one need not be stored.
template <typename Solver, typename = void>
struct Reads_lower_half : std::false_type {};
template <typename Solver>
struct Reads_lower_half<Solver, std::enable_if_t<int(Solver::Solver::UpLo) == int(Eigen::Lower)>>
    : std::true_type {};

// Laplace's equation on a weighted graph: floor nodes are held at 0, ceiling nodes at 1, and at every other node i
// the sum over its edges of k_ij (x_i - x_j) vanishes. All fields are this problem, on the vertices, the facets or
// the cells of the mesh.
//
// Solver is a model of SparseLinearAlgebraWithFactorTraits_d.
template <typename Solver>
class Dirichlet_problem {
public:
  // A larger relative residual means that the solver failed: half of the digits of a double.
  static constexpr double largest_residual = 1e-8;

  // `labels` are FLOOR, CEILING or anything else for the unknown nodes; errors call node i "name i".
  Dirichlet_problem(const char* name, std::vector<int> labels) : m_name(name), m_labels(std::move(labels)) {}

  void reserve(std::size_t number_of_conductances) { m_conductances.reserve(number_of_conductances); }

  // Repeated pairs add up.
  void add_conductance(std::size_t i, std::size_t j, double k) {
    m_conductances.push_back({std::uint32_t(i), std::uint32_t(j), k});
  }

  // returns ERROR_NUMBER_OF_PATCHES (no floor or no ceiling), ERROR_SEVERAL_COMPONENTS or ERROR_CANNOT_SOLVE.
  Status solve(Solver solver = Solver()) {
    m_values.assign(m_labels.size(), 0);
    for (std::size_t i = 0; i < m_labels.size(); ++i) m_values[i] = m_labels[i] == CEILING;
    Status status = check_bases();
    if (status.ok()) status = check_connection();
    if (status.ok()) status = solve_for_unknowns(solver);
    return status;
  }

  const std::vector<double>& values() const { return m_values; }

  // returns the norm of the residual divided by the norm of the right-hand side.
  double residual() const { return m_residual; }

  // returns the share of edges with a negative weight: where there are some, the maximum principle is not assured.
  double share_of_negative_conductances() const {
    std::vector<Conductance> edges = m_conductances;
    for (Conductance& e : edges)
      if (e.i > e.j) std::swap(e.i, e.j);
    std::sort(edges.begin(), edges.end());
    std::size_t negative = 0, all = 0;
    for (auto e = edges.begin(); e != edges.end(); ++all) {
      double k = 0;
      for (const Conductance first = *e; e != edges.end() && e->i == first.i && e->j == first.j; ++e)
        k += e->k;
      negative += k < 0;
    }
    return all == 0 ? 0 : double(negative) / double(all);
  }

private:
  struct Conductance {
    std::uint32_t i, j;
    double k;
    // by weight too, so that sums do not depend on the order of insertion
    bool operator<(const Conductance& e) const { return i != e.i ? i < e.i : j != e.j ? j < e.j : k < e.k; }
  };

  bool is_fixed(std::size_t i) const { return m_labels[i] == FLOOR || m_labels[i] == CEILING; }

  Status check_bases() const {
    for (int base : {FLOOR, CEILING})
      if (std::find(m_labels.begin(), m_labels.end(), base) == m_labels.end())
        return {ERROR_NUMBER_OF_PATCHES, base == FLOOR ? "there is no floor" : "there is no ceiling"};
    return {};
  }

  // The matrix is singular if and only if some nodes are connected to no fixed one.
  Status check_connection() const {
    Disjoint_sets components(m_labels.size());
    for (const Conductance& e : m_conductances) components.join(e.i, e.j);
    std::vector<char> is_held(m_labels.size(), 0);
    for (std::uint32_t i = 0; i < m_labels.size(); ++i)
      if (is_fixed(i)) is_held[components.representative(i)] = 1;
    for (std::uint32_t i = 0; i < m_labels.size(); ++i)
      if (!is_held[components.representative(i)])
        return {ERROR_SEVERAL_COMPONENTS,
                m_name + " " + std::to_string(i) + " is connected to no floor or ceiling"};
    return {};
  }

  // returns the numbers of the unknowns and their count.
  std::pair<std::vector<std::uint32_t>, std::uint32_t> number_unknowns() const {
    std::vector<std::uint32_t> number(m_labels.size());
    std::uint32_t n = 0;
    for (std::size_t i = 0; i < m_labels.size(); ++i) number[i] = is_fixed(i) ? n : n++;
    return {std::move(number), n};
  }

  Status solve_for_unknowns(Solver& solver) {
    const auto [number, n] = number_unknowns();
    m_residual = 0;
    if (n == 0) return {};
    typename Solver::Matrix matrix = symmetric_matrix(n);
    typename Solver::Vector right(n), solution(n);
    for (std::uint32_t i = 0; i < n; ++i) right[i] = solution[i] = 0;
    assemble(number, matrix, right);
    typename Solver::NT denominator = 1;
    // the residual decides: an iteration may miss its tolerance by the last digit
    if (solver.factor(matrix, denominator)) solver.linear_solver(right, solution);
    for (std::size_t i = 0; i < m_labels.size(); ++i)
      if (!is_fixed(i)) m_values[i] = solution[number[i]] / denominator;
    m_residual = compute_residual();
    if (m_residual <= largest_residual) return {};
    return {ERROR_CANNOT_SOLVE, "relative residual " + std::to_string(m_residual)};
  }

  template <typename Matrix = typename Solver::Matrix>
  static Matrix symmetric_matrix(int n) {
    if constexpr (Reads_lower_half<Solver>::value && std::is_constructible<Matrix, int, int, bool>::value)
      return Matrix(n, n, true);
    else
      return Matrix(n);
  }

  // Both halves are offered: one that stores half ignores the upper one.
  template <typename Matrix, typename Vector>
  void assemble(const std::vector<std::uint32_t>& number, Matrix& matrix, Vector& right) const {
    std::vector<double> diagonal(right.dimension(), 0);
    for (const Conductance& e : m_conductances)
      if (!is_fixed(e.i) && !is_fixed(e.j)) {
        matrix.add_coef(number[e.i], number[e.j], -e.k);
        matrix.add_coef(number[e.j], number[e.i], -e.k);
        diagonal[number[e.i]] += e.k;
        diagonal[number[e.j]] += e.k;
      } else if (!is_fixed(e.i) || !is_fixed(e.j)) {
        const auto [unknown, fixed] = is_fixed(e.i) ? std::make_pair(e.j, e.i) : std::make_pair(e.i, e.j);
        diagonal[number[unknown]] += e.k;
        right[number[unknown]] += e.k * m_values[fixed];
      }
    for (std::size_t i = 0; i < diagonal.size(); ++i) matrix.add_coef(i, i, diagonal[i]);
  }

  // From the conductances, not from the matrix: it checks the assembly too.
  double compute_residual() const {
    std::vector<double> currents(m_labels.size(), 0), right(m_labels.size(), 0);
    for (const Conductance& e : m_conductances) {
      const double current = e.k * (m_values[e.i] - m_values[e.j]);
      currents[e.i] += current;
      currents[e.j] -= current;
      if (m_labels[e.i] == CEILING) right[e.j] += e.k;
      if (m_labels[e.j] == CEILING) right[e.i] += e.k;
    }
    double squared_residual = 0, squared_right = 0;
    for (std::size_t i = 0; i < m_labels.size(); ++i)
      if (!is_fixed(i)) {
        squared_residual += currents[i] * currents[i];
        squared_right += right[i] * right[i];
      }
    return squared_residual == 0 ? 0 : std::sqrt(squared_residual / squared_right);
  }

  std::string m_name;
  std::vector<int> m_labels;
  std::vector<Conductance> m_conductances;
  std::vector<double> m_values;
  double m_residual = 0;
};

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DIRICHLET_PROBLEM_H
