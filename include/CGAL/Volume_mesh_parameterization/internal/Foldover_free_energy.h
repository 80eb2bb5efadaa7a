// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FOLDOVER_FREE_ENERGY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FOLDOVER_FREE_ENERGY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/model_tetrahedra.h>

#include <Eigen/Dense>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
The energy of V. Garanzha, I. Kaporin, L. Kudryavtseva, F. Protais, N. Ray, D. Sokolov, Foldover-free maps in 50 lines of
code, 2021: for each tetrahedron with Jacobian J of determinant D, eq. (3) to (5),

    tr(J^T J) / chi^(2/3) + lambda (D^2 + 1) / chi,    chi = (D + sqrt(epsilon^2 + D^2)) / 2.

It is finite for flipped tetrahedra; as epsilon tends to 0 they become infinitely bad. With epsilon = 0, which it always is for
some, the guards, positive ones stay positive.
*/
class Foldover_free_energy {
public:
  using Cell = Vertex_quadruple;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // Bit k is set if coordinate k of a vertex may change.
  using Freedom = std::uint8_t;
  static constexpr Freedom fixed = 0, free = 7;

  // guards: positive; positions: of all vertices; they change
  Foldover_free_energy(std::vector<Cell> cells, const std::vector<Cell>& guards,
                       const std::vector<Eigen::Vector3d>& rest, const std::vector<Freedom>& freedoms,
                       std::vector<Eigen::Vector3d>& positions, Model_shape shape)
      : m_cells(std::move(cells)),
        m_first_guard(m_cells.size()),
        m_positions(positions),
        m_unknowns(positions.size()) {
    m_cells.insert(m_cells.end(), guards.begin(), guards.end());
    for (std::size_t v = 0; v < positions.size(); ++v)
      for (int k = 0; k < 3; ++k)
        m_unknowns[v][k] = (freedoms[v] >> k & 1) != 0 ? m_number_of_unknowns++ : no_unknown;
    for (const Eigen::Matrix3d& edges : model_tetrahedra(m_cells, rest, m_positions, shape))
      m_inverse_models.push_back(edges.inverse());
  }

  std::size_t number_of_unknowns() const { return m_number_of_unknowns; }
  // Newton steps so far, each that is solved for by iterations counted ten times.
  std::size_t number_of_steps() const { return number_of_unknowns() <= most_direct ? m_steps : 10 * m_steps; }

  // Lessens the energy while epsilon falls, until all determinants are positive, or most_rounds are over or some in a row were
  // idle. In the paper, eq. (8), epsilon falls by a tenth at least; for small parts three tenths are as safe and far quicker.
  // Ends at the positions with the fewest negative determinants: once epsilon is small, a tetrahedron that cannot be made
  // positive outweighs all others and turns them over. Returns whether all are positive.
  bool untangle(double epsilon, int most_rounds) {
    constexpr int steps_per_round = 5, most_idle_rounds = 8;
    constexpr double least_gain = 1e-4, least_fall = 0.3;
    std::size_t fewest = count_negative();
    std::vector<Eigen::Vector3d> best = m_positions;
    for (int round = 0, idle = 0; round < most_rounds && fewest > 0 && idle < most_idle_rounds; ++round) {
      m_epsilon = epsilon;
      const double before = value();
      const double gain = (std::max)(1 - minimize(steps_per_round, least_gain) / before, least_fall);
      const double least = least_determinant(), root = std::hypot(least, epsilon);
      epsilon *= least >= 0 ? 1 - gain : 1 - gain * root / (std::abs(least) + root);
      const std::size_t negative = count_negative();
      idle = negative < fewest ? 0 : idle + 1;
      if (negative >= fewest) continue;
      fewest = negative;
      best = m_positions;
    }
    m_positions = best;
    return fewest == 0;
  }

  // Lessens the energy of positive tetrahedra, which stay positive.
  void polish(int most_steps) { relax(0, most_steps); }

