// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_EMBEDDING_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_EMBEDDING_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Floor_cutter.h>
#include <CGAL/Volume_mesh_parameterization/internal/Floor_rim.h>
#include <CGAL/Volume_mesh_parameterization/internal/Rectangle_slicing.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/arrange_rectangles.h>
#include <CGAL/Volume_mesh_parameterization/internal/embed_convex_pieces.h>
#include <CGAL/Volume_mesh_parameterization/internal/relax_axis_aligned_map.h>
#include <CGAL/Volume_mesh_parameterization/internal/tutte_embedding.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Returns how many triangles are not counterclockwise, by exact signs.
inline std::size_t count_flipped(const std::vector<Refined_surface::Triangle>& triangles,
                                 const std::vector<Double_kernel::Point_2>& images) {
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  const auto point = [&](Refined_surface::Id v) { return Kernel::Point_2(images[v].x(), images[v].y()); };
  return std::count_if(triangles.begin(), triangles.end(), [&](const Refined_surface::Triangle& t) {
    return CGAL::orientation(point(t[0]), point(t[1]), point(t[2])) != CGAL::LEFT_TURN;
  });
}

// Which planes stay: left and bottom of the outer rim, as a map may be shifted, all of that rim, or those of holes as well.
enum Fixed_planes { CORNER_PLANES, OUTER_PLANES, ALL_PLANES };

// A floor whose rims are mapped to rectangles one to one.
class Floor_embedding {
public:
  using Id = Refined_surface::Id;
  using Point_2 = Double_kernel::Point_2;

  Refined_surface surface;
  std::vector<Floor_rim> rims;         // the outer one, then the holes
  std::vector<Rectangle_2> rectangles; // of the rims
  std::vector<Point_2> images;

  // Maps the rims to the given rectangles, which are the rims of a base. Refines the surface. The floor is first mapped to
  // rectangles that are separable, if need be, then dragged along with the rims. Scale is that of relax().
  Status embed(const std::vector<Rectangle_2>& given, double scale = 1) {
    rectangles = separated(given);
    Floor_cutter cutter(rectangles, rims, surface);
    Status status = cutter.cut();
    if (!status.ok()) return status;
    std::vector<char> is_fixed;
    cutter.place(images, is_fixed);
    const auto& triangles = surface.triangles();
    const auto area = [&](std::size_t k) {
      return CGAL::area(images[triangles[k][0]], images[triangles[k][1]], images[triangles[k][2]]);
    };
    const auto count = [&] { return count_flipped(triangles, images); };
    status = embed_convex_pieces(triangles, surface.points(), is_fixed, area, count, images);
    if (status.ok()) status = check();
    return status.ok() ? move_to(given, scale) : status;
  }

  // Drags the floor along with its rims to other rectangles, step by step. In between it is relaxed, so that it does not get
  // stuck before it must, and at the start if it is stuck there; on failure all stays as it is.
  Status move_to(const std::vector<Rectangle_2>& goal, double scale = 1) {
    constexpr double least_step = 1. / 64;
    Floor_embedding moved = *this;
    double step = 1;
    bool is_relaxed = false;
    for (double left = 1; moved.rectangles != goal;) { // left of the way
      const double share = std::min(1., step / left);
      Status status = moved.try_step(share < 1 ? between(moved.rectangles, goal, share) : goal);
      if (status.ok()) {
        left -= share * left;
        if (share < 1) moved.relax(ROUGHLY, ALL_PLANES, scale);
        is_relaxed = true;
      } else if (step /= 2; step < least_step) {
        if (is_relaxed) return status;
        moved.relax(ROUGHLY, ALL_PLANES, scale);
        is_relaxed = true;
        step = 1;
      }
    }
    *this = std::move(moved);
    return {};
  }

  void stretch(const std::array<double, 2>& factors) {
    rectangles = scaled(rectangles, factors);
    for (Point_2& p : images) p = Point_2(factors[0] * p.x(), factors[1] * p.y());
  }

  // Less distortion, if the result is still exactly one to one. The shapes at rest are those of the floor times scale. Returns
  // the energy over the area of the floor, infinite if all is as before.
  double relax(Relaxation goal, Fixed_planes fixed = CORNER_PLANES, double scale = 1) {
    const Floor_embedding start = *this;
    std::vector<Double_kernel::Point_3> points;
    for (const auto& p : surface.points()) points.push_back(CGAL::ORIGIN + scale * (p - CGAL::ORIGIN));
    std::vector<std::array<int, 4>> planes_of_rims;
    Axis_aligned_map map = axis_aligned_map(fixed, planes_of_rims);
    const double energy = relax_axis_aligned_map(goal, surface.triangles(), points, map);
    for (Id v = 0; v < images.size(); ++v) images[v] = Point_2(map.images[v].x(), map.images[v].y());
    for (std::size_t r = 0; r < rims.size(); ++r) rectangles[r] = map.rectangle(planes_of_rims[r]);
    if (check().ok()) return energy;
    *this = start;
    return std::numeric_limits<double>::infinity();
  }

private:
  // At level 0. The vertices of a side are on its plane.
  Axis_aligned_map axis_aligned_map(Fixed_planes fixed,
                                    std::vector<std::array<int, 4>>& planes_of_rims) const {
    Axis_aligned_map map;
    for (const Point_2& p : images) map.images.emplace_back(p.x(), p.y(), 0);
    map.frames.assign(surface.number_of_triangles(), Plane_frame());
    map.vertex_planes.assign(images.size(), {map.no_plane, map.no_plane, map.add_plane(2, 0, true)});
    for (std::size_t r = 0; r < rims.size(); ++r) {
      planes_of_rims.push_back(map.add_planes(rectangles[r]));
      for (int k = 0; k < 4; ++k)
        for (Id v : rims[r].side(k)) map.put_on_plane(v, planes_of_rims[r][(k + 1) % 4]);
    }
    fix_planes(fixed, planes_of_rims, map);
    return map;
  }

