// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CHECK_TETRAHEDRAL_MESH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CHECK_TETRAHEDRAL_MESH_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Vertex_stars.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>
#include <CGAL/Volume_mesh_parameterization/internal/remove_unused_points.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMesh

turns every cell of `soup` around if all of them are negatively oriented, as some programs write them; otherwise does
nothing.

\tparam Point a point type of a \cgal kernel

\returns whether the cells were turned around
*/
template <typename Point>
bool orient_cells(Tetrahedron_soup_3<Point>& soup) {
  const typename Kernel_traits<Point>::Kernel::Orientation_3 orientation;
  const std::vector<Point>& p = soup.points;
  const auto is_negative = [&](const std::array<std::size_t, 4>& v) {
    return std::all_of(
               v.begin(), v.end(),
               [&](std::size_t i) { return i < p.size() && internal::has_finite_coordinates(p[i]); }) &&
           orientation(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) == NEGATIVE;
  };
  if (soup.cells.empty() || !std::all_of(soup.cells.begin(), soup.cells.end(), is_negative)) return false;
  for (auto& cell : soup.cells) std::swap(cell[2], cell[3]);
  return true;
}

/*!
\ingroup PkgVolumeMeshParameterizationMesh

removes the points that are in no tetrahedron and no labelled facet; the others keep their order.

\tparam Point a point type of a \cgal kernel
\pre all vertex numbers are in range
*/
template <typename Point>
void remove_isolated_points(Tetrahedron_soup_3<Point>& soup) {
  internal::remove_unused_points(soup.points, [&](const auto& visit) {
    for (auto& cell : soup.cells)
      for (std::size_t& v : cell) visit(v);
    for (Labelled_facet& facet : soup.facets)
      for (std::size_t& v : facet.vertices) visit(v);
  });
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

checks that coordinates are finite and that each cell is positively oriented, by the predicate of the kernel.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\returns `ERROR_COORDINATE_NOT_FINITE`, `ERROR_FLAT_TETRAHEDRON` or `ERROR_INVERTED_TETRAHEDRON`
*/
template <typename GeomTraits>
Status check_orientations(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  const Status status = internal::check_coordinates(
      mesh.number_of_vertices(), [&](std::size_t v) -> decltype(auto) { return mesh.point(v); });
  if (!status.ok()) return status;
  const typename GeomTraits::Orientation_3 orientation;
  for (Cell_index c : mesh.cells()) {
    const auto& v = mesh.cell(c);
    const Orientation sign =
        orientation(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]));
    if (sign != POSITIVE)
      return {sign == ZERO ? ERROR_FLAT_TETRAHEDRON : ERROR_INVERTED_TETRAHEDRON,
              "tetrahedron " + std::to_string(c) + " with vertices " + std::to_string(v[0]) + ", " +
                  std::to_string(v[1]) + ", " + std::to_string(v[2]) + " and " + std::to_string(v[3])};
  }
  return {};
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

checks that the cells are connected through facets, in linear time.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\returns `ERROR_SEVERAL_COMPONENTS`
*/
template <typename GeomTraits>
Status check_connected(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  internal::Disjoint_sets components(mesh.number_of_cells());
  for (Facet_index f : mesh.facets())
    if (!mesh.is_boundary(f)) components.join(mesh.half_facet(f, 0).cell, mesh.half_facet(f, 1).cell);
  const std::size_t n = components.number_of_sets();
  if (n == 1) return {};
  return {ERROR_SEVERAL_COMPONENTS,
          "the tetrahedra form " + std::to_string(n) + " parts that share no facet"};
}