  // Lessens the energy with the same epsilon: the bigger it is, the more tetrahedra may turn over where that relieves others.
  void relax(double epsilon, int most_steps) {
    constexpr double least_gain = 1e-3;
    m_epsilon = epsilon;
    minimize(most_steps, least_gain);
  }

  // The energy of one cell: 3.2 for one that is only moved and turned.
  double value(std::size_t c) const { return State(*this, c).value(); }

  double value() const {
    double sum = 0;
    for (std::size_t c = 0; c < m_cells.size(); ++c) sum += value(c);
    return sum;
  }

private:
  using Unknowns = std::array<std::uint32_t, 3>;

  static constexpr std::uint32_t no_unknown = std::uint32_t(-1);
  static constexpr std::size_t most_direct = 10000; // unknowns for a direct solver
  static constexpr double lambda = 0.1;             // weight of volumes against angles

  // The Jacobian of a cell and what the energy is made of.
  struct State {
    State(const Foldover_free_energy& energy, std::size_t c)
        : jacobian(edges_from_first(energy.m_cells[c], energy.m_positions) * energy.m_inverse_models[c]) {
      const Eigen::Matrix3d& j = jacobian;
      cofactors << j.col(1).cross(j.col(2)), j.col(2).cross(j.col(0)), j.col(0).cross(j.col(1));
      determinant = j.col(0).dot(cofactors.col(0));
      const double e = c < energy.m_first_guard ? energy.m_epsilon : 0,
                   root = std::sqrt(e * e + determinant * determinant);
      chi = determinant > 0 ? (determinant + root) / 2
                            : e * e / (2 * (root - determinant)); // stable for both signs
      slope = chi / root;
    }

    double value() const {
      if (!(chi > 0)) return infinity;
      return jacobian.squaredNorm() * std::pow(chi, -2. / 3) + lambda * (determinant * determinant + 1) / chi;
    }

    Eigen::Matrix3d jacobian, cofactors;
    double determinant, chi, slope; // of chi as a function of the determinant
  };

  /*
  Newton's method. The Hessian is that of f(J, D, chi) as a function of three independent variables, which is convex, with D
  and chi linear in J: so it is positive.
  */
  double minimize(int most_steps, double least_gain) {
    double current = value();
    for (int i = 0; i < most_steps; ++i) {
      ++m_steps;
      Eigen::VectorXd gradient, direction;
      find_direction(gradient, direction);
      const double next = descend(gradient.dot(direction), direction, current);
      const double gain = current - next;
      current = next;
      if (!(gain > least_gain * current)) break;
    }
    return current;
  }

  void find_direction(Eigen::VectorXd& gradient, Eigen::VectorXd& direction) {
    const Eigen::Index n = Eigen::Index(number_of_unknowns());
    gradient = Eigen::VectorXd::Zero(n);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(78 * m_cells.size()); // in the lower half of a matrix of 12 rows
    for (std::size_t c = 0; c < m_cells.size(); ++c) add_cell(c, gradient, entries);
    Eigen::SparseMatrix<double> hessian(n, n);
    hessian.setFromTriplets(entries.begin(), entries.end());
    if (number_of_unknowns() <= most_direct && solve_directly(hessian, gradient, direction)) return;
    constexpr double tolerance = 1e-3;
    constexpr int most_iterations = 200; // any number gives a way down
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower> solver;
    solver.setTolerance(tolerance);
    solver.setMaxIterations(most_iterations);
    direction = solver.compute(hessian).solve(-gradient);
  }

  bool solve_directly(const Eigen::SparseMatrix<double>& hessian, const Eigen::VectorXd& gradient,
                      Eigen::VectorXd& direction) {
    if (!m_is_analyzed) m_solver.analyzePattern(hessian);
    m_is_analyzed = true;
    m_solver.factorize(hessian);
    if (m_solver.info() != Eigen::Success) return false;
    direction = m_solver.solve(-gradient);
    return gradient.dot(direction) < 0;
  }

