// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CHECK_SURFACE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CHECK_SURFACE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Triangle_adjacency.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Uncertain.h>
#include <CGAL/determinant.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationVerification

checks that the triangles of `soup` are three points each, not on a line.

\tparam Point a point type of a \cgal kernel

\returns `ERROR_EMPTY_MESH`, `ERROR_INDEX_OUT_OF_RANGE`, `ERROR_COORDINATE_NOT_FINITE`, `ERROR_WRONG_PARAMETER` (not one
label for each triangle) or `ERROR_DEGENERATE_TRIANGLE`
*/
template <typename Point>
Status check_triangles(const Triangle_soup_3<Point>& soup) {
  if (soup.triangles.empty()) return {ERROR_EMPTY_MESH, "it has no triangles"};
  if (!soup.labels.empty() && soup.labels.size() != soup.triangles.size())
    return {ERROR_WRONG_PARAMETER, "there are not as many labels as triangles"};
  const Status status = internal::check_coordinates(
      soup.points.size(), [&](std::size_t v) -> const Point& { return soup.points[v]; });
  if (!status.ok()) return status;
  const typename Kernel_traits<Point>::Kernel::Collinear_3 collinear;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    const auto& v = soup.triangles[t];
    const std::string name = "triangle " + std::to_string(t);
    if (std::max({v[0], v[1], v[2]}) >= soup.points.size() || v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
      return {ERROR_INDEX_OUT_OF_RANGE, name + " has the vertices " + std::to_string(v[0]) + ", " +
                                            std::to_string(v[1]) + " and " + std::to_string(v[2]) + " of " +
                                            std::to_string(soup.points.size())};
    if (collinear(soup.points[v[0]], soup.points[v[1]], soup.points[v[2]]))
      return {ERROR_DEGENERATE_TRIANGLE, name};
  }
  return {};
}

namespace internal {

// The numbers of vertices and faces are those of the soup.
template <typename Point>
Surface_mesh<Point> make_surface_mesh(const Triangle_soup_3<Point>& soup) {
  Surface_mesh<Point> mesh;
  using Vertex = typename Surface_mesh<Point>::Vertex_index;
  const auto vertex = [](std::size_t v) { return Vertex(typename Surface_mesh<Point>::size_type(v)); };
  for (const Point& p : soup.points) mesh.add_vertex(p);
  for (const auto& t : soup.triangles) mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  return mesh;
}

template <typename Point>
Status check_intersections(const Surface_mesh<Point>& mesh) {
  using Face = typename Surface_mesh<Point>::Face_index;
  std::vector<std::pair<Face, Face>> pairs;
  Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  if (pairs.empty()) return {};
  for (auto& pair : pairs)
    if (pair.second < pair.first) std::swap(pair.first, pair.second);
  const auto first = *std::min_element(pairs.begin(), pairs.end());
  return {ERROR_SELF_INTERSECTION, "triangles " + std::to_string(std::size_t(first.first)) + " and " +
                                       std::to_string(std::size_t(first.second)) + ", the first of " +
                                       std::to_string(pairs.size()) + " pairs"};
}

// Six times the signed volume inside of a closed surface, in the arithmetic of NT.
template <typename NT, typename Point>
NT sixfold_volume(const Triangle_soup_3<Point>& soup) {
  NT sum(0);
  const auto origin = approximate(soup.points[soup.triangles[0][0]]);
  const auto coordinate = [&](std::size_t v, int i) -> NT { // no expression template of NT
    return NT(approximate(soup.points[v])[i]) - NT(origin[i]);
  };
  for (const auto& t : soup.triangles)
    sum += CGAL::determinant(coordinate(t[0], 0), coordinate(t[0], 1), coordinate(t[0], 2), //
                             coordinate(t[1], 0), coordinate(t[1], 1), coordinate(t[1], 2), //
                             coordinate(t[2], 0), coordinate(t[2], 1), coordinate(t[2], 2));
  return sum;
}

template <typename Point>
bool is_inward_oriented(const Triangle_soup_3<Point>& soup) {
  const Uncertain<Sign> sign = CGAL::sign(sixfold_volume<Interval_nt<>>(soup));
  return (is_certain(sign) ? sign.make_certain() : CGAL::sign(sixfold_volume<Exact_rational>(soup))) ==
         NEGATIVE;
}

template <typename Triangles>
void reverse(Triangles& triangles, const std::vector<char>& is_reversed) {
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (is_reversed[t]) std::swap(triangles[t][1], triangles[t][2]);
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationVerification

checks that `soup` is a closed orientable connected 2-manifold, in \f$ O(n \log n) \f$. Orientations need not agree.

\tparam Point a point type of a \cgal kernel

\param soup triangles as `check_triangles()` accepts them
\param is_reversed receives for each triangle whether it is oriented against the first one

\returns `ERROR_OPEN_SURFACE`, `ERROR_NON_MANIFOLD` (an edge in three triangles, a vertex at which two parts touch, or
one side only) or `ERROR_SEVERAL_COMPONENTS`
*/
template <typename Point>
Status check_closed_manifold(const Triangle_soup_3<Point>& soup, std::vector<char>& is_reversed) {
  internal::Triangle_adjacency adjacency(soup.triangles);
  Status status = adjacency.assign_neighbors();
  if (status.ok()) status = adjacency.check_vertices(soup.points.size());
  if (!status.ok()) return status;
  const std::size_t n = adjacency.number_of_components();
  if (n > 1) return {ERROR_SEVERAL_COMPONENTS, "the surface has " + std::to_string(n) + " components"};
  return adjacency.find_reversed(is_reversed);
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

checks that `soup` bounds a solid, and turns its triangles to be counterclockwise seen from outside. Nothing else is
altered; on failure nothing is. All decisions are exact if the predicates of the kernel are.

\tparam Point a point type of a \cgal kernel

\returns the errors of `check_triangles()` and `check_closed_manifold()`, or `ERROR_SELF_INTERSECTION`, each with the
first culprit
*/
template <typename Point>
Status check_surface(Triangle_soup_3<Point>& soup) {
  Status status = check_triangles(soup);
  std::vector<char> is_reversed;
  if (status.ok()) status = check_closed_manifold(soup, is_reversed);
  if (!status.ok()) return status;
  Triangle_soup_3<Point> oriented = soup;
  internal::reverse(oriented.triangles, is_reversed);
  status = internal::check_intersections(internal::make_surface_mesh(oriented));
  if (!status.ok()) return status;
  if (internal::is_inward_oriented(oriented))
    internal::reverse(oriented.triangles, std::vector<char>(soup.triangles.size(), 1));
  soup = std::move(oriented);
  return {};
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

returns the genus of a surface that `check_surface()` accepts, from its Euler number; points that are in no triangle do
not count.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
int genus(const Triangle_soup_3<Point>& soup) {
  std::vector<char> is_used(soup.points.size(), 0);
  for (const auto& triangle : soup.triangles)
    for (std::size_t v : triangle) is_used[v] = 1;
  const auto vertices = std::count(is_used.begin(), is_used.end(), 1);
  return int(1 - (vertices - std::ptrdiff_t(soup.triangles.size() / 2)) / 2); // V - E + F with 2 E = 3 F
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CHECK_SURFACE_H
