// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_AXIS_ALIGNED_MAP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_AXIS_ALIGNED_MAP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The two coordinates of a plane orthogonal to an axis, in an order that turns counterclockwise seen from the side
// that the normal points to.
struct Plane_frame {
  std::int8_t first = 0, second = 1;

  // normal_sign is 1 if the normal points along the axis, -1 if against it
  static Plane_frame orthogonal_to(int axis, int normal_sign) {
    const std::int8_t i = std::int8_t((axis + 1) % 3), j = std::int8_t((axis + 2) % 3);
    return normal_sign > 0 ? Plane_frame{i, j} : Plane_frame{j, i};
  }
  int axis() const { return 3 - first - second; }
};

/*
A map of a triangulated surface whose triangles go to planes orthogonal to the axes. A vertex that must stay in a plane
shares its coordinate with all others there; in its other coordinates it may slide.
*/
struct Axis_aligned_map {
  static constexpr int no_plane = -1;
  using Triangle = std::array<std::uint32_t, 3>;
  using Point_3 = Double_kernel::Point_3;

  struct Plane {
    int axis;
    double value;
    bool is_fixed;
  };

  int add_plane(int axis, double value, bool is_fixed) {
    planes.push_back({axis, value, is_fixed});
    return int(planes.size()) - 1;
  }

  // The planes of left, bottom, right and top side. Sides on the same line share a plane.
  std::array<int, 4> add_planes(const Rectangle_2& r) {
    return {plane_at(0, r.xmin), plane_at(1, r.ymin), plane_at(0, r.xmax), plane_at(1, r.ymax)};
  }

  int plane_at(int axis, double value) {
    for (std::size_t p = 0; p < planes.size(); ++p)
      if (planes[p].axis == axis && planes[p].value == value) return int(p);
    return add_plane(axis, value, false);
  }

  Rectangle_2 rectangle(const std::array<int, 4>& p) const {
    return {planes[p[0]].value, planes[p[1]].value, planes[p[2]].value, planes[p[3]].value};
  }

  void put_on_plane(std::uint32_t v, int plane) { vertex_planes[v][planes[plane].axis] = plane; }

  // Where the plane of a coordinate is known, the coordinate is exactly that.
  void snap_to_planes() {
    for (std::size_t v = 0; v < images.size(); ++v) {
      std::array<double, 3> x = {images[v].x(), images[v].y(), images[v].z()};
      for (int axis = 0; axis < 3; ++axis)
        if (vertex_planes[v][axis] != no_plane) x[axis] = planes[vertex_planes[v][axis]].value;
      images[v] = Point_3(x[0], x[1], x[2]);
    }
  }

  double signed_area(const Triangle& t, Plane_frame frame) const {
    const auto point = [&](std::uint32_t v) {
      return Double_kernel::Point_2(images[v][frame.first], images[v][frame.second]);
    };
    return CGAL::area(point(t[0]), point(t[1]), point(t[2]));
  }

  // By exact signs.
  bool is_positive(const Triangle& t, Plane_frame frame) const {
    using Kernel = Exact_predicates_inexact_constructions_kernel;
    const auto point = [&](std::uint32_t v) {
      return Kernel::Point_2(images[v][frame.first], images[v][frame.second]);
    };
    return CGAL::orientation(point(t[0]), point(t[1]), point(t[2])) == CGAL::LEFT_TURN;
  }

  std::size_t count_flipped(const std::vector<Triangle>& triangles) const {
    std::size_t flipped = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t) flipped += !is_positive(triangles[t], frames[t]);
    return flipped;
  }

  std::vector<Plane> planes;
  std::vector<std::array<int, 3>> vertex_planes; // of each vertex, one for each axis
  std::vector<Plane_frame> frames;               // of each triangle
  std::vector<Point_3> images;                   // of each vertex
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_AXIS_ALIGNED_MAP_H
