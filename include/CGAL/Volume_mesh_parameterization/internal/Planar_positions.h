// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PLANAR_POSITIONS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PLANAR_POSITIONS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Floor_rim.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>
#include <CGAL/Volume_mesh_parameterization/internal/tutte_embedding.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Rough positions of the floor in the plane, from which corners are chosen: they steer the quality of the floor map,
// never its validity. rims[0] is the outer one.
class Planar_positions {
public:
  using Point_2 = Double_kernel::Point_2;
  using Point_3 = Double_kernel::Point_3;
  using Vector_3 = Double_kernel::Vector_3;

  Planar_positions(const Refined_surface& surface, const std::vector<Floor_rim>& rims)
      : m_surface(surface), m_rims(rims) {}

  // Fails with the linear solver only.
  Status compute(std::vector<Point_2>& positions) const {
    return project(positions) ? Status() : fill_and_embed(positions);
  }

  // Returns directions that may become that of x: the principal axis of the centers of holes, if there are several, and
  // that of the longer side of the smallest box.
  std::vector<double> axes(const std::vector<Point_2>& positions) const {
    constexpr double tolerance = CGAL_PI / 90; // as far as boxes are told apart
    const double of_box = axis_of_box(positions);
    if (m_rims.size() < 3) return {of_box};
    const double of_holes = axis_of_holes(positions),
                 difference = CGAL::abs(std::remainder(of_holes - of_box, CGAL_PI / 2));
    return difference < tolerance ? std::vector<double>{of_holes} : std::vector<double>{of_holes, of_box};
  }

  static std::vector<Point_2> turned(std::vector<Point_2> positions, double axis) {
    const double c = std::cos(axis), s = std::sin(axis);
    for (Point_2& p : positions) p = Point_2(c * p.x() + s * p.y(), c * p.y() - s * p.x());
    return positions;
  }

private:
  // The projection along the mean normal, if next to nothing of the floor is seen from behind, and no rim crosses itself.
  bool project(std::vector<Point_2>& positions) const {
    Vector_3 normal(0, 0, 0);
    for (const auto& t : m_surface.triangles()) normal = normal + area_vector(t);
    if (normal * normal == 0) return false;
    normal = normal / std::sqrt(normal * normal);
    constexpr double tolerated_share = 0.01;
    double front = 0, behind = 0;
    for (const auto& t : m_surface.triangles()) {
      const double area = area_vector(t) * normal;
      (area > 0 ? front : behind) += CGAL::abs(area);
    }
    if (behind > tolerated_share * front) return false;
    const Vector_3 e = least_axis(normal),
                   x = CGAL::cross_product(e, normal) / std::sqrt(1 - (e * normal) * (e * normal));
    const Vector_3 y = CGAL::cross_product(normal, x);
    positions.clear();
    for (const Point_3& p : m_surface.points())
      positions.push_back(Point_2((p - CGAL::ORIGIN) * x, (p - CGAL::ORIGIN) * y));
    return std::all_of(m_rims.begin(), m_rims.end(),
                       [&](const Floor_rim& rim) { return turns_once(rim, positions); });
  }