  static void fix_planes(Fixed_planes fixed, const std::vector<std::array<int, 4>>& planes_of_rims,
                         Axis_aligned_map& map) {
    const int of_outer_rim = fixed == CORNER_PLANES ? 2 : 4;
    for (int k = 0; k < of_outer_rim; ++k) map.planes[planes_of_rims[0][k]].is_fixed = true;
    for (Axis_aligned_map::Plane& plane : map.planes) plane.is_fixed = plane.is_fixed || fixed == ALL_PLANES;
  }

  static std::vector<Rectangle_2> between(std::vector<Rectangle_2> from, const std::vector<Rectangle_2>& to,
                                          double share) {
    for (std::size_t r = 0; r < from.size(); ++r)
      for (int axis = 0; axis < 2; ++axis) {
        from[r].low(axis) += share * (to[r].low(axis) - from[r].low(axis));
        from[r].high(axis) += share * (to[r].high(axis) - from[r].high(axis));
      }
    return from;
  }

  // Moves the rims if the result is one to one; else all stays as it is.
  Status try_step(const std::vector<Rectangle_2>& moved) {
    const Floor_embedding start = *this;
    Status status = move_rims(moved);
    if (status.ok()) status = check();
    if (!status.ok()) *this = start;
    return status;
  }

  // Moves each rim as its rectangle changes, all other vertices by the mean of what their neighbors are moved.
  Status move_rims(const std::vector<Rectangle_2>& moved) {
    std::vector<Point_2> shifts(images.size(), Point_2(0, 0)), placed = images;
    std::vector<char> is_on_rim(images.size(), 0);
    for (std::size_t r = 0; r < rims.size(); ++r)
      for (Id v : rims[r].loop) {
        is_on_rim[v] = 1;
        placed[v] = Point_2(moved_coordinate(images[v], 0, rectangles[r], moved[r]),
                            moved_coordinate(images[v], 1, rectangles[r], moved[r]));
        shifts[v] = CGAL::ORIGIN + (placed[v] - images[v]);
      }
    std::vector<Double_kernel::Point_3> points; // weights of the plane, where shifts are to be smooth
    for (const Point_2& p : images) points.emplace_back(p.x(), p.y(), 0);
    const Status status = tutte_embedding(surface.triangles(), is_on_rim, Mean_value_weights{points}, shifts);
    for (Id v = 0; v < images.size(); ++v)
      images[v] = is_on_rim[v] ? placed[v] : images[v] + (shifts[v] - CGAL::ORIGIN);
    rectangles = moved;
    return status;
  }

  // The sides of one rectangle come exactly to those of the other.
  static double moved_coordinate(const Point_2& p, int axis, const Rectangle_2& from, const Rectangle_2& to) {
    if (p[axis] == from.high(axis)) return to.high(axis);
    const double share = (p[axis] - from.low(axis)) / (from.high(axis) - from.low(axis));
    return to.low(axis) + share * (to.high(axis) - to.low(axis));
  }

  // Positive triangles and a border that runs once along the rims: then the map is one to one, by its degree. Holes that
  // met would have to be covered less than never.
  Status check() const {
    const std::size_t flipped = count_flipped(surface.triangles(), images);
    if (flipped > 0) return {ERROR_FLOOR_MAP, std::to_string(flipped) + " of its triangles are flipped"};
    for (std::size_t r = 0; r < rims.size(); ++r)
      for (int k = 0; k < 4; ++k)
        if (!is_monotone(rims[r].side(k), rectangles[r].corners()[k], rectangles[r].corners()[(k + 1) % 4]))
          return {ERROR_FLOOR_MAP, "side " + std::to_string(k) + " of rim " + std::to_string(r) + " folds"};
    return {};
  }

  bool is_monotone(const std::vector<Id>& side, const std::array<double, 2>& from,
                   const std::array<double, 2>& to) const {
    const int axis = from[0] != to[0] ? 0 : 1;
    const double sign = to[axis] > from[axis] ? 1 : -1;
    for (std::size_t i = 0; i < side.size(); ++i) {
      if (images[side[i]][1 - axis] != from[1 - axis]) return false;
      if (i > 0 && !(sign * images[side[i - 1]][axis] < sign * images[side[i]][axis])) return false;
    }
    return images[side.front()][axis] == from[axis] && images[side.back()][axis] == to[axis];
  }
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_EMBEDDING_H
