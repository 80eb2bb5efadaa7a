#ifndef VOLUME_MESH_PARAMETERIZATION_SURFACE_TEST_UTIL_H
#define VOLUME_MESH_PARAMETERIZATION_SURFACE_TEST_UTIL_H

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/make_triangle_soup.h>

#include "test_util.h"

#include <CGAL/Kernel_traits.h>

#include <cassert>

// The labelled surface of a Block_with_holes.
template <typename Point>
CGAL::Volume_mesh_parameterization::Triangle_soup_3<Point> block_surface(int holes, int m, int layers) {
  CGAL::Volume_mesh_parameterization::Compact_tetrahedral_mesh_3<typename CGAL::Kernel_traits<Point>::Kernel> mesh;
  const auto status = mesh.assign(Block_with_holes<Point>(holes, m, layers).soup());
  assert(status.ok());
  return make_boundary_soup(mesh);
}

// A block with the middle of its top pulled below its bottom.
template <typename Point>
CGAL::Volume_mesh_parameterization::Triangle_soup_3<Point> self_intersecting_surface() {
  auto soup = block_surface<Point>(0, 2, 2);
  for (Point& p : soup.points)
    if (p == Point(.5, 1.5, 1)) p = Point(.5, 1.5, -1);
  return soup;
}

// The points of the soup twice, at first where they are.
template <typename Soup>
Soup with_doubled_points(const Soup& soup) {
  Soup result = soup;
  for (const auto& p : soup.points) result.points.emplace_back(p.x() + 50, p.y(), p.z());
  return result;
}

#endif // VOLUME_MESH_PARAMETERIZATION_SURFACE_TEST_UTIL_H