  // Whether the tangent of a rim turns by about one full turn, as that of a curve that does not cross itself does.
  static bool turns_once(const Floor_rim& rim, const std::vector<Point_2>& positions) {
    const std::size_t n = rim.loop.size();
    const auto edge = [&](std::size_t i) {
      return positions[rim.loop[(i + 1) % n]] - positions[rim.loop[i % n]];
    };
    double turn = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto u = edge(i), v = edge(i + 1);
      turn += std::atan2(u.x() * v.y() - u.y() * v.x(), u * v);
    }
    return CGAL::abs(turn - 2 * CGAL_PI) < CGAL_PI;
  }

  // Fills the holes by cones and maps the disk to a round one.
  Status fill_and_embed(std::vector<Point_2>& positions) const {
    std::vector<Refined_surface::Triangle> triangles = m_surface.triangles();
    std::vector<Point_3> points = m_surface.points();
    for (std::size_t r = 1; r < m_rims.size(); ++r) {
      const std::vector<Refined_surface::Id>& loop = m_rims[r].loop;
      Vector_3 sum(0, 0, 0);
      for (Refined_surface::Id v : loop) sum = sum + (m_surface.points()[v] - CGAL::ORIGIN);
      for (std::size_t i = 0; i < loop.size(); ++i)
        triangles.push_back({loop[i], loop[(i + 1) % loop.size()], Refined_surface::Id(points.size())});
      points.push_back(CGAL::ORIGIN + sum / double(loop.size()));
    }
    positions.assign(points.size(), Point_2(0, 0));
    std::vector<char> is_fixed(points.size(), 0);
    const double turn = 2 * CGAL_PI / loop_length(m_surface, m_rims[0]);
    double arc = 0;
    const std::vector<Refined_surface::Id>& outer = m_rims[0].loop;
    for (std::size_t i = 0; i < outer.size(); ++i) {
      positions[outer[i]] = Point_2(std::cos(arc * turn), std::sin(arc * turn));
      is_fixed[outer[i]] = 1;
      arc += m_surface.length(outer[i], outer[(i + 1) % outer.size()]);
    }
    const Status status = tutte_embedding(triangles, is_fixed, Mean_value_weights{points}, positions);
    positions.resize(m_surface.number_of_vertices());
    return status;
  }

  double axis_of_holes(const std::vector<Point_2>& positions) const {
    std::vector<Point_2> centers;
    double x = 0, y = 0;
    for (std::size_t r = 1; r < m_rims.size(); ++r) {
      centers.push_back(center(m_rims[r], positions));
      x += centers.back().x() / double(m_rims.size() - 1);
      y += centers.back().y() / double(m_rims.size() - 1);
    }
    double xx = 0, xy = 0, yy = 0;
    for (const Point_2& p : centers) {
      xx += (p.x() - x) * (p.x() - x);
      xy += (p.x() - x) * (p.y() - y);
      yy += (p.y() - y) * (p.y() - y);
    }
    const bool is_round = std::hypot(2 * xy, xx - yy) <= rounding_share * (xx + yy);
    return is_round ? 0 : std::atan2(2 * xy, xx - yy) / 2;
  }

  double axis_of_box(const std::vector<Point_2>& positions) const {
    constexpr int directions = 180;
    double best = 0, least_area = std::numeric_limits<double>::infinity();
    for (int k = 0; k < directions; ++k) {
      const double angle = CGAL_PI * k / directions;
      const double width = extent(positions, angle), height = extent(positions, angle + CGAL_PI / 2);
      if (width < (1 - rounding_share) * height || width * height >= (1 - rounding_share) * least_area)
        continue;
      least_area = width * height;
      best = angle;
    }
    return best;
  }

  double extent(const std::vector<Point_2>& positions, double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (Refined_surface::Id v : m_rims[0].loop) {
      const double x = c * positions[v].x() + s * positions[v].y();
      low = std::min(low, x);
      high = std::max(high, x);
    }
    return high - low;
  }

public:
  static Point_2 center(const Floor_rim& rim, const std::vector<Point_2>& positions) {
    double x = 0, y = 0;
    for (Refined_surface::Id v : rim.loop) {
      x += positions[v].x();
      y += positions[v].y();
    }
    return Point_2(x / double(rim.loop.size()), y / double(rim.loop.size()));
  }

private:
  Vector_3 area_vector(const Refined_surface::Triangle& t) const {
    const std::vector<Point_3>& p = m_surface.points();
    return CGAL::cross_product(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]) / 2;
  }

  // of a vector of length 1
  static Vector_3 least_axis(const Vector_3& v) {
    const double x = CGAL::abs(v.x()), y = CGAL::abs(v.y()), z = CGAL::abs(v.z());
    if (x <= y + rounding_share && x <= z + rounding_share) return Vector_3(1, 0, 0);
    return y <= z + rounding_share ? Vector_3(0, 1, 0) : Vector_3(0, 0, 1);
  }

  const Refined_surface& m_surface;
  const std::vector<Floor_rim>& m_rims;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PLANAR_POSITIONS_H
