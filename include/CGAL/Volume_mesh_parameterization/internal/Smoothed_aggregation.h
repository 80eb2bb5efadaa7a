// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SMOOTHED_AGGREGATION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SMOOTHED_AGGREGATION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Sparse_rows.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A cycle of algebraic multigrid by smoothed aggregation (Vanek, Mandel and Brezina 1996), to precondition conjugate
// gradients: unknowns that are strongly coupled make one of the next coarser level, whose values are spread as constants,
// smoothed by a step of Jacobi's method. On each level a sweep of Gauss and Seidel goes forwards before the coarser levels
// correct, and one backwards after, so the whole is symmetric.
class Smoothed_aggregation {
public:
  using Vector = Eigen::VectorXd;

  // `matrix` is symmetric and positive definite, columns increase in each row; it must outlive the preconditioner.
  explicit Smoothed_aggregation(const Sparse_rows_view& matrix) {
    double least_coupling = least_coupling_of_finest_level;
    m_levels.emplace_back(matrix);
    while (m_levels.back().matrix.size > size_to_factor && add_level(least_coupling)) least_coupling /= 2;
    if (m_levels.back().matrix.size <= size_to_factor) m_factorization.compute(dense(m_levels.back().matrix));
  }

  // The levels refer to their own matrices.
  Smoothed_aggregation(const Smoothed_aggregation&) = delete;
  Smoothed_aggregation& operator=(const Smoothed_aggregation&) = delete;

  // returns an approximate solution of matrix * x = right.
  const Vector& operator()(const Vector& right) { return cycle(0, right); }

private:
  static constexpr int size_to_factor = 200;
  // A coupling weaker than this share of the geometric mean of the two diagonal entries does not count; on coarser levels,
  // whose rows are longer, half of the share of the finer one.
  static constexpr double least_coupling_of_finest_level = 0.08;
  // of Jacobi's method: 4 / 3 of the inverse of the largest eigenvalue, which is at most 2 for positive weights
  static constexpr double damping = 2. / 3;
  // A level of more than this share of the unknowns of the finer one is not worth it.
  static constexpr double largest_share = 0.8;

  struct Level {
    Sparse_rows own; // empty on the finest level
    Sparse_rows_view matrix;
    std::vector<int> diagonal; // the places of the diagonal entries
    Sparse_rows prolongation;
    Vector right, solution;

    explicit Level(const Sparse_rows_view& view) : matrix(view), solution(view.size) {
      diagonal.reserve(std::size_t(view.size));
      for (int i = 0; i < view.size; ++i)
        diagonal.push_back(int(std::lower_bound(view.columns + view.first[i], view.columns + view.first[i + 1], i) -
                               view.columns));
    }
    explicit Level(Sparse_rows&& rows) : Level(rows.view()) {
      own = std::move(rows); // its arrays stay where they are
      right.resize(matrix.size);
    }

    double diagonal_entry(int i) const { return matrix.values[diagonal[std::size_t(i)]]; }

    // calls f(k) for the places k of the couplings of i that count
    template <typename Function>
    void for_each_coupling(int i, double least_coupling, const Function& f) const {
      for (int k = matrix.first[i]; k < matrix.first[i + 1]; ++k) {
        const int j = matrix.columns[k];
        const double least = least_coupling * least_coupling * diagonal_entry(i) * diagonal_entry(j);
        if (j != i && matrix.values[k] * matrix.values[k] > least) f(k);
      }
    }
  };

  static Eigen::MatrixXd dense(const Sparse_rows_view& matrix) {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(matrix.size, matrix.size);
    for (int i = 0; i < matrix.size; ++i)
      for (int k = matrix.first[i]; k < matrix.first[i + 1]; ++k) result(i, matrix.columns[k]) = matrix.values[k];
    return result;
  }

  bool add_level(double least_coupling) {
    Level& fine = m_levels.back();
    int n = 0;
    const std::vector<int> aggregates = aggregate(fine, least_coupling, n);
    if (n > largest_share * fine.matrix.size) return false;
    fine.prolongation = smoothed_prolongation(fine, least_coupling, aggregates, n);
    // a transposition changes no symmetric matrix, but after it the columns are in order
    m_levels.emplace_back(coarse_matrix(fine).transposed());
    return true;
  }

  static Sparse_rows coarse_matrix(const Level& fine) {
    const Sparse_rows image = product(fine.matrix, fine.prolongation), restriction = fine.prolongation.transposed();
    return product(restriction.view(), image);
  }

