// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_POLYGON_SOUP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_POLYGON_SOUP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMesh

is a surface of planar polygons as lists of points and of vertex numbers: what files hold, manifold or not.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
struct Polygon_soup_3 {
  using Point_3 = Point; ///< the point type

  std::vector<Point> points;                      ///< the vertices
  std::vector<std::vector<std::size_t>> polygons; ///< vertex numbers, in order around each polygon
  std::vector<int> labels; ///< one for each polygon, or empty
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_POLYGON_SOUP_3_H