namespace internal {

// Numbers the corners of the cells and joins those at the same vertex of neighboring cells.
template <typename GeomTraits>
Disjoint_sets connected_corners(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  Disjoint_sets corners(4 * mesh.number_of_cells());
  for (Facet_index f : mesh.facets()) {
    if (mesh.is_boundary(f)) continue;
    const Half_facet h = mesh.half_facet(f, 0), o = mesh.half_facet(f, 1);
    for (int i = 0; i < 4; ++i)
      if (i != h.index) corners.join(4 * h.cell + i, 4 * o.cell + mesh.index(o.cell, mesh.vertex(h.cell, i)));
  }
  return corners;
}

template <typename GeomTraits>
Status check_links_connected(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  const Disjoint_sets corners = connected_corners(mesh);
  std::vector<int> parts(mesh.number_of_vertices(), 0);
  for (Cell_index c : mesh.cells())
    for (int i = 0; i < 4; ++i) parts[mesh.vertex(c, i)] += corners.is_representative(4 * c + i);
  for (Vertex_index v : mesh.vertices())
    if (parts[v] != 1)
      return {ERROR_NON_MANIFOLD,
              "vertex " + std::to_string(v) +
                  (parts[v] == 0 ? " is in no tetrahedron"
                                 : " joins " + std::to_string(parts[v]) +
                                       " groups of tetrahedra that share no facet there")};
  return {};
}

template <typename GeomTraits>
std::vector<char> vertices_on_boundary(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  std::vector<char> on_boundary(mesh.number_of_vertices(), 0);
  for (Facet_index f : mesh.boundary_facets())
    for (Vertex_index v : mesh.vertices(f)) on_boundary[v] = 1;
  return on_boundary;
}

// The Euler number of the link of each vertex: edges at the vertex - facets at it + cells at it.
template <typename GeomTraits>
std::vector<int> link_euler_numbers(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  std::vector<int> euler(mesh.number_of_vertices(), 0);
  const Vertex_stars stars(mesh);
  std::vector<Vertex_index> counted_for(mesh.number_of_vertices());
  for (Vertex_index v : mesh.vertices()) {
    counted_for[v] = v;
    for (Cell_index c : stars.cells(v))
      for (Vertex_index w : mesh.cell(c))
        if (std::exchange(counted_for[w], v) != v) ++euler[v];
  }
  for (Facet_index f : mesh.facets())
    for (Vertex_index v : mesh.vertices(f)) --euler[v];
  for (Cell_index c : mesh.cells())
    for (Vertex_index v : mesh.cell(c)) ++euler[v];
  return euler;
}

template <typename GeomTraits>
Status check_link_euler_numbers(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  const std::vector<char> on_boundary = vertices_on_boundary(mesh);
  const std::vector<int> euler = link_euler_numbers(mesh);
  for (Vertex_index v : mesh.vertices())
    if (euler[v] != (on_boundary[v] ? 1 : 2))
      return {ERROR_NON_MANIFOLD, "the link of vertex " + std::to_string(v) + " is no " +
                                      (on_boundary[v] ? "disk" : "sphere") + ": its Euler number is " +
                                      std::to_string(euler[v])};
  return {};
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationVerification

checks that the mesh is a 3-manifold with boundary: that the link of each vertex is a sphere inside and a disk on the
boundary.

A connected link of Euler number 2 without border is a sphere, of 1 with border a disk, even if it might be pinched:
a connected surface has no greater Euler number than that, and taking a pinched surface apart makes it greater.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\returns `ERROR_NON_MANIFOLD`, also for a vertex that is in no tetrahedron
*/
template <typename GeomTraits>
Status check_vertex_links(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  const Status status = internal::check_links_connected(mesh);
  return status.ok() ? internal::check_link_euler_numbers(mesh) : status;
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

checks that the boundary is connected, that is that the solid has no cavity.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\returns `ERROR_SEVERAL_COMPONENTS`
*/
template <typename GeomTraits>
Status check_boundary_connected(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  internal::Disjoint_sets components(mesh.number_of_vertices());
  for (Facet_index f : mesh.boundary_facets())
    for (Vertex_index v : mesh.vertices(f)) components.join(v, mesh.vertices(f)[0]);
  const std::vector<char> on_boundary = internal::vertices_on_boundary(mesh);
  std::size_t n = 0;
  for (Vertex_index v : mesh.vertices()) n += on_boundary[v] && components.is_representative(v);
  if (n == 1) return {};
  return {ERROR_SEVERAL_COMPONENTS,
          "the boundary has " + std::to_string(n) + " components: the solid has a cavity"};
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

checks that the mesh is a connected 3-manifold of positive tetrahedra whose boundary is connected, in almost linear time for
vertices of bounded degree.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: with threads, checks are made at the same
time; the result does not depend on it
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\returns the error of the first check that fails: `check_orientations()`, `check_connected()`, `check_vertex_links()`,
`check_boundary_connected()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits>
Status check_tetrahedral_mesh(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  if (mesh.number_of_cells() == 0) return {ERROR_EMPTY_MESH, "it has no tetrahedra"};
  return internal::try_all<ConcurrencyTag>(
      [&] { return check_orientations(mesh); }, [&] { return check_connected(mesh); },
      [&] { return internal::check_links_connected(mesh); }, [&] { return internal::check_link_euler_numbers(mesh); },
      [&] { return check_boundary_connected(mesh); });
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CHECK_TETRAHEDRAL_MESH_H
