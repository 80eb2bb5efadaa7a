// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_WEIGHTED_STATISTICS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_WEIGHTED_STATISTICS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationVerification

sums up weighted values, for instance one value for each tetrahedron with its volume as weight.

Values whose weight is zero do not count. Without values all results are zero.
*/
class Weighted_statistics {
public:
  Weighted_statistics() = default;

  /// sorts the values in \f$ O(n \log n) \f$.
  /// \pre there are as many values as weights; no value is NaN, no weight is negative
  Weighted_statistics(const std::vector<double>& values, const std::vector<double>& weights) {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (weights[i] > 0) m_samples.push_back({values[i], weights[i]});
    std::sort(m_samples.begin(), m_samples.end(),
              [](const Sample& a, const Sample& b) { return a.value < b.value; });
    double sum = 0, total = 0;
    for (Sample& s : m_samples) {
      sum += s.value * s.weight;
      s.weight = total += s.weight;
    }
    if (total > 0) m_mean = sum / total;
  }

  /// returns the least value, 0 if there is none.
  double minimum() const { return m_samples.empty() ? 0 : m_samples.front().value; }
  /// returns the greatest value, 0 if there is none.
  double maximum() const { return m_samples.empty() ? 0 : m_samples.back().value; }
  /// returns the mean, weighted.
  double mean() const { return m_mean; }
  /// returns the value that half of the weight does not exceed.
  double median() const { return quantile(0.5); }

  /// returns the least value such that the values up to it have at least the fraction `q` of the total weight.
  double quantile(double q) const {
    if (m_samples.empty()) return 0;
    const double weight = q * m_samples.back().weight;
    const auto found = std::lower_bound(m_samples.begin(), m_samples.end(), weight,
                                        [](const Sample& s, double w) { return s.weight < w; });
    return found == m_samples.end() ? maximum() : found->value;
  }

private:
  struct Sample {
    double value, weight; // after construction: the weight of all values up to this one
  };

  std::vector<Sample> m_samples;
  double m_mean = 0;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_WEIGHTED_STATISTICS_H
