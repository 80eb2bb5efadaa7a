// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_HALVES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_HALVES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Labelled_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/cut_along_level.h>
#include <CGAL/Volume_mesh_parameterization/internal/patch_cleanup.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_fields.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A closed surface of genus n is cut into two disks with n holes if it falls into two parts with n + 1 loops between.
inline Status check_halves(const Approximate_surface& surface, const std::vector<int>& labels) {
  const Boundary_partition_3 summary = summarize(surface.adjacency, labels, surface.areas);
  if (summary.patches.size() != 2) return {ERROR_NO_PARTITION, "all of the surface faces one side"};
  for (const Boundary_patch_3& patch : summary.patches) {
    if (patch.number_of_components != 1)
      return {ERROR_NO_PARTITION,
              "the " + patch.name() + " has " + std::to_string(patch.number_of_components) + " parts"};
    if (patch.number_of_border_loops != std::size_t(summary.genus + 1))
      return {ERROR_NO_PARTITION, std::to_string(patch.number_of_border_loops) +
                                      " loops separate floor and ceiling, but the genus is " +
                                      std::to_string(summary.genus)};
  }
  return {};
}

// Cuts a surface where `values` are 0 and makes what is below the floor, what is above the ceiling. Parts that lie apart and
// have less than `island_share` of the area are flipped.
inline Status cut_halves(Labelled_surface given, Vertex_field values, double island_share,
                         Labelled_surface& halves) {
  cut_along_level(given, values, 0);
  const Approximate_surface surface = given.approximate_surface();
  given.labels = labels_by_level(surface.adjacency, values, 0, FLOOR, CEILING);
  remove_islands(surface, given.labels, island_share);
  const Status status = check_halves(surface, given.labels);
  if (status.ok()) halves = std::move(given);
  return status;
}

// -1 on the floor and 1 on the ceiling, averaged over this share of the area.
inline Vertex_field averaged_sides(const Approximate_surface& surface, const std::vector<int>& labels,
                                   double share) {
  Vertex_field sides = Vertex_field::Zero(Eigen::Index(surface.points.size()));
  for (Facet_index f : surface.adjacency.facets())
    for (Vertex_index v : surface.adjacency.triangle(f))
      sides[v] += (labels[f] == FLOOR ? -1 : labels[f] == CEILING ? 1 : 0) * surface.areas[f] / 3;
  return Surface_diffusion(surface, share * surface.total_area).average_of_integral(sides);
}

// Lets the curves between the halves run where averaged sides change, as smooth as their shape allows: they zigzag if they
// follow edges.
inline void smooth_halves(Labelled_surface& halves) {
  const Approximate_surface surface = halves.approximate_surface();
  for (double share : {1e-3, 3e-4, 1e-4, 3e-5})
    if (cut_halves(halves, averaged_sides(surface, halves.labels, share), 0, halves).ok()) return;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_HALVES_H
