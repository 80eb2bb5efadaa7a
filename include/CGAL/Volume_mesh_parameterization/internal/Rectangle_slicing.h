// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RECTANGLE_SLICING_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RECTANGLE_SLICING_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Prism_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A line across a rectangle that leaves some holes on its low side, the others on its high side. The gap between the two
// groups is negative if the line meets holes.
struct Slice {
  int axis = 0;                     // the coordinate that is constant on the line
  double low_end = 0, high_end = 0; // of the gap
  std::vector<std::size_t> low, high;

  double gap() const { return high_end - low_end; }
  double middle() const { return (low_end + high_end) / 2; }

  // A number of few binary digits near the middle, so that those of slices which nearly coincide do coincide.
  double position() const {
    const double unit = std::ldexp(1, std::ilogb(gap()) - 3);
    return std::round(middle() / unit) * unit;
  }
};

// Returns the slice with the widest gap, in O(n log n). rims[0] is the outer rectangle; there are at least two holes.
inline Slice widest_slice(const std::vector<Rectangle_2>& rims, std::vector<std::size_t> holes) {
  const double tolerance = rounding_share * (rims[0].width() + rims[0].height());
  Slice best;
  for (int axis = 0; axis < 2; ++axis) {
    std::stable_sort(holes.begin(), holes.end(), [&](std::size_t a, std::size_t b) {
      return rims[a].low(axis) + rims[a].high(axis) < rims[b].low(axis) + rims[b].high(axis);
    });
    std::vector<double> lowest(holes.size()); // from here on
    for (std::size_t k = holes.size(); k-- > 0;)
      lowest[k] =
          k + 1 < holes.size() ? std::min(rims[holes[k]].low(axis), lowest[k + 1]) : rims[holes[k]].low(axis);
    double highest = rims[holes[0]].high(axis);
    for (std::size_t k = 1; k < holes.size(); ++k) {
      if (best.low.empty() || lowest[k] - highest > best.gap() + tolerance)
        best = {
            axis, highest, lowest[k], {holes.begin(), holes.begin() + k}, {holes.begin() + k, holes.end()}};
      highest = std::max(highest, rims[holes[k]].high(axis));
    }
  }
  return best;
}

/*
Makes rectangles strictly inside of rims[0] separable: slices with gaps part them until each hole is alone in its cell.
So are the cells of a guillotine cut. Where a gap is missing, the two groups are squeezed towards their ends of the cell.
*/
class Rectangle_separation {
public:
  explicit Rectangle_separation(std::vector<Rectangle_2>& rims) : m_rims(rims) {}

  void run() {
    std::vector<std::size_t> holes(m_rims.size() - 1);
    std::iota(holes.begin(), holes.end(), 1);
    separate(m_rims[0], holes);
  }

private:
  void separate(const Rectangle_2& cell, const std::vector<std::size_t>& holes) {
    if (holes.size() < 2) return;
    const Slice slice = widest_slice(m_rims, holes);
    const int axis = slice.axis;
    double position = slice.middle();
    if (slice.gap() <= 0) {
      constexpr double half_gap = 0.05; // of the part of the cell
      squeeze(slice.low, axis, cell.low(axis), slice.low_end,
              position + half_gap * (cell.low(axis) - position));
      squeeze(slice.high, axis, cell.high(axis), slice.high_end,
              position + half_gap * (cell.high(axis) - position));
    }
    Rectangle_2 low = cell, high = cell;
    low.high(axis) = high.low(axis) = position;
    separate(low, slice.low);
    separate(high, slice.high);
  }

  // Moves the holes such that `from` comes to `to` and `fixed` stays.
  void squeeze(const std::vector<std::size_t>& holes, int axis, double fixed, double from, double to) {
    const double factor = (to - fixed) / (from - fixed);
    for (std::size_t hole : holes)
      for (double* x : {&m_rims[hole].low(axis), &m_rims[hole].high(axis)})
        *x = fixed + factor * (*x - fixed);
  }

  std::vector<Rectangle_2>& m_rims;
};

inline std::vector<Rectangle_2> separated(std::vector<Rectangle_2> rims) {
  Rectangle_separation(rims).run();
  return rims;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RECTANGLE_SLICING_H
