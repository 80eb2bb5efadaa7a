// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BASE_POINT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BASE_POINT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/indices.h>

#include <array>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationStructure

is a point of the floor or of the ceiling of a solid.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
struct Base_point_3 {
  Facet_index facet;                                  ///< a facet of the floor
  std::array<typename GeomTraits::FT, 3> barycentric; ///< weights of the vertices of `facet`, in their order
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BASE_POINT_3_H
