// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_RIM_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_RIM_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A loop of the border of the floor, counterclockwise in the plane, as the rim of a rectangle.
struct Floor_rim {
  using Id = Refined_surface::Id;

  std::vector<Id> loop;      // starts with the left end of the rim
  std::size_t right_end = 0; // place in the loop of the right end; the lower half lies before it
  std::array<std::size_t, 4>
      corners{}; // places in the loop: lower left, lower right, upper right, upper left

  // A rim whose corners are given; its ends lie in the middle of the left and the right side.
  static Floor_rim with_corners(std::vector<Id> loop, const std::array<Id, 4>& corners) {
    Floor_rim rim;
    rim.loop = std::move(loop);
    const auto rotate_to = [&](Id v) {
      std::rotate(rim.loop.begin(), std::find(rim.loop.begin(), rim.loop.end(), v), rim.loop.end());
      for (int k = 0; k < 4; ++k)
        rim.corners[k] = std::find(rim.loop.begin(), rim.loop.end(), corners[k]) - rim.loop.begin();
    };
    rotate_to(corners[3]);
    rotate_to(rim.loop[rim.corners[0] / 2]);
    rim.right_end = (rim.corners[1] + rim.corners[2]) / 2;
    return rim;
  }

  Id left() const { return loop[0]; }
  Id right() const { return loop[right_end]; }
  Id corner(int k) const { return loop[corners[k % 4]]; }
  bool has_corners_of(const Floor_rim& rim) const {
    return corner(0) == rim.corner(0) && corner(1) == rim.corner(1) && corner(2) == rim.corner(2) &&
           corner(3) == rim.corner(3);
  }

  // The vertices from corner k to corner k + 1: 0 is the bottom, 1 the right side, 2 the top, 3 the left side.
  std::vector<Id> side(int k) const {
    std::vector<Id> vertices;
    for (std::size_t i = corners[k % 4]; i != corners[(k + 1) % 4]; i = (i + 1) % loop.size())
      vertices.push_back(loop[i]);
    vertices.push_back(corner(k + 1));
    return vertices;
  }

  // Adds a vertex between two neighbors.
  void insert(Id v, Id w, Id middle) {
    std::size_t i = std::find(loop.begin(), loop.end(), v) - loop.begin();
    if (loop[(i + 1) % loop.size()] != w) i = std::find(loop.begin(), loop.end(), w) - loop.begin();
    loop.insert(loop.begin() + i + 1, middle);
    right_end += right_end > i;
    for (std::size_t& corner : corners) corner += corner > i;
  }
};

// The loops of the border, each with the surface on its left, ordered and started by coordinates.
inline std::vector<Floor_rim> find_rims(const Refined_surface& surface) {
  std::vector<Floor_rim> rims;
  std::vector<char> is_seen(surface.number_of_vertices(), 0);
  for (Refined_surface::Id start = 0; start < surface.number_of_half_edges(); ++start) {
    if (!surface.is_border(start) || is_seen[surface.source(start)]) continue;
    rims.emplace_back();
    for (Refined_surface::Id v = surface.source(start); !is_seen[v];
         v = surface.target(surface.outgoing(v))) {
      is_seen[v] = 1;
      rims.back().loop.push_back(v);
    }
  }
  const auto comes_before = [&](Refined_surface::Id v, Refined_surface::Id w) {
    return internal::comes_before(v, w, [&](Refined_surface::Id u) { return surface.points()[u]; });
  };
  for (Floor_rim& rim : rims)
    std::rotate(rim.loop.begin(), std::min_element(rim.loop.begin(), rim.loop.end(), comes_before), rim.loop.end());
  std::sort(rims.begin(), rims.end(),
            [&](const Floor_rim& a, const Floor_rim& b) { return comes_before(a.loop[0], b.loop[0]); });
  return rims;
}

inline double loop_length(const Refined_surface& surface, const Floor_rim& rim) {
  return surface.length(rim.loop) + surface.length(rim.loop.back(), rim.loop.front());
}

