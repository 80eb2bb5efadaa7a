// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRON_SOUP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRON_SOUP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

is a quadrilateral of the boundary of a hexahedral mesh with its label.
*/
struct Labelled_quadrilateral {
  std::array<std::size_t, 4> vertices; ///< numbers of the four vertices, around the quadrilateral
  int label = 0;                       ///< 1 floor, 2 ceiling, 3 + k wall k, 0 none
};

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

is a hexahedral mesh as lists of points, of octuples of points and of labelled quadrilaterals: what files hold.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
struct Hexahedron_soup_3 {
  using Point_3 = Point; ///< the point type

  std::vector<Point> points; ///< the vertices
  /// Vertex numbers in the order of MEDIT and VTK: around one quadrilateral, then around the opposite one, which lies
  /// on the side to which the first one turns counterclockwise.
  std::vector<std::array<std::size_t, 8>> hexahedra;
  std::vector<Labelled_quadrilateral> facets; ///< labelled boundary quadrilaterals; may be empty
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRON_SOUP_3_H
