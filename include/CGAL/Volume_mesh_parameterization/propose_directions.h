// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PROPOSE_DIRECTIONS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PROPOSE_DIRECTIONS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationPartition

is a direction from the floor to the ceiling; its length does not matter.
*/
using Sweep_direction_3 = Simple_cartesian<double>::Vector_3;

namespace internal {

inline double length(const Sweep_direction_3& d) { return std::sqrt(d.squared_length()); }

inline Sweep_direction_3 normalized(const Sweep_direction_3& d) {
  const double l = length(d);
  return l > 0 ? d / l : d;
}

inline Status check_directions(const std::vector<Sweep_direction_3>& directions) {
  for (const Sweep_direction_3& d : directions)
    if (!(length(d) > 0) || !std::isfinite(length(d)))
      return {ERROR_WRONG_PARAMETER, "the direction has no length"};
  return {};
}

// Of the ceiling's normals, and the floor's turned round, of any length.
inline Sweep_direction_3 mean_direction(const Approximate_surface& surface, const std::vector<int>& labels) {
  Sweep_direction_3 sum(0, 0, 0);
  for (Facet_index f : surface.adjacency.facets()) {
    if (labels[f] == CEILING) sum = sum + surface.area_vector(f);
    if (labels[f] == FLOOR) sum = sum - surface.area_vector(f);
  }
  return sum;
}

// How well a surface suits a sweep along a unit vector d, from its unit normals n; means by area.
struct Direction_scores {
  Sweep_direction_3 direction;
  double slant;      // the mean of |n d| sqrt(1 - (n d)^2): 0 if there are only bases and walls
  double projection; // the mean of |n d|: twice the share of the area that is seen
};

inline Direction_scores score(const Approximate_surface& surface, const Sweep_direction_3& d) {
  Direction_scores result = {d, 0, 0};
  for (Facet_index f : surface.adjacency.facets()) {
    const double projected = std::abs(surface.area_vector(f) * d), area = surface.areas[f];
    result.projection += projected / surface.total_area;
    if (area > 0)
      result.slant += projected * std::sqrt(std::max(0., 1 - (projected / area) * (projected / area))) /
                      surface.total_area;
  }
  // to two digits, so that an axis wins against a sample that happens to lie next to it
  result.slant = std::round(100 * result.slant) / 100;
  result.projection = std::round(100 * result.projection) / 100;
  return result;
}

// Directions on a half-sphere, evenly along a spiral: E. Saff, A. Kuijlaars, Distributing many points on a sphere (1997).
// The axes come first, for models are often aligned with them.
inline std::vector<Sweep_direction_3> spread_directions(int n) {
  std::vector<Sweep_direction_3> directions = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  const double golden_angle = CGAL_PI * (3 - std::sqrt(5.));
  for (int k = 0; k < n; ++k) {
    const double z = (k + .5) / n, r = std::sqrt(1 - z * z);
    directions.emplace_back(r * std::cos(k * golden_angle), r * std::sin(k * golden_angle), z);
  }
  return directions;
}

// Takes the first ones that lie apart from each other and from those taken already.
inline void take_best(const std::vector<Direction_scores>& sorted, std::size_t n,
                      std::vector<Sweep_direction_3>& taken) {
  constexpr double cosine_of_neighbors = .966; // 15 degrees
  const std::size_t end = taken.size() + n;
  for (const Direction_scores& s : sorted)
    if (taken.size() < end && std::none_of(taken.begin(), taken.end(), [&](const Sweep_direction_3& t) {
          return std::abs(t * s.direction) > cosine_of_neighbors;
        }))
      taken.push_back(s.direction);
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationPartition

returns directions to try for a sweep, the most promising first: those from which the surface looks most like bases and
walls, in turn with those from which most of it is seen. Unit vectors; of opposite ones there is one only. Takes linear time for
each of about 300 directions that are compared.

\tparam Surface a `Compact_tetrahedral_mesh_3`, whose boundary counts, or a `Triangle_soup_3` that is closed
*/
template <typename Surface>
std::vector<Sweep_direction_3> propose_directions(const Surface& surface) {
  constexpr int number_of_samples = 300, number_of_rounds = 12;
  const internal::Approximate_surface approximate = internal::approximate_surface(surface);
  std::vector<internal::Direction_scores> by_slant;
  for (const Sweep_direction_3& d : internal::spread_directions(number_of_samples))
    by_slant.push_back(internal::score(approximate, d));
  std::vector<internal::Direction_scores> by_projection = by_slant;
  std::stable_sort(by_slant.begin(), by_slant.end(), [](auto& a, auto& b) { return a.slant < b.slant; });
  std::stable_sort(by_projection.begin(), by_projection.end(),
                   [](auto& a, auto& b) { return a.projection > b.projection; });
  std::vector<Sweep_direction_3> result;
  for (int round = 0; round < number_of_rounds; ++round) {
    internal::take_best(by_slant, 1, result);
    internal::take_best(by_projection, 1, result);
  }
  return result;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PROPOSE_DIRECTIONS_H
