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

struct Any_label {
  bool operator()(int) const { return true; }
};

// The points of some boundary facets, and which facets these are.
template <typename GeomTraits>
struct Boundary_triangles {
  std::vector<Facet_index> facets;
  std::vector<std::array<typename GeomTraits::Point_3, 3>> triangles;

  // Takes the facets with is_wanted(label), with the vertices at `points`. Fails if one is in no plane orthogonal to an
  // axis, with `error`.
  template <typename Predicate>
  Status collect(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                 const std::vector<typename GeomTraits::Point_3>& points, const Predicate& is_wanted, Error_code error) {
    for (Facet_index f : mesh.boundary_facets()) {
      if (!is_wanted(mesh.label(f))) continue;
      const auto v = mesh.vertices(f);
      facets.push_back(f);
      triangles.push_back({points[v[0]], points[v[1]], points[v[2]]});
      if (!Axis_aligned_surface<GeomTraits>::normal(triangles.back()).exists())
        return {error, "the boundary triangle with vertices " + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " +
                           std::to_string(v[2]) + " is flat, or orthogonal to no axis"};
    }
    return {};
  }
};

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOUNDARY_TRIANGLES_H