// Bisects the edges of the rim until it has enough vertices.
inline void refine_rim(Refined_surface& surface, std::size_t size, Floor_rim& rim) {
  while (rim.loop.size() < size) {
    std::vector<Refined_surface::Id> refined;
    for (Refined_surface::Id v : rim.loop) {
      refined.push_back(v);
      refined.push_back(surface.bisect(surface.outgoing(v)));
    }
    rim.loop.swap(refined);
  }
}

// Chooses the ends and the corners of a rim where its positions are extreme, but always in the right order, with at
// least one vertex inside each side: the ends are inside the left and the right one. A right angle of the rim is worth
// `angle_weight` halves of the box for a corner.
class Corner_chooser {
public:
  Corner_chooser(const std::vector<Double_kernel::Point_2>& positions, double angle_weight, Floor_rim& rim)
      : m_positions(positions), m_angle_weight(angle_weight), m_rim(rim) {
    find_box();
    const std::size_t size = rim.loop.size(), half = least_size / 2;
    std::rotate(rim.loop.begin(), rim.loop.begin() + best_place(0, size, &Corner_chooser::left),
                rim.loop.end());
    const std::size_t right = best_place(half, size - half + 1, &Corner_chooser::right);
    rim.right_end = right;
    rim.corners[0] = best_corner(1, right - 2, &Corner_chooser::lower_left);
    rim.corners[1] = best_corner(rim.corners[0] + 2, right, &Corner_chooser::lower_right);
    rim.corners[2] = best_corner(right + 1, size - 2, &Corner_chooser::upper_right);
    rim.corners[3] = best_corner(rim.corners[2] + 2, size, &Corner_chooser::upper_left);
  }

  static constexpr std::size_t least_size = 8; // of the rim

private:
  using Score = double (*)(double x, double y); // coordinates relative to the box, between -1 and 1

  // of points equally far on one side the one in its middle
  static double left(double x, double y) { return -x - std::abs(y) / 2; }
  static double right(double x, double y) { return x - std::abs(y) / 2; }
  static double lower_left(double x, double y) { return -x - y; }
  static double lower_right(double x, double y) { return x - y; }
  static double upper_right(double x, double y) { return x + y; }
  static double upper_left(double x, double y) { return y - x; }

  void find_box() {
    for (int axis = 0; axis < 2; ++axis) {
      const auto less = [&](auto v, auto w) { return m_positions[v][axis] < m_positions[w][axis]; };
      const auto ends = std::minmax_element(m_rim.loop.begin(), m_rim.loop.end(), less);
      const double low = m_positions[*ends.first][axis], high = m_positions[*ends.second][axis];
      m_center[axis] = (low + high) / 2;
      m_half[axis] = high > low ? (high - low) / 2 : 1;
    }
  }

  std::size_t best_place(std::size_t begin, std::size_t end, Score score) const {
    return best_of(begin, end, [&](std::size_t i) { return value(i, score); });
  }
  std::size_t best_corner(std::size_t begin, std::size_t end, Score score) const {
    return best_of(begin, end, [&](std::size_t i) {
      return value(i, score) + m_angle_weight * (std::min)(1., turn(i) / (CGAL_PI / 2));
    });
  }

  double value(std::size_t i, Score score) const {
    const Double_kernel::Point_2& p = position(i);
    return score((p.x() - m_center[0]) / m_half[0], (p.y() - m_center[1]) / m_half[1]);
  }

  // The angle by which the rim turns to the left there.
  double turn(std::size_t i) const {
    const std::size_t n = m_rim.loop.size();
    const auto u = position(i) - position((i + n - 1) % n), v = position((i + 1) % n) - position(i);
    return std::atan2(u.x() * v.y() - u.y() * v.x(), u * v);
  }

  const Double_kernel::Point_2& position(std::size_t i) const { return m_positions[m_rim.loop[i]]; }

  template <typename Value>
  static std::size_t best_of(std::size_t begin, std::size_t end, const Value& value) {
    std::size_t best = begin;
    for (std::size_t i = begin; i < end; ++i)
      if (value(i) > value(best) + rounding_share) best = i;
    return best;
  }

  const std::vector<Double_kernel::Point_2>& m_positions;
  const double m_angle_weight;
  Floor_rim& m_rim;
  std::array<double, 2> m_center{}, m_half{};
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_RIM_H
