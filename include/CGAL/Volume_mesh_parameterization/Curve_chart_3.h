// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CURVE_CHART_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CURVE_CHART_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Base_point_3.h>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationStructure

tells where a point of a solid is in the product of the floor and an interval: the two ends of the curve through it, and how
far up it is.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
struct Curve_chart_3 {
  using FT = typename GeomTraits::FT;          ///< the number type
  using Base_point = Base_point_3<GeomTraits>; ///< a point of floor or ceiling

  Base_point floor;   ///< where the curve starts
  Base_point ceiling; ///< where it ends
  FT below;           ///< what the level function gains from the floor to the point
  FT above;           ///< what it gains from the point to the ceiling

  /// returns the share of the level that is gained at the point, from 0 on the floor to 1 on the ceiling.
  FT share() const { return below / (below + above); }
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CURVE_CHART_3_H
