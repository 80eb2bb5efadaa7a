// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TRIANGLE_WEIGHTS_2_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TRIANGLE_WEIGHTS_2_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

template <typename GeomTraits>
using Triangle_corners_2 = std::array<typename GeomTraits::Point_2, 3>;

// Whether the closed triangle contains p; either orientation of the corners will do.
template <typename GeomTraits>
bool contains(const Triangle_corners_2<GeomTraits>& c, const typename GeomTraits::Point_2& p) {
  const typename GeomTraits::Orientation_2 orientation;
  const Orientation o[] = {orientation(c[0], c[1], p), orientation(c[1], c[2], p), orientation(c[2], c[0], p)};
  const bool left = std::count(o, o + 3, LEFT_TURN) > 0, right = std::count(o, o + 3, RIGHT_TURN) > 0;
  return !(left && right);
}

// The barycentric coordinates of p, which is in the triangle, so that negative weights are rounding errors.
template <typename GeomTraits>
std::array<typename GeomTraits::FT, 3> weights_in(const Triangle_corners_2<GeomTraits>& c,
                                                  const typename GeomTraits::Point_2& p) {
  using FT = typename GeomTraits::FT;
  const auto area = [](const auto& a, const auto& b, const auto& q) -> FT {
    return (b.x() - a.x()) * (q.y() - a.y()) - (b.y() - a.y()) * (q.x() - a.x());
  };
  const FT whole = area(c[0], c[1], c[2]);
  std::array<FT, 3> w;
  for (int i = 0; i < 3; ++i) w[i] = (std::max)(FT(0), FT(area(c[(i + 1) % 3], c[(i + 2) % 3], p) / whole));
  const FT sum = w[0] + w[1] + w[2];
  for (FT& weight : w) weight /= sum;
  return w;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TRIANGLE_WEIGHTS_2_H