  // Moves the free vertices to less energy; returns it.
  double descend(double slope, const Eigen::VectorXd& direction, double current) {
    constexpr double sufficient = 1e-4, least_step = 1e-6;
    const std::vector<Eigen::Vector3d> start = m_positions;
    for (double s = 1; s > least_step && slope < 0; s /= 2) {
      for (std::size_t v = 0; v < m_unknowns.size(); ++v)
        for (int k = 0; k < 3; ++k)
          if (m_unknowns[v][k] != no_unknown)
            m_positions[v][k] = start[v][k] + s * direction[m_unknowns[v][k]];
      const double next = value();
      if (next <= current + sufficient * s * slope) return next;
    }
    m_positions = start;
    return current;
  }

  double least_determinant() const {
    double least = infinity;
    for (std::size_t c = 0; c < m_cells.size(); ++c) least = (std::min)(least, determinant(c));
    return least;
  }

  double determinant(std::size_t c) const {
    return (edges_from_first(m_cells[c], m_positions) * m_inverse_models[c]).determinant();
  }

  std::size_t count_negative() const {
    std::size_t n = 0;
    for (std::size_t c = 0; c < m_cells.size(); ++c) n += !(determinant(c) > 0);
    return n;
  }

  void add_cell(std::size_t c, Eigen::VectorXd& gradient,
                std::vector<Eigen::Triplet<double>>& entries) const {
    const State state(*this, c);
    const double chi = state.chi, slope = state.slope, d = state.determinant, share = std::pow(chi, -2. / 3);
    const double angles = state.jacobian.squaredNorm() * share, volumes = (d * d + 1) / chi;
    const double by_determinant = (lambda * (2 * d - volumes * slope) - 2. / 3 * angles * slope) / chi;
    const double mixed = -4. / 3 * share * slope / chi;
    const double twice = (10. / 9 * angles * slope * slope +
                          lambda * (2 * chi - 4 * d * slope + 2 * volumes * slope * slope)) /
                         (chi * chi);
    Eigen::Matrix<double, 3, 4> gradients; // of the barycentric coordinates
    gradients.rightCols<3>() = m_inverse_models[c].transpose();
    gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
    const Eigen::Matrix<double, 3, 4> jg = state.jacobian * gradients, cg = state.cofactors * gradients;
    for (int k = 0; k < 4; ++k) {
      const Unknowns& rows = m_unknowns[m_cells[c][k]];
      const Eigen::Vector3d slopes = 2 * share * jg.col(k) + by_determinant * cg.col(k);
      for (int i = 0; i < 3; ++i)
        if (rows[i] != no_unknown) gradient[rows[i]] += slopes[i];
      for (int l = 0; l < 4; ++l) {
        const Eigen::Matrix3d block =
            2 * share * gradients.col(k).dot(gradients.col(l)) * Eigen::Matrix3d::Identity() +
            mixed * (jg.col(k) * cg.col(l).transpose() + cg.col(k) * jg.col(l).transpose()) +
            twice * cg.col(k) * cg.col(l).transpose();
        add_block(rows, m_unknowns[m_cells[c][l]], block, entries);
      }
    }
  }

  // The lower half, which is all that the solvers read.
  static void add_block(const Unknowns& rows, const Unknowns& columns, const Eigen::Matrix3d& block,
                        std::vector<Eigen::Triplet<double>>& entries) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (rows[i] != no_unknown && columns[j] <= rows[i])
          entries.emplace_back(rows[i], columns[j], block(i, j));
  }

  std::vector<Cell> m_cells;
  std::size_t m_first_guard;
  std::vector<Eigen::Vector3d>& m_positions;
  std::vector<Unknowns> m_unknowns; // of the vertices
  std::uint32_t m_number_of_unknowns = 0;
  std::vector<Eigen::Matrix3d> m_inverse_models;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_solver;
  bool m_is_analyzed = false;
  double m_epsilon = 1;
  std::size_t m_steps = 0;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FOLDOVER_FREE_ENERGY_H
