// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BALANCE_RATES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BALANCE_RATES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// returns `rates`, of which some are positive and some negative, changed in their last digits so that they sum to 0
// in exact arithmetic; no sign changes. The positive and the negative ones are scaled to the same sum, all but the
// largest are rounded to a grid on which sums of four are exact in double, and the largest is what the others leave.
inline std::array<double, 4> balance_rates(std::array<double, 4> rates) {
  double in = 0, out = 0;
  for (double r : rates) (r > 0 ? in : out) += std::abs(r);
  if (in == 0 || out == 0) return {0, 0, 0, 0};
  for (double& r : rates) r *= (in + out) / (r > 0 ? 2 * in : 2 * out);
  const auto largest = std::max_element(rates.begin(), rates.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
  const double unit = std::ldexp(1., std::ilogb(*largest) - 50);
  *largest = 0;
  for (double& r : rates)
    if (r != 0) r = std::copysign(unit * std::max(1., std::round(std::abs(r) / unit)), r);
  *largest = -(rates[0] + rates[1] + rates[2] + rates[3]);
  return rates;
}

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BALANCE_RATES_H
