// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEAREST_ADMISSIBLE_VECTOR_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEAREST_ADMISSIBLE_VECTOR_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Dense>

#include <array>
#include <limits>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
A polyhedral cone of directions in a cell, cut off at a distance from its facets: s_i n_i . v >= margin for each facet
with sign s_i = +1 (entry) or -1 (exit), n_i . v = 0 for a wall (sign 0); n_i is the unit normal into the cell.
*/
class Admissible_vectors {
public:
  using Vector = Eigen::Vector3d;

  Admissible_vectors(const std::array<Vector, 4>& normals, const std::array<int, 4>& signs, double margin)
      : m_normals(normals), m_signs(signs), m_margin(margin) {}

  // Returns the point of the set nearest to g. That point is the projection of g on the planes of the constraints that
  // are active there, hence the nearest of those projections, over all active sets, that is admissible.
  Vector nearest_to(const Vector& g) const {
    if (contains_walls(0) && is_admissible(g)) return g;
    Vector best = Vector::Zero();
    double least = std::numeric_limits<double>::infinity();
    for (unsigned active = 0; active < 16; ++active) {
      if (!contains_walls(active)) continue;
      const Vector v = projection(g, active);
      const double distance = (v - g).squaredNorm();
      if (distance < least && is_admissible(v)) {
        best = v;
        least = distance;
      }
    }
    return best;
  }

private:
  bool contains_walls(unsigned active) const {
    for (int i = 0; i < 4; ++i)
      if (m_signs[i] == 0 && !(active >> i & 1)) return false;
    return true;
  }

  // Any three of the four normals are independent; all four planes have no common point, and none is found.
  Vector projection(const Vector& g, unsigned active) const {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 4, 3>;
    using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 4, 1>;
    Rows n(4, 3);
    Values residual(4);
    int rows = 0;
    for (int i = 0; i < 4; ++i)
      if (active >> i & 1) {
        n.row(rows) = m_normals[i].transpose();
        residual[rows++] = m_signs[i] * m_margin - m_normals[i].dot(g);
      }
    if (rows == 0) return g;
    if (rows == 4) return Vector::Zero();
    n.conservativeResize(rows, 3);
    residual.conservativeResize(rows);
    return g + n.transpose() * (n * n.transpose()).eval().ldlt().solve(residual);
  }

  // Active constraints hold up to rounding; the caller sets signs straight.
  bool is_admissible(const Vector& v) const {
    const double rounding = 1e-9 * m_margin;
    for (int i = 0; i < 4; ++i)
      if (m_signs[i] != 0 && m_signs[i] * m_normals[i].dot(v) < m_margin - rounding) return false;
    return true;
  }

  std::array<Vector, 4> m_normals;
  std::array<int, 4> m_signs;
  double m_margin;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NEAREST_ADMISSIBLE_VECTOR_H
