// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MAKE_TRIANGLE_SOUP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MAKE_TRIANGLE_SOUP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/remove_unused_points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMesh

copies a surface into a soup, vertices and faces in the order of its iterators.

\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam NamedParameters a sequence of named parameters
\tparam Point a point type of a \cgal kernel

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map with the point of each vertex}
    \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns `ERROR_NOT_TRIANGULATED`; then `soup` is left as it was
*/
template <typename TriangleMesh, typename Point,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Status make_triangle_soup(const TriangleMesh& mesh, Triangle_soup_3<Point>& soup,
                          const NamedParameters& np = CGAL::parameters::default_values()) {
  const auto point_map =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                   get_const_property_map(CGAL::vertex_point, mesh));
  const auto number = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  Triangle_soup_3<Point> result;
  for (auto v : CGAL::make_range(vertices(mesh))) {
    put(number, v, result.points.size());
    result.points.push_back(get(point_map, v));
  }
  for (auto f : CGAL::make_range(faces(mesh))) {
    std::vector<std::size_t> polygon;
    for (auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh)) polygon.push_back(get(number, v));
    if (polygon.size() != 3)
      return {ERROR_NOT_TRIANGULATED, "face " + std::to_string(result.triangles.size()) + " has " +
                                          std::to_string(polygon.size()) + " vertices"};
    result.triangles.push_back({polygon[0], polygon[1], polygon[2]});
  }
  soup = std::move(result);
  return {};
}

/*!
\ingroup PkgVolumeMeshParameterizationMesh

removes the points that are in no triangle; the others keep their order.

\tparam Point a point type of a \cgal kernel
\pre all vertex numbers are in range
*/
template <typename Point>
void remove_isolated_points(Triangle_soup_3<Point>& soup) {
  internal::remove_unused_points(soup.points, [&](const auto& visit) {
    for (auto& triangle : soup.triangles)
      for (std::size_t& v : triangle) visit(v);
  });
}

/*!
\ingroup PkgVolumeMeshParameterizationMesh

returns the boundary of `mesh` with its labels, seen from outside; triangle `i` is boundary facet `i`.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
Triangle_soup_3<typename GeomTraits::Point_3>
make_boundary_soup(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  Triangle_soup_3<typename GeomTraits::Point_3> soup;
  soup.points = mesh.points();
  for (Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    soup.triangles.push_back({v[0], v[1], v[2]});
    soup.labels.push_back(mesh.label(f));
  }
  remove_isolated_points(soup);
  return soup;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MAKE_TRIANGLE_SOUP_H
