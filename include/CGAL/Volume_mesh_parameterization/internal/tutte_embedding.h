// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TUTTE_EMBEDDING_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TUTTE_EMBEDDING_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/SparseLU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Positive weights of the half-edges of triangles, half-edge 3 t + i being that from corner i to corner i + 1.
struct Mean_value_weights {
  const std::vector<Double_kernel::Point_3>& points;

  // M. S. Floater, Mean value coordinates, 2003, eq. (1.1): the share of the triangle (v, w, u) in the weights of the
  // edges from v is tan(angle at v / 2) over the length of the edge.
  std::array<double, 2> operator()(std::uint32_t v, std::uint32_t w, std::uint32_t u) const {
    const Double_kernel::Vector_3 a = points[w] - points[v], b = points[u] - points[v];
    const double la = std::sqrt(a * a), lb = std::sqrt(b * b);
    const Double_kernel::Vector_3 c = CGAL::cross_product(a, b);
    const double tangent = std::sqrt(c * c) / (la * lb + a * b);
    // any positive weights give an embedding; those of needles would only spoil the condition of the matrix
    constexpr double least = 1e-3, greatest = 1e3;
    const double t = std::min(std::max(tangent, least), greatest);
    return {t / la, t / lb};
  }
};

struct Uniform_weights {
  std::array<double, 2> operator()(std::uint32_t, std::uint32_t, std::uint32_t) const { return {1, 1}; }
};

// Weights that pull less towards where an embedding compresses the surface (S. Yoshizawa, A. Belyaev, H.-P. Seidel, A fast
// and simple stretch-minimizing mesh parameterization, 2004): embedded anew with them, such parts grow.
class Stretch_weights {
public:
  explicit Stretch_weights(std::size_t number_of_vertices) : m_pull(number_of_vertices, 1) {}

  std::array<double, 2> operator()(std::uint32_t, std::uint32_t w, std::uint32_t u) const {
    return {m_pull[w], m_pull[u]};
  }

  // Divides the pull of each vertex by the stretch around it: the root of the area of its triangles in space over that of
  // their images, which is area(k) for triangle k.
  template <typename Area>
  void adapt(const std::vector<std::array<std::uint32_t, 3>>& triangles,
             const std::vector<Double_kernel::Point_3>& points, const Area& area) {
    constexpr double greatest = 10; // of the change at once
    std::vector<double> given(m_pull.size(), 0), embedded(m_pull.size(), 0);
    double all_given = 0, all_embedded = 0;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const auto& t = triangles[k];
      const double a = std::sqrt(CGAL::squared_area(points[t[0]], points[t[1]], points[t[2]])),
                   b = std::max(0., area(k));
      all_given += a;
      all_embedded += b;
      for (std::uint32_t v : t) {
        given[v] += a;
        embedded[v] += b;
      }
    }
    for (std::size_t v = 0; v < m_pull.size(); ++v) {
      const double stretch = std::sqrt(given[v] / all_given / (embedded[v] / all_embedded));
      m_pull[v] /= std::min(greatest, std::max(1 / greatest, stretch)); // in this order 0 / 0 does no harm
    }
  }

private:
  std::vector<double> m_pull;
};

/*
Moves every vertex that is not fixed to the weighted mean of its neighbors (W. T. Tutte, How to draw a graph, 1963;
M. S. Floater, One-to-one piecewise linear mappings over triangulations, 2003). weights(v, w, u) are the shares of a
triangle in the weights of its edges vw and vu. Positions are points of the plane or of space: what is fixed around a piece
of surface in a plane of space keeps it there, up to rounding.
*/
template <typename Weights, typename Point>
Status tutte_embedding(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                       const std::vector<char>& is_fixed, const Weights& weights, std::vector<Point>& positions) {
  constexpr int dimension = Point::Ambient_dimension::value;
  using Solver = Eigen_solver_traits<Eigen::SparseLU<Eigen_sparse_matrix<double>::EigenType>>;
  std::vector<std::size_t> row(positions.size());
  std::size_t n = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) row[v] = is_fixed[v] ? std::size_t(-1) : n++;
  if (n == 0) return {};
  typename Solver::Matrix matrix(n, n);
  std::vector<typename Solver::Vector> right(dimension, typename Solver::Vector(n)), x(right);
  for (auto& b : right) b.setZero();
  const auto add = [&](std::uint32_t v, std::uint32_t w, double weight) {
    matrix.add_coef(row[v], row[v], weight);
    if (!is_fixed[w]) return matrix.add_coef(row[v], row[w], -weight);
    for (int k = 0; k < dimension; ++k) right[k][row[v]] += weight * positions[w][k];
  };
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = t[i], w = t[(i + 1) % 3], u = t[(i + 2) % 3];
      if (is_fixed[v]) continue;
      const std::array<double, 2> shares = weights(v, w, u);
      add(v, w, shares[0]);
      add(v, u, shares[1]);
    }
  Solver solver;
  double denominator = 1;
  bool is_solved = solver.factor(matrix, denominator);
  for (int k = 0; k < dimension && is_solved; ++k) is_solved = solver.linear_solver(right[k], x[k]);
  if (!is_solved) return {ERROR_CANNOT_SOLVE, "Tutte embedding of " + std::to_string(n) + " vertices"};
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (!is_fixed[v]) {
      if constexpr (dimension == 2)
        positions[v] = Point(x[0][row[v]], x[1][row[v]]);
      else
        positions[v] = Point(x[0][row[v]], x[1][row[v]], x[2][row[v]]);
    }
  return {};
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TUTTE_EMBEDDING_H