  // Numbers the n aggregates and returns that of each unknown. An unknown whose neighbors are all free takes them; what is
  // left joins the aggregate of its strongest neighbor; the rest takes the free neighbors that it has.
  static std::vector<int> aggregate(const Level& level, double least_coupling, int& n) {
    const int* columns = level.matrix.columns;
    const int free = -1, size = level.matrix.size;
    std::vector<int> result(std::size_t(size), free);
    const auto take_free_neighbors = [&](int i) {
      result[i] = n;
      level.for_each_coupling(i, least_coupling, [&](int k) {
        if (result[columns[k]] == free) result[columns[k]] = n;
      });
      ++n;
    };
    for (int i = 0; i < size; ++i) {
      bool is_alone = true, are_all_free = result[i] == free;
      level.for_each_coupling(i, least_coupling, [&](int k) {
        is_alone = false;
        are_all_free &= result[columns[k]] == free;
      });
      if (are_all_free && !is_alone) take_free_neighbors(i);
    }
    join_strongest_neighbors(level, least_coupling, result);
    for (int i = 0; i < size; ++i)
      if (result[i] == free) take_free_neighbors(i);
    return result;
  }

  static void join_strongest_neighbors(const Level& level, double least_coupling, std::vector<int>& aggregates) {
    const std::vector<int> given = aggregates;
    for (int i = 0; i < level.matrix.size; ++i) {
      if (given[i] >= 0) continue;
      double strongest = 0;
      level.for_each_coupling(i, least_coupling, [&](int k) {
        const int neighbor = given[level.matrix.columns[k]];
        if (neighbor < 0 || std::abs(level.matrix.values[k]) <= strongest) return;
        strongest = std::abs(level.matrix.values[k]);
        aggregates[i] = neighbor;
      });
    }
  }

  // Couplings that do not count are added to the diagonal, so that constants stay constant.
  static Sparse_rows smoothed_prolongation(const Level& level, double least_coupling, const std::vector<int>& aggregates,
                                           int n) {
    const Sparse_rows_view& a = level.matrix;
    Sparse_rows result(n);
    for (int i = 0; i < a.size; ++i) {
      double sum = 0, sum_of_couplings = 0, size_of_couplings = 0;
      for (int k = a.first[i]; k < a.first[i + 1]; ++k) sum += a.values[k];
      level.for_each_coupling(i, least_coupling, [&](int k) {
        sum_of_couplings += a.values[k];
        size_of_couplings += std::abs(a.values[k]);
      });
      // negative weights could make the first number vanish
      const double diagonal = std::max(sum - sum_of_couplings, size_of_couplings);
      result.add(aggregates[i], 1 - damping);
      level.for_each_coupling(i, least_coupling,
                              [&](int k) { result.add(aggregates[a.columns[k]], -damping * a.values[k] / diagonal); });
      result.end_row();
    }
    result.shrink_to_fit();
    return result;
  }

  const Vector& cycle(std::size_t l, const Vector& right) {
    Level& level = m_levels[l];
    const Sparse_rows_view& a = level.matrix;
    Vector& x = level.solution;
    if (a.size <= size_to_factor) return x = m_factorization.solve(right);
    for (int i = 0; i < a.size; ++i)
      x[i] = (right[i] - a.times(a.first[i], level.diagonal[i], x)) / level.diagonal_entry(i);
    if (l + 1 < m_levels.size()) correct(l);
    for (int i = a.size; i-- > 0;) x[i] += (right[i] - a.times(i, x)) / level.diagonal_entry(i);
    return x;
  }

  // After the sweep forwards the residual is what the entries above the diagonal make of the new values.
  void correct(std::size_t l) {
    Level& level = m_levels[l];
    const Sparse_rows_view &a = level.matrix, prolongation = level.prolongation.view();
    Vector &x = level.solution, &coarse = m_levels[l + 1].right;
    coarse.setZero();
    for (int i = 0; i < a.size; ++i)
      prolongation.add_transposed(i, -a.times(level.diagonal[i] + 1, a.first[i + 1], x), coarse);
    const Vector& correction = cycle(l + 1, coarse);
    for (int i = 0; i < a.size; ++i) x[i] += prolongation.times(i, correction);
  }

  std::deque<Level> m_levels;
  Eigen::LLT<Eigen::MatrixXd> m_factorization; // of the coarsest level, if it is small
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SMOOTHED_AGGREGATION_H
