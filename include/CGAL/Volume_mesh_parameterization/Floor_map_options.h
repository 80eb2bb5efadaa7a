// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_FLOOR_MAP_OPTIONS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_FLOOR_MAP_OPTIONS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <array>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

is what may be asked of the prism that `Floor_map_2` finds.
*/
struct Floor_map_options {
  /// whether the planes of all sides are to be integers, in a unit that fits; if a size is given, then in that of the size.
  bool integer_planes = false;
  /// width, depth and height of the prism; 0 for what fits, in proportion to those that are given.
  std::array<double, 3> size = {0, 0, 0};
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_FLOOR_MAP_OPTIONS_H
