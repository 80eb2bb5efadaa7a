// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_WALLS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_WALLS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Labelled_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/curve_ridges.h>
#include <CGAL/Volume_mesh_parameterization/internal/cut_along_level.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>
#include <CGAL/Volume_mesh_parameterization/internal/patch_cleanup.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_fields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

// From a surface whose facets are all floor or ceiling to one with walls between them.

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The vertices between floor and ceiling.
inline std::vector<Vertex_index> loop_vertices(const Approximate_surface& surface,
                                               const std::vector<int>& labels) {
  std::vector<Vertex_index> result;
  for (Facet_index f : surface.adjacency.facets())
    for (int i = 0; i < 3; ++i)
      if (labels[f] == FLOOR && is_border(surface.adjacency, labels, {f, i}))
        result.push_back(surface.adjacency.source({f, i}));
  return result;
}

// How far it is from the loops across each vertex to the middle of the base: averaged over the base, as the mean distance of
// a strip is half of that way.
inline Vertex_field averaged_way_to_middle(const Approximate_surface& surface, const Vertex_field& distance) {
  const double mean = distance.sum() / std::max<double>(1, double((distance.array() > 0).count()));
  return 2 * Surface_diffusion(surface, 4 * mean * mean).average(distance);
}

// Averaged ways give the smoothest walls, and the best hexahedra. Up to ridges, walls as wide as less than the whole way do not
// merge, wherever the loops run.
enum Way_to_middle { AVERAGED, UP_TO_RIDGES };

// How far the loops between floor and ceiling are away, as a share of the way to the middle of the base; negative on the
// floor.
inline Vertex_field relative_height(const Approximate_surface& surface, const std::vector<int>& labels,
                                    Way_to_middle way) {
  const Vertex_field distance = Surface_distance(surface).from(loop_vertices(surface, labels));
  Vertex_field ways = averaged_way_to_middle(surface, distance);
  if (way == UP_TO_RIDGES) {
    const Vertex_field to_ridges = Curve_ridges(surface, labels, distance).way_to_ridges();
    for (Eigen::Index v = 0; v < ways.size(); ++v)
      if (to_ridges[v] > 0) ways[v] = std::min(ways[v], to_ridges[v]);
  }
  Vertex_field height = distance;
  for (Facet_index f : surface.adjacency.facets())
    for (Vertex_index v : surface.adjacency.triangle(f))
      if (distance[v] > 0) height[v] = (labels[f] == FLOOR ? -1 : 1) * distance[v] / ways[v];
  return height;
}

// Bisects the edges that join vertices between floor and ceiling across one of them. Then walls that are narrow enough
// are annuli.
inline void split_rim_chords(Labelled_surface& halves) {
  const Refined_surface& surface = halves.surface;
  std::vector<char> is_on_rim(surface.number_of_vertices(), 0);
  for (Refined_surface::Id h = 0; h < surface.number_of_half_edges(); ++h)
    if (halves.is_rim(h)) is_on_rim[surface.source(h)] = 1;
  std::vector<std::array<Refined_surface::Id, 2>> chords;
  for (Refined_surface::Id h = 0; h < surface.number_of_half_edges(); ++h)
    if (h < surface.opposite(h) && is_on_rim[surface.source(h)] && is_on_rim[surface.target(h)] &&
        !halves.is_rim(h))
      chords.push_back({surface.source(h), surface.target(h)});
  sort_longest_first(chords, [&](Refined_surface::Id v) { return surface.points()[v]; });
  for (const auto& [v, w] : chords) halves.split(v, w, .5);
}

// Makes what lies between the heights -1 and 1 the walls. If the two halves are disks with holes, this is legal for
// heights that are scaled up far enough.
inline Status cut_walls(Labelled_surface halves, Vertex_field height, Labelled_surface& result) {
  // What isolines cut off may join a wall up to this share of the area; if it is more, the wall is too wide.
  constexpr double fragment_share = .005;
  cut_along_level(halves, height, -1);
  cut_along_level(halves, height, 1);
  const Approximate_surface surface = halves.approximate_surface();
  halves.labels = labels_by_level(surface.adjacency, height, -1, FLOOR, FIRST_WALL);
  const std::vector<int> upper = labels_by_level(surface.adjacency, -height, -1, CEILING, FIRST_WALL);
  for (std::size_t f = 0; f < upper.size(); ++f)
    if (upper[f] == CEILING) halves.labels[f] = CEILING;
  const Status status = clean_patches(surface, halves.labels, fragment_share);
  if (status.ok()) result = std::move(halves);
  return status;
}

// Takes the widest walls that are legal, at most `width` of the way to the middle of the bases; the last ones tried have only
// vertices of the curves inside.
inline Status widen_walls(const Labelled_surface& halves, double width, Labelled_surface& result) {
  constexpr double narrower = .7;
  const Vertex_field height = relative_height(halves.approximate_surface(), halves.labels, UP_TO_RIDGES);
  double least = width;
  for (double h : height)
    if (h != 0) least = std::min(least, std::abs(h) * narrower);
  Status status;
  for (; width >= least; width *= narrower) {
    status = cut_walls(halves, height / width, result);
    if (status.ok()) return status;
  }
  return {ERROR_NO_PARTITION, "no walls are narrow enough: " + status.message()};
}

// Along averaged ways if that is legal.
inline Status make_walls(Labelled_surface halves, double width, Labelled_surface& result) {
  split_rim_chords(halves);
  const Vertex_field height = relative_height(halves.approximate_surface(), halves.labels, AVERAGED);
  const Status status = cut_walls(halves, height / width, result);
  return status.ok() ? status : widen_walls(halves, width, result);
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_WALLS_H
