// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PILLOW_HEXAHEDRA_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PILLOW_HEXAHEDRA_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_facets.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Numbers the inner copies of boundary vertices behind all vertices; other vertices keep their numbers.
inline std::vector<std::size_t> number_inner_copies(std::size_t number_of_vertices,
                                                    const Hexahedron_facets& facets) {
  std::vector<std::size_t> copy(number_of_vertices);
  for (std::size_t v = 0; v < copy.size(); ++v) copy[v] = v;
  for (const auto& q : facets.boundary)
    for (std::size_t v : q)
      if (copy[v] == v) copy[v] = number_of_vertices++;
  return copy;
}

// For each vertex the mean of the centres of the hexahedra around it. Inside at each vertex of the boundary of a grid.
template <typename Point>
std::vector<Point> mean_centres(const Hexahedron_soup_3<Point>& mesh) {
  using Vector = typename Kernel_traits<Point>::Kernel::Vector_3;
  std::vector<Vector> sums(mesh.points.size(), CGAL::NULL_VECTOR);
  std::vector<int> counts(mesh.points.size(), 0);
  for (const auto& h : mesh.hexahedra) {
    Vector centre = CGAL::NULL_VECTOR;
    for (std::size_t v : h) centre = centre + (mesh.points[v] - CGAL::ORIGIN) / 8;
    for (std::size_t v : h) sums[v] = sums[v] + centre, ++counts[v];
  }
  std::vector<Point> means(mesh.points);
  for (std::size_t v = 0; v < means.size(); ++v)
    if (counts[v] > 0) means[v] = CGAL::ORIGIN + sums[v] / counts[v];
  return means;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

inserts a layer of hexahedra, a pillow, between the boundary of a hexahedral mesh and its inside.

Each boundary quadrilateral gets a hexahedron, behind all others in the list, between itself and the hexahedron which it
belonged to. So no hexahedron has two facets on the boundary, and quality at a rim is no longer that of corners as flat as
the surface is there. The price are irregular edges:
on the inner side of the layer behind the edges of the old mesh, and across the layer at its corners.

Vertices of the boundary keep their numbers and places, hence `mesh.facets` its vertices and labels. Their inner copies
get the numbers behind all others and places a short way inside, where hexahedra of a grid remain positive;
`optimize_hexahedra()` does the rest.

Takes \f$ O(n \log n) \f$ time.

\tparam Point a point type of a \cgal kernel

\returns `ERROR_EMPTY_MESH`, `ERROR_INDEX_OUT_OF_RANGE`, `ERROR_COORDINATE_NOT_FINITE`, or `ERROR_NON_MANIFOLD` if a facet
is in more than two hexahedra or the boundary touches itself; then `mesh` is left as it was
*/
template <typename Point>
Status pillow_hexahedra(Hexahedron_soup_3<Point>& mesh) {
  const Hexahedra_report report = verify_hexahedra(mesh);
  for (Error_code code : {ERROR_EMPTY_MESH, ERROR_INDEX_OUT_OF_RANGE, ERROR_COORDINATE_NOT_FINITE})
    if (report.status.code() == code) return report.status;
  if (report.non_manifold_facets > 0 || !report.boundary_is_manifold)
    return {ERROR_NON_MANIFOLD, "the hexahedra or their boundary"};
  const internal::Hexahedron_facets facets(mesh.hexahedra);
  const std::vector<std::size_t> copy = internal::number_inner_copies(mesh.points.size(), facets);
  const std::vector<Point> centres = internal::mean_centres(mesh);
  for (auto& h : mesh.hexahedra)
    for (std::size_t& v : h) v = copy[v];
  for (const auto& q : facets.boundary) {
    mesh.hexahedra.push_back({copy[q[0]], copy[q[1]], copy[q[2]], copy[q[3]], q[0], q[1], q[2], q[3]});
    for (std::size_t v : q)
      if (copy[v] == mesh.points.size()) mesh.points.push_back(CGAL::midpoint(mesh.points[v], centres[v]));
  }
  return {};
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PILLOW_HEXAHEDRA_H
