// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_TRIANGLES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_TRIANGLES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Axis_aligned_surface.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The boundary facets with the vertices at `points`, in the order of their numbers. Fails if one is in no plane orthogonal
// to an axis, with `error`. Traits: those of the points, which need not be those of the mesh
template <typename Traits, typename GeomTraits>
Status boundary_triangles(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                          const std::vector<typename Traits::Point_3>& points, Error_code error,
                          std::vector<std::array<typename Traits::Point_3, 3>>& triangles) {
  for (Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    triangles.push_back({points[v[0]], points[v[1]], points[v[2]]});
    if (!Axis_aligned_surface<Traits>::normal(triangles.back()).exists())
      return {error, "the boundary triangle with vertices " + std::to_string(v[0]) + ", " +
                         std::to_string(v[1]) + ", " + std::to_string(v[2]) +
                         " is flat, or orthogonal to no axis"};
  }
  return {};
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_TRIANGLES_H
