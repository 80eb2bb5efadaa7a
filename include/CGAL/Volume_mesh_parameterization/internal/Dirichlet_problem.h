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
#include <CGAL/Volume_mesh_parameterization/internal/Laplacian.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Matrices of CGAL that wrap one of Eigen: it can be given to them as it is.
template <typename Matrix, typename = void>
struct Wraps_eigen_matrix : std::false_type {};
template <typename Matrix>
struct Wraps_eigen_matrix<Matrix, std::enable_if_t<std::is_same<typename Matrix::EigenType, Laplacian::Matrix>::value>>
    : std::true_type {};

inline bool is_base(int label) { return label == FLOOR || label == CEILING; }

// The norm of the residual divided by that of the sums of the sizes of the currents at each node but those of the bases. From
// the conductances, not from the matrix: it checks the assembly too.
template <typename Network>
double relative_residual(const Network& network, const std::vector<int>& labels, const std::vector<double>& values) {
  std::vector<double> currents(labels.size(), 0), sizes(labels.size(), 0);
  for (std::size_t e = 0; e < network.number_of_elements(); ++e) {
    const auto conductances = network.conductances(e);
    for_each_pair(network, e, [&](int k, std::uint32_t i, std::uint32_t j) {
      const double current = conductances[k] * (values[i] - values[j]);
      currents[i] += current;
      currents[j] -= current;
      sizes[i] += std::abs(current);
      sizes[j] += std::abs(current);
    });
  }
  double squared_residual = 0, squared_size = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (!is_base(labels[i])) {
      squared_residual += currents[i] * currents[i];
      squared_size += sizes[i] * sizes[i];
    }
  return squared_residual == 0 ? 0 : std::sqrt(squared_residual / squared_size);
}

// Laplace's equation on a weighted graph: floor nodes are held at 0, ceiling nodes at 1, and at every other node i
// the sum over its edges of k_ij (x_i - x_j) vanishes. All fields are this problem, on the vertices, the facets or
// the cells of the mesh. See `Laplacian` for what a network is.
//
// Solver is a model of SparseLinearAlgebraWithFactorTraits_d.
template <typename Solver>
class Dirichlet_problem {
public:
  // A larger relative residual means that the solver failed. Where conductances are of very different sizes, as those of needles
  // are, the small currents keep few digits: at 1 to 10,000 about half of those of a double.
  static constexpr double largest_residual = 1e-6;

  // `labels` are FLOOR, CEILING or anything else for the unknown nodes; errors call node i "name i".
  Dirichlet_problem(const char* name, std::vector<int> labels) : m_name(name), m_labels(std::move(labels)) {}

  // returns ERROR_NUMBER_OF_PATCHES (no floor or no ceiling), ERROR_SEVERAL_COMPONENTS or ERROR_CANNOT_SOLVE.
  template <typename Network>
  Status solve(const Network& network) {
    m_values.assign(m_labels.size(), 0);
    for (std::size_t i = 0; i < m_labels.size(); ++i) m_values[i] = m_labels[i] == CEILING;
    Status status = check_bases();
    if (status.ok()) status = check_connection(network);
    if (status.ok()) status = solve_for_unknowns(network);
    if (!status.ok()) return status;
    m_residual = relative_residual(network, m_labels, m_values);
    if (m_residual <= largest_residual) return {};
    std::ostringstream message;
    message << "relative residual " << m_residual;
    return {ERROR_CANNOT_SOLVE, message.str()};
  }

  const std::vector<double>& values() const { return m_values; }
  std::vector<double> take_values() && { return std::move(m_values); }

  // returns what `relative_residual()` says.
  double residual() const { return m_residual; }

private:
  bool is_fixed(std::size_t i) const { return is_base(m_labels[i]); }

  Status check_bases() const {
    for (int base : {FLOOR, CEILING})
      if (std::find(m_labels.begin(), m_labels.end(), base) == m_labels.end())
        return {ERROR_NUMBER_OF_PATCHES, base == FLOOR ? "there is no floor" : "there is no ceiling"};
    return {};
  }

  // The matrix is singular if and only if some nodes are connected to no fixed one.
  template <typename Network>
  Status check_connection(const Network& network) const {
    Disjoint_sets components(m_labels.size());
    for (std::size_t e = 0; e < network.number_of_elements(); ++e) {
      const auto nodes = network.nodes(e);
      for (int k = 1; k < Network::size_of_element; ++k) components.join(nodes[0], nodes[k]);
    }
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
    std::vector<std::uint32_t> number(m_labels.size(), Laplacian::known);
    std::uint32_t n = 0;
    for (std::size_t i = 0; i < m_labels.size(); ++i)
      if (!is_fixed(i)) number[i] = n++;
    return {std::move(number), n};
  }

  // Whether the solver has succeeded is left to the residual: an iteration may miss its tolerance by the last digit.
  template <typename Network>
  Status solve_for_unknowns(const Network& network) {
    const auto [number, n] = number_unknowns();
    if (n == 0) return {};
    Laplacian laplacian(network, number, n, m_values);
    if (laplacian.number_of_entries > Laplacian::greatest_size)
      return {ERROR_CANNOT_SOLVE, "the matrix would have " + std::to_string(laplacian.number_of_entries) + " entries"};
    const typename Solver::Matrix matrix = matrix_of(std::move(laplacian.matrix));
    typename Solver::Vector right(n), solution(n);
    for (std::uint32_t i = 0; i < n; ++i) {
      right[i] = laplacian.right[i];
      solution[i] = 0;
    }
    typename Solver::NT denominator = 1;
    Solver solver;
    if (solver.factor(matrix, denominator)) solver.linear_solver(right, solution);
    for (std::size_t i = 0; i < m_labels.size(); ++i)
      if (!is_fixed(i)) m_values[i] = solution[number[i]] / denominator;
    return {};
  }

  template <typename Matrix = typename Solver::Matrix>
  static Matrix matrix_of(Laplacian::Matrix laplacian) {
    Matrix matrix(int(laplacian.rows()));
    if constexpr (Wraps_eigen_matrix<Matrix>::value)
      matrix.eigen_object() = std::move(laplacian);
    else
      for (int j = 0; j < laplacian.outerSize(); ++j)
        for (Laplacian::Matrix::InnerIterator entry(laplacian, j); entry; ++entry)
          matrix.add_coef(int(entry.row()), j, entry.value());
    return matrix;
  }

  std::string m_name;
  std::vector<int> m_labels;
  std::vector<double> m_values;
  double m_residual = 0;
};

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DIRICHLET_PROBLEM_H
