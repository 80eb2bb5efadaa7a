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

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
The energy of a corner of a hexahedron, which is least when its edges are orthogonal and have their rest lengths. With the
matrix J of edges divided by rest lengths, q = |J|^2 / 3 and d = det J it is
  ((1 - w) q^(3/2) / chi(d) + w (d^2 + 1) / (2 chi(d)))^power,   chi(d) = (d + sqrt(d^2 + epsilon^2)) / 2.
The sum is that of V. Garanzha, I. Kaporin, L. Kudryavtseva, F. Protais, N. Ray, D. Sokolov, Foldover-free maps in 50
lines of code, 2021, equations (2) and (3), but for the exponent of the first term, q / chi^(2/3) there, which costs a
cubic root; a high power looks after the worst corners.
*/
struct Corner_energy {
  int power = 1;
  double volume_weight = 0.8, epsilon = 0;

  struct Derivatives {
    double f, q, d, qq, qd, dd;
  };

  double root(double d) const { return std::sqrt(d * d + epsilon * epsilon); }
  double chi(double d) const { return (d + root(d)) / 2; }

  double operator()(double q, double d) const { return CGAL::ipower(numerator(q, d) / chi(d), power); }

  Derivatives derivatives(double q, double d) const {
    constexpr double least = 1e-12; // of q, where all edges vanish
    const double r = root(d), x = (d + r) / 2, r1 = 1 / r, r2 = epsilon * epsilon / (2 * r * r * r * x);
    const double shape = (1 - volume_weight) / x, volume = volume_weight / x, size = std::sqrt((std::max)(q, least));
    const double b = numerator(q, d) / x, bq = 1.5 * shape * size, bqq = 0.75 * shape / size;
    const double bd = volume * d - b * r1, bdd = volume * (1 - 2 * d * r1) + b * (2 * r1 * r1 - r2);
    const double f = CGAL::ipower(b, power), f1 = power * f / b, f2 = (power - 1) * f1 / b;
    return {f, f1 * bq, f1 * bd, f1 * bqq + f2 * bq * bq, f2 * bq * bd - f1 * bq * r1, f1 * bdd + f2 * bd * bd};
  }

private:
  double numerator(double q, double d) const {
    return (1 - volume_weight) * q * std::sqrt(q) + volume_weight * (d * d + 1) / 2;
  }
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CORNER_ENERGY_H
