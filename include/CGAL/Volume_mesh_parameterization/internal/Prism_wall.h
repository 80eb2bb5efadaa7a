// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRISM_WALL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRISM_WALL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Labelled_surface.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The vertices between the wall with this label and a base, from `start` in the direction that the floor has on its
// left as seen from inside the solid; both rims of a wall run in parallel.
inline std::vector<Refined_surface::Id> wall_rim(const Labelled_surface& surface, int label, int base,
                                                 Refined_surface::Id start = Refined_surface::none) {
  using Id = Refined_surface::Id;
  const Refined_surface& s = surface.surface;
  std::vector<Id> next(s.number_of_vertices(), Refined_surface::none);
  for (Id h = 0; h < s.number_of_half_edges(); ++h) {
    if (surface.label(h) != label || surface.label(s.opposite(h)) != base) continue;
    const bool forward = base == FLOOR;
    const Id from = forward ? s.source(h) : s.target(h);
    next[from] = forward ? s.target(h) : s.source(h);
    if (start == Refined_surface::none) start = from;
  }
  std::vector<Id> loop(1, start);
  for (Id v = next[start]; v != start; v = next[v]) loop.push_back(v);
  return loop;
}

// One wall of a solid that is to become the walls of a prism over one rim of its base.
struct Prism_wall {
  using Id = Refined_surface::Id;
  using Path = std::vector<Id>;

  int label;
  std::array<std::array<double, 2>, 4> corners; // of the rectangle, in the direction of the rims
  std::array<Id, 4> bottom, top;                // vertices at the corners
  std::array<Path, 4> creases;                  // from bottom to top

  // The point of the unit circle for a point on the perimeter of the rectangle, or near it: the same share of the turn.
  Double_kernel::Point_2 direction(double x, double y) const {
    double total = 0, arc = 0, least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 4; ++k) {
      const auto &c = corners[k], &d = corners[(k + 1) % 4];
      const double length = std::hypot(d[0] - c[0], d[1] - c[1]);
      const double share = ((x - c[0]) * (d[0] - c[0]) + (y - c[1]) * (d[1] - c[1])) / (length * length);
      const double along = (std::min)(1., (std::max)(0., share));
      const double distance = std::hypot(c[0] + along * (d[0] - c[0]) - x, c[1] + along * (d[1] - c[1]) - y);
      if (distance < least) {
        least = distance;
        arc = total + along * length;
      }
      total += length;
    }
    const double angle = 2 * CGAL_PI * arc / total;
    return {std::cos(angle), std::sin(angle)};
  }

  // The vertices of a rim from corner k to the next one.
  static Path side(const Path& rim, const std::array<Id, 4>& ends, int k) {
    const auto from = std::find(rim.begin(), rim.end(), ends[k]);
    Path result;
    for (auto v = from; result.empty() || result.back() != ends[(k + 1) % 4];) {
      result.push_back(*v);
      if (++v == rim.end()) v = rim.begin();
    }
    return result;
  }
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRISM_WALL_H
