// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_REMESH_THIN_TRIANGLES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_REMESH_THIN_TRIANGLES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/check_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Tetgen_mesher.h>
#include <CGAL/Volume_mesh_parameterization/internal/Flat_parts.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMesh

returns the share of the area of a surface that is in triangles more than ten times as long as high.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
double share_of_thin_triangles(const Triangle_soup_3<Point>& surface) {
  constexpr double most = 10; // length over height
  double thin = 0, all = 0;
  for (const auto& t : surface.triangles) {
    const auto p = internal::approximate(surface.points[t[0]]),
               q = internal::approximate(surface.points[t[1]]),
               r = internal::approximate(surface.points[t[2]]);
    const double area = std::sqrt(CGAL::squared_area(p, q, r));
    const double longest = (std::max)(
        {CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)});
    all += area;
    if (longest > 2 * most * area) thin += area;
  }
  return thin / all;
}

/*!
\ingroup PkgVolumeMeshParameterizationMesh

gives a surface of thin triangles, as CAD systems write them, well-shaped ones: tetrahedra on thin triangles are thin, and
leave a map no room. The shape stays, up to rounding: triangles are cut; those that share edges, lie in a plane and have the
same label are cut anew together. The points that it had come first, then those added, a few of which are inside of the solid
and in no triangle. A surface with less than 10 % of thin triangles by area stays as it is.

Needs TetGen 1.5 as `tetrahedralize()` does.

\tparam Point a point type of a \cgal kernel

\param surface a surface that `check_surface()` accepted; on failure it is left as it was

\returns `ERROR_TETRAHEDRALIZATION`, `ERROR_MISSING_LIBRARY`, the errors of `check_surface()`
*/
template <typename Point>
Status remesh_thin_triangles(Triangle_soup_3<Point>& surface) {
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN
  constexpr double most = 0.1;
  if (share_of_thin_triangles(surface) < most) return {};
  Triangle_soup_3<Point> parts = surface, remeshed;
  std::vector<int> part_labels;
  parts.labels = internal::Flat_parts<Point>(surface).parts();
  for (std::size_t t = 0; t < parts.labels.size(); ++t) {
    part_labels.resize((std::max)(part_labels.size(), std::size_t(parts.labels[t]) + 1));
    part_labels[parts.labels[t]] = surface.labels.empty() ? 0 : surface.labels[t];
  }
  Status status = internal::Tetgen_mesher<Point>(parts).remesh(remeshed);
  if (status.ok()) status = check_surface(remeshed);
  if (!status.ok()) return status;
  for (int& label : remeshed.labels) label = part_labels[label];
  if (surface.labels.empty()) remeshed.labels.clear();
  surface = std::move(remeshed);
  return status;
#else
  static_cast<void>(surface);
  return {ERROR_MISSING_LIBRARY, "TetGen, to cut thin triangles"};
#endif
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_REMESH_THIN_TRIANGLES_H
