// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMesh

is a triangle of the boundary of a tetrahedral mesh with its label: 1 floor, 2 ceiling, 3 + k wall k, 0 none.
*/
struct Labelled_facet {
  std::array<std::size_t, 3> vertices; ///< numbers of the three vertices, in any order
  int label = 0;                       ///< 1 floor, 2 ceiling, 3 + k wall k, 0 none
};

/// \ingroup PkgVolumeMeshParameterizationMesh
/// names the labels of the boundary.
enum Boundary_label {
  INTERIOR = 0, ///< no boundary facet, or one without label
  FLOOR = 1,    ///< where curves begin
  CEILING = 2,  ///< where they end
  FIRST_WALL = 3 ///< wall k has the label `FIRST_WALL + k`
};

/*!
\ingroup PkgVolumeMeshParameterizationMesh

is a tetrahedral mesh as lists of points, of quadruples of points and of labelled triangles: what files hold.

\cgalModels{TetrahedralMesh_3}

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
struct Tetrahedron_soup_3 {
  using Point_3 = Point; ///< the point type

  std::vector<Point> points;                     ///< the vertices
  std::vector<std::array<std::size_t, 4>> cells; ///< vertex numbers; the four points are positively oriented
  std::vector<Labelled_facet> facets;            ///< labelled boundary triangles; may be empty

  /// returns the number of points.
  std::size_t number_of_vertices() const { return points.size(); }
  /// returns the number of tetrahedra.
  std::size_t number_of_cells() const { return cells.size(); }
  /// returns a point.
  const Point& point(std::size_t vertex) const { return points[vertex]; }
  /// returns the vertices of a tetrahedron.
  const std::array<std::size_t, 4>& cell(std::size_t c) const { return cells[c]; }
  /// returns `facets`.
  const std::vector<Labelled_facet>& labelled_facets() const { return facets; }
};

namespace internal {

// The vertices of a cell of any model of TetrahedralMesh_3.
template <typename CellVertices>
std::array<std::size_t, 4> vertex_numbers(const CellVertices& v) {
  return {std::size_t(v[0]), std::size_t(v[1]), std::size_t(v[2]), std::size_t(v[3])};
}

// Whether a model of TetrahedralMesh_3 has the optional function `neighbor()`.
template <typename TetrahedralMesh, typename = void>
struct Knows_neighbors : std::false_type {};
template <typename TetrahedralMesh>
struct Knows_neighbors<TetrahedralMesh, std::void_t<decltype(std::size_t(
                                            std::declval<const TetrahedralMesh&>().neighbor(std::size_t(), int())))>>
    : std::true_type {};

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRON_SOUP_3_H
