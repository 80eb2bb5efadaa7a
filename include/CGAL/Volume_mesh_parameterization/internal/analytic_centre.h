// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ANALYTIC_CENTRE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ANALYTIC_CENTRE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The points with a positive height.
template <int Dimension>
struct Half_space {
  using Vector = Eigen::Matrix<double, Dimension, 1>;

  double height(const Vector& x) const { return slope.dot(x) + offset; }

  Vector slope;
  double offset;
};

// Where vertex i of a positive tetrahedron may be.
inline Half_space<3> half_space_inside(const std::array<Eigen::Vector3d, 4>& tetrahedron, int i) {
  const Eigen::Vector3d &a = tetrahedron[(i + 1) % 4], &b = tetrahedron[(i + 2) % 4],
                        &c = tetrahedron[(i + 3) % 4];
  const Eigen::Vector3d normal = (b - a).cross(c - a) * (i % 2 == 0 ? -1 : 1);
  return {normal, -normal.dot(a)};
}

/*
Moves a point, where all heights are positive, up the function direction . x + sum log(height), by damped Newton steps,
which never leave the half spaces (S. Boyd, L. Vandenberghe, Convex Optimization, 2004, 9.6.4). Without a direction the top
is the analytic centre: stretching space moves it along.
*/
template <int Dimension>
void climb_barrier(const std::vector<Half_space<Dimension>>& half_spaces,
                   const Eigen::Matrix<double, Dimension, 1>& direction, int steps,
                   Eigen::Matrix<double, Dimension, 1>& x) {
  using Matrix = Eigen::Matrix<double, Dimension, Dimension>;
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  for (int k = 0; k < steps; ++k) {
    Vector gradient = direction;
    Matrix hessian = Matrix::Zero(); // of the negated function
    for (const auto& h : half_spaces) {
      const Vector relative = h.slope / h.height(x);
      gradient += relative;
      hessian += relative * relative.transpose();
    }
    const Vector step = hessian.ldlt().solve(gradient);
    const double decrement = std::sqrt((std::max)(gradient.dot(step), 0.));
    const Vector next = x + step / (1 + decrement);
    if (!std::all_of(half_spaces.begin(), half_spaces.end(),
                     [&](const auto& h) { return h.height(next) > 0; }))
      return; // for rounding only
    x = next;
  }
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ANALYTIC_CENTRE_H
