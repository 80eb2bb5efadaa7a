// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CORNER_ENERGY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CORNER_ENERGY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/ipower.h>

#include <cmath>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
The energy of a corner of a hexahedron, which is least when its edges are orthogonal and have their rest lengths. With the
matrix J of edges divided by rest lengths, q = |J|^2 / 3 and d = det J it is
  ((1 - w) q / chi(d)^(2/3) + w (d^2 + 1) / (2 chi(d)))^power,   chi(d) = (d + sqrt(d^2 + epsilon^2)) / 2.
The sum is that of V. Garanzha, I. Kaporin, L. Kudryavtseva, F. Protais, N. Ray, D. Sokolov, Foldover-free maps in 50
lines of code, 2021, equations (2) and (3); a high power looks after the worst corners.
*/
struct Corner_energy {
  int power = 1;
  double volume_weight = 0.8, epsilon = 0;

  struct Derivatives {
    double f, q, d, qq, qd, dd;
  };

  double root(double d) const { return std::sqrt(d * d + epsilon * epsilon); }
  double chi(double d) const { return (d + root(d)) / 2; }

  double operator()(double q, double d) const { return CGAL::ipower(base(q, d), power); }

  Derivatives derivatives(double q, double d) const {
    const double w = volume_weight, r = root(d), x = (d + r) / 2;
    const double x1 = x / r, x2 = epsilon * epsilon / (2 * r * r * r);
    const double r1 = x1 / x, r2 = x2 / x;
    const double shape = (1 - w) / std::cbrt(x * x), volume = w * (d * d + 1) / (2 * x);
    const double b = shape * q + volume, bq = shape, bqd = -2. / 3 * shape * r1;
    const double bd = q * bqd + w * d / x - volume * r1;
    const double bdd = q * shape * (10. / 9 * r1 * r1 - 2. / 3 * r2) + w * (1 - 2 * d * r1) / x +
                       volume * (2 * r1 * r1 - r2);
    const double f = CGAL::ipower(b, power), f1 = power * f / b, f2 = (power - 1) * f1 / b;
    return {f, f1 * bq, f1 * bd, f2 * bq * bq, f1 * bqd + f2 * bq * bd, f1 * bdd + f2 * bd * bd};
  }

private:
  double base(double q, double d) const {
    const double x = chi(d);
    return (1 - volume_weight) * q / std::cbrt(x * x) + volume_weight * (d * d + 1) / (2 * x);
  }
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CORNER_ENERGY_H
