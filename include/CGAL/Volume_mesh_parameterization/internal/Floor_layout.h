// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_LAYOUT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_LAYOUT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Floor_rim.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/arrange_rectangles.h>
#include <CGAL/Volume_mesh_parameterization/internal/shortest_path.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Chooses a rectangle for each rim of the floor, to start with: inside of that of the outer rim, but they may overlap.
// Without those of the holes it has the area of the floor.
class Floor_layout {
public:
  using Point_2 = Double_kernel::Point_2;

  // rims[0] is the outer one, all have corners
  Floor_layout(const Refined_surface& surface, const std::vector<Floor_rim>& rims)
      : m_surface(surface), m_rims(rims) {}

  // What counts is measured along the floor: the lengths of the sides of rims and the distances of each hole to the four
  // sides of the outer rim, which tell the width and the depth of the floor at this hole.
  Status measure(std::vector<Rectangle_2>& rectangles) {
    std::array<double, 2> sums = {0, 0};
    rectangles.assign(1, {0, 0, 1, 1});
    for (std::size_t hole = 1; hole < m_rims.size(); ++hole) {
      rectangles.emplace_back();
      for (int axis = 0; axis < 2; ++axis) {
        const Status status = measure(hole, axis, sums[axis], rectangles.back());
        if (!status.ok()) return status;
      }
    }
    const double number_of_holes = double(m_rims.size() - 1);
    for (int axis = 0; axis < 2; ++axis) {
      m_size[axis] = mean_side(0, axis);
      if (number_of_holes > 0) m_size[axis] = (m_size[axis] + sums[axis] / number_of_holes) / 2;
    }
    scale_to_area(rectangles);
    return {};
  }

  // The size as measured, but the boxes of the holes in the plane; false if these are not inside of that of the outer rim.
  bool measure_positions(const std::vector<Point_2>& positions, std::vector<Rectangle_2>& rectangles) const {
    const Rectangle_2 outer = box(m_rims[0], positions);
    rectangles.assign(1, {0, 0, 1, 1});
    for (std::size_t hole = 1; hole < m_rims.size(); ++hole) {
      const Rectangle_2 b = box(m_rims[hole], positions);
      rectangles.push_back({(b.xmin - outer.xmin) / outer.width(), (b.ymin - outer.ymin) / outer.height(),
                            (b.xmax - outer.xmin) / outer.width(), (b.ymax - outer.ymin) / outer.height()});
      for (int axis = 0; axis < 2; ++axis)
        if (!(0 < rectangles[hole].low(axis) && rectangles[hole].low(axis) < rectangles[hole].high(axis) &&
              rectangles[hole].high(axis) < 1))
          return false;
    }
    scale_to_area(rectangles);
    return true;
  }

private:
  // The mean length of side k and its opposite.
  double mean_side(std::size_t rim, int k) const {
    return (m_surface.length(m_rims[rim].side(k)) + m_surface.length(m_rims[rim].side(k + 2))) / 2;
  }

  // Where the hole begins and ends as shares of the extent of the floor along a chain from side to side through it.
  Status measure(std::size_t hole, int axis, double& sum, Rectangle_2& rectangle) const {
    const int low_side = axis == 0 ? 3 : 0, high_side = axis == 0 ? 1 : 2;
    const auto to_low = shortest_path(m_surface, m_rims[hole].side(low_side), m_rims[0].side(low_side));
    const auto to_high = shortest_path(m_surface, m_rims[hole].side(high_side), m_rims[0].side(high_side));
    if (to_low.empty() || to_high.empty())
      return {ERROR_FLOOR_MAP, "rim " + std::to_string(hole) + " is walled in"};
    const double low = m_surface.length(to_low), high = low + mean_side(hole, axis),
                 extent = high + m_surface.length(to_high);
    rectangle.low(axis) = low / extent;
    rectangle.high(axis) = high / extent;
    sum += extent;
    return {};
  }

  static Rectangle_2 box(const Floor_rim& rim, const std::vector<Point_2>& positions) {
    Rectangle_2 result;
    for (int axis = 0; axis < 2; ++axis) {
      const auto less = [&](auto v, auto w) { return positions[v][axis] < positions[w][axis]; };
      const auto ends = std::minmax_element(rim.loop.begin(), rim.loop.end(), less);
      result.low(axis) = positions[*ends.first][axis];
      result.high(axis) = positions[*ends.second][axis];
    }
    return result;
  }

  // From shares of the outer rectangle to a base of the area of the floor.
  void scale_to_area(std::vector<Rectangle_2>& rectangles) const {
    constexpr double least_share = 0.1; // more holes overlap
    double share = 1;
    for (std::size_t hole = 1; hole < rectangles.size(); ++hole) share -= rectangles[hole].area();
    const double scale = std::sqrt(floor_area() / ((std::max)(share, least_share) * m_size[0] * m_size[1]));
    rectangles = scaled(rectangles, {scale * m_size[0], scale * m_size[1]});
  }

  double floor_area() const {
    const auto& p = m_surface.points();
    double area = 0;
    for (const auto& t : m_surface.triangles())
      area += std::sqrt(CGAL::squared_area(p[t[0]], p[t[1]], p[t[2]]));
    return area;
  }

  const Refined_surface& m_surface;
  const std::vector<Floor_rim>& m_rims;
  std::array<double, 2> m_size = {0, 0}; // of the outer rim, but for a factor
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_LAYOUT_H
