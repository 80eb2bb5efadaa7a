// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IMAGE_OF_BOUNDARY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IMAGE_OF_BOUNDARY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Polygon_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/boundary_triangles.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_boundary_images.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

makes the surface that a boundary map maps onto, so that the polycube need not be given: `tetrahedralize_polycube()` fills it.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param mesh a solid that has not been refined
\param images the images of its vertices; those of inner vertices are not used
\param surface receives the images of the boundary facets, in the order of their numbers, without common vertices

\returns `ERROR_BOUNDARY_MAP` if a facet is mapped into no plane orthogonal to an axis; `ERROR_COORDINATE_NOT_FINITE`; then
`surface` is left as it was

Complexity: \f$ O(n) \f$.
*/
template <typename GeomTraits>
Status image_of_boundary(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                         const std::vector<typename GeomTraits::Point_3>& images,
                         Polygon_soup_3<typename GeomTraits::Point_3>& surface) {
  std::vector<std::array<typename GeomTraits::Point_3, 3>> triangles;
  Status status = internal::check_boundary_images(mesh, images);
  if (status.ok()) status = internal::boundary_triangles<GeomTraits>(mesh, images, ERROR_BOUNDARY_MAP, triangles);
  if (!status.ok()) return status;
  surface = {};
  for (const auto& t : triangles) {
    const std::size_t n = surface.points.size();
    surface.points.insert(surface.points.end(), t.begin(), t.end());
    surface.polygons.push_back({n, n + 1, n + 2});
  }
  return {};
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IMAGE_OF_BOUNDARY_H
