// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_IMAGES_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_IMAGES_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/indices.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

is a piecewise linear map of the boundary of a solid onto the boundary of a domain, after some edges of the boundary have
been bisected.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
struct Boundary_images_3 {
  /// the edges to bisect, in this order; the midpoints are the next vertices
  std::vector<std::array<Vertex_index, 2>> bisected_edges;
  /// the images of all vertices, those of the midpoints last; vertices inside have any
  std::vector<typename GeomTraits::Point_3> images;
  /// symmetric Dirichlet energy over the area, 4 for an isometry; 0 if the map was given
  double energy = 0;
  /// whether vertices may be moved in the planes of their images
  bool may_slide = false;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_IMAGES_3_H
