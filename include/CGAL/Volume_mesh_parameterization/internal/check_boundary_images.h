// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHECK_BOUNDARY_IMAGES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHECK_BOUNDARY_IMAGES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The number of vertices that are not barycentres of split simplices.
template <typename GeomTraits>
std::size_t number_of_given_vertices(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  return mesh.number_of_vertices() - mesh.split_simplices().size();
}

// Whether there is an image for each given vertex on the boundary.
template <typename GeomTraits>
Status check_boundary_images(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                             const std::vector<typename GeomTraits::Point_3>& images) {
  for (Facet_index f : mesh.boundary_facets())
    for (Vertex_index v : mesh.vertices(f)) {
      if (v >= number_of_given_vertices(mesh)) continue;
      if (v >= images.size()) return {ERROR_BOUNDARY_MAP, "vertex " + std::to_string(v) + " has no image"};
      if (!has_finite_coordinates(images[v]))
        return {ERROR_COORDINATE_NOT_FINITE, "the image of vertex " + std::to_string(v)};
    }
  return {};
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHECK_BOUNDARY_IMAGES_H
