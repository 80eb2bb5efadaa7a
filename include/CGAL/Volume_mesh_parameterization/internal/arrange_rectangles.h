// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ARRANGE_RECTANGLES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ARRANGE_RECTANGLES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Moves sides of holes that are on nearly the same line to one line: each line becomes one of the hexahedra, and two that
almost coincide would leave slivers between them. Neither do the sides of one hole come together nor do holes touch.
*/
class Side_alignment {
public:
  explicit Side_alignment(std::vector<Rectangle_2>& rims) : m_rims(rims) {}

  void run() {
    for (int axis = 0; axis < 2; ++axis) align(axis);
  }

private:
  struct Side {
    std::size_t hole;
    bool is_high;
  };

  double& line(const Side& side, int axis) {
    return side.is_high ? m_rims[side.hole].high(axis) : m_rims[side.hole].low(axis);
  }

  // Sorted sides that are near the first one come to the middle between first and last: no line passes another one.
  void align(int axis) {
    constexpr double tolerance = 0.05; // of the edge of a square as large as the base
    const double distance = tolerance * std::sqrt(m_rims[0].area());
    std::vector<Side> sides;
    for (std::size_t hole = 1; hole < m_rims.size(); ++hole)
      for (bool is_high : {false, true}) sides.push_back({hole, is_high});
    std::stable_sort(sides.begin(), sides.end(),
                     [&](const Side& a, const Side& b) { return line(a, axis) < line(b, axis); });
    for (std::size_t first = 0, end; first < sides.size(); first = end) {
      const auto may_join = [&](const Side& side) {
        return line(side, axis) - line(sides[first], axis) <= distance &&
               std::all_of(sides.begin() + first, sides.begin() + end,
                           [&](const Side& s) { return may_share_line(s, side, axis); });
      };
      for (end = first + 1; end < sides.size() && may_join(sides[end]);) ++end;
      const double middle = (line(sides[first], axis) + line(sides[end - 1], axis)) / 2;
      for (std::size_t k = first; k < end; ++k) line(sides[k], axis) = middle;
    }
  }

  // Sides that face each other may not, unless their holes are apart in the other coordinate.
  bool may_share_line(const Side& a, const Side& b, int axis) const {
    if (a.hole == b.hole || a.is_high == b.is_high) return a.hole != b.hole;
    const Rectangle_2 &r = m_rims[a.hole], &s = m_rims[b.hole];
    return r.low(1 - axis) > s.high(1 - axis) || s.low(1 - axis) > r.high(1 - axis);
  }

  std::vector<Rectangle_2>& m_rims;
};

inline std::vector<Rectangle_2> aligned(std::vector<Rectangle_2> rims) {
  Side_alignment(rims).run();
  return rims;
}

inline std::vector<Rectangle_2> scaled(std::vector<Rectangle_2> rims, const std::array<double, 2>& factors) {
  for (Rectangle_2& r : rims)
    for (int axis = 0; axis < 2; ++axis) {
      r.low(axis) *= factors[axis];
      r.high(axis) *= factors[axis];
    }
  return rims;
}

inline std::vector<Rectangle_2> rounded(std::vector<Rectangle_2> rims) {
  for (Rectangle_2& r : rims)
    r = {std::round(r.xmin), std::round(r.ymin), std::round(r.xmax), std::round(r.ymax)};
  return rims;
}

// Whether a length that has been rounded is about the same.
inline bool keeps_length(double before, double after) {
  constexpr double most = 0.25; // of the change
  return CGAL::abs(after - before) <= most * before;
}

// Whether the first rectangle and the holes are those of a base.
inline bool are_rims(const std::vector<Rectangle_2>& rims) {
  return Prism_3<Double_kernel>(rims[0], {rims.begin() + 1, rims.end()}, 1).is_valid();
}

// Whether rims that have been rounded still are rims, and about the same.
inline bool keeps_shape(const std::vector<Rectangle_2>& before, const std::vector<Rectangle_2>& after) {
  for (int axis = 0; axis < 2; ++axis)
    for (std::size_t k = 0; k < before.size(); ++k) {
      const Rectangle_2 &o = before[0], &p = after[0], &r = before[k], &s = after[k];
      if (!keeps_length(r.high(axis) - r.low(axis), s.high(axis) - s.low(axis)) ||
          !keeps_length(r.low(axis) - o.low(axis), s.low(axis) - p.low(axis)) ||
          !keeps_length(o.high(axis) - r.high(axis), p.high(axis) - s.high(axis)))
        return false;
    }
  return are_rims(after);
}

// The factor with which the prism over the rectangles fits on the coarsest integer grid.
inline double coarsest_integer_scale(const std::vector<Rectangle_2>& rims, double height) {
  const double side = (std::min)({rims[0].width(), rims[0].height(), height});
  for (double units = 1;; units += 1 + std::floor(units / 8)) { // few trials, even if a hole is a mere slit
    const double scale = units / side;
    const std::vector<Rectangle_2> fine = scaled(rims, {scale, scale});
    if (keeps_length(height * scale, std::round(height * scale)) && keeps_shape(fine, rounded(fine)))
      return scale;
  }
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ARRANGE_RECTANGLES_H
