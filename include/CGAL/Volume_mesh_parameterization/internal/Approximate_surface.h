// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_APPROXIMATE_SURFACE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_APPROXIMATE_SURFACE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Facet_adjacency.h>

#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A closed surface in doubles, to find a partition with: the boundary of a tetrahedral mesh or a triangle soup.
struct Approximate_surface {
  using Point_3 = Double_kernel::Point_3;
  using Vector_3 = Double_kernel::Vector_3;

  template <typename Points>
  Approximate_surface(Facet_adjacency surface_adjacency, const Points& surface_points)
      : adjacency(std::move(surface_adjacency)) {
    points.reserve(surface_points.size());
    for (const auto& p : surface_points) points.push_back(approximate(p));
    areas = facet_areas(adjacency, points);
    total_area = std::accumulate(areas.begin(), areas.end(), 0.);
  }

  // A normal with the length of the facet's area.
  Vector_3 area_vector(Facet_index f) const {
    const auto& t = adjacency.triangle(f);
    return CGAL::cross_product(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]) / 2;
  }

  Facet_adjacency adjacency;
  std::vector<Point_3> points;
  std::vector<double> areas;
  double total_area = 0;
};

template <typename GeomTraits>
Approximate_surface approximate_surface(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  return {boundary_adjacency(mesh), mesh.points()};
}

template <typename Point>
Approximate_surface approximate_surface(const Triangle_soup_3<Point>& soup) {
  std::vector<Facet_adjacency::Triangle> triangles;
  triangles.reserve(soup.triangles.size());
  for (const auto& t : soup.triangles)
    triangles.push_back({Vertex_index(t[0]), Vertex_index(t[1]), Vertex_index(t[2])});
  return {Facet_adjacency(soup.points.size(), std::move(triangles)), soup.points};
}

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_APPROXIMATE_SURFACE_H
