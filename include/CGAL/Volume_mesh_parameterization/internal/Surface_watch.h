// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_WATCH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_WATCH_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/AABB_types.h>
#include <CGAL/Volume_mesh_parameterization/internal/Carriers_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>
#include <CGAL/Volume_mesh_parameterization/internal/Surface_attraction.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Keeps the boundary of a hexahedral mesh near to the surface that its nodes move on: corners at rims get better the more
// surface their hexahedra cut off. The middles of quadrilaterals and of their sides, and the points of the surface, have to be
// as near as they are, or as is enough. Tells what is far: tips, creases, and what chords cut off.
template <typename ConcurrencyTag>
class Surface_watch {
  using Vector = Eigen::Vector3d;
  using Nodes = std::vector<Vector>;
  using Quadrilateral = std::array<std::size_t, 4>;

public:
  // `greatest_distance` is in mean lengths of the sides. Then start().
  Surface_watch(std::vector<Quadrilateral> boundary, Carriers_3::Handle surface, Nodes surface_points,
                std::size_t number_of_nodes, double greatest_distance)
      : m_boundary(std::move(boundary)),
        m_surface(surface),
        m_surface_points(std::move(surface_points)),
        m_stars(number_of_nodes, m_boundary.size(), [this](std::size_t q) { return m_boundary[q]; }),
        m_allowed(greatest_distance) {}

  // How near nodes and middles have to be.
  double enough() const { return m_enough; }

  // Takes the present distances for those that may be.
  void start(const Nodes& nodes) {
    constexpr double enough = 0.8, too_far = 0.9; // other points are farther; sides become shorter
    m_side = mean_side(nodes);
    m_enough = enough * m_allowed * m_side;
    m_too_far = too_far * m_allowed * m_side;
    m_greatest.resize(m_boundary.size());
    for_each_index<ConcurrencyTag>(m_boundary.size(), [&](std::size_t k) {
      m_greatest[k] = (std::max)(m_enough, distance(m_boundary[k], nodes));
    });
    m_watched.assign(m_boundary.size(), {});
  }

  // The same for points of the surface, which are not looked after without that.
  void keep_covered(const Nodes& nodes) {
    for (const Far_point& p : far_points(nodes, 0))
      m_watched[p.quadrilateral()].push_back({p.point, (std::max)(m_too_far, p.distance())});
  }

  // Whether no quadrilateral at node v is too far from the surface, nor the surface from these.
  bool accepts(std::size_t v, const Nodes& nodes) const {
    for (std::size_t k : m_stars[v]) {
      const Quadrilateral& q = m_boundary[k];
      const auto place = std::find(q.begin(), q.end(), v) - q.begin();
      for (const Vector& p : {middle(q, nodes), side_middle(q, int(place), nodes)})
        if (!Carriers_3::is_near(m_surface, p, m_greatest[k])) return false;
    }
    for (std::size_t k : m_stars[v])
      for (const Watched& w : m_watched[k])
        if (!is_near(v, nodes, k, w)) return false;
    return true;
  }

  // What was farther at node v than is enough must not return there.
  void take_note(std::size_t v, const Nodes& nodes) {
    for (std::size_t k : m_stars[v]) {
      if (m_greatest[k] > m_enough)
        m_greatest[k] = (std::min)(m_greatest[k], (std::max)(m_enough, distance(m_boundary[k], nodes)));
      for (Watched& w : m_watched[k])
        if (w.greatest > m_too_far)
          w.greatest = (std::max)(m_too_far, std::sqrt(squared_distance_around(v, nodes, w.point)));
    }
  }

  // How far points of the surface, and middles in the end, may be.
  double too_far() const { return m_too_far; }

  // Points of the quadrilaterals and places on the surface that are far from each other: what the points of the surface are
  // nearest to, and the middles of quadrilaterals and sides. These are drawn along the normal, if that is not much farther: the
  // nearest place may be on the wrong side of what a chord cuts off.
  std::vector<Attraction> attractions(const Nodes& nodes) const {
    constexpr double least_share = 0.5; // of what is too far
    const double least = least_share * m_too_far;
    std::vector<Attraction> result;
    for (const Far_point& p : far_points(nodes, least))
      result.push_back({m_boundary[p.quadrilateral()], weights(p, nodes), p.point, p.distance()});
    std::vector<std::array<Vector, 5>> feet(m_boundary.size());
    for_each_index<ConcurrencyTag>(m_boundary.size(), [&](std::size_t k) { feet[k] = feet_of_middles(m_boundary[k], nodes); });
    for (std::size_t k = 0; k < m_boundary.size(); ++k) {
      const auto middles = this->middles(m_boundary[k], nodes);
      for (int i = 0; i < 5; ++i)
        if (const double distance = (feet[k][i] - middles[i]).norm(); distance >= least)
          result.push_back({m_boundary[k], middle_weights[i], place(middles[i], feet[k][i], normal(m_boundary[k], nodes)), distance});
    }
    return result;
  }

  // How much farther than is allowed the two surfaces are from each other, in mean sides.
  double excess(const std::vector<Attraction>& attractions) const {
    double greatest = m_too_far;
    for (const Attraction& a : attractions) greatest = (std::max)(greatest, a.distance);
    return (greatest - m_too_far) / m_side;
  }

private:
  using Kernel = Simple_cartesian<double>;
  using Triangles = AABB_types<Kernel>::Triangles;
  using Tree = AABB_types<Kernel>::Tree<AABB_types<Kernel>::Triangle_primitive>;

  // A point of the surface, and the nearest point of the nearest quarter of a quadrilateral.
  struct Far_point {
    Vector point, foot;
    std::size_t quarter;

    double distance() const { return (point - foot).norm(); }
    std::size_t quadrilateral() const { return quarter / 4; }
  };

  // A point of the surface, and how far it may be.
  struct Watched {
    Vector point;
    double greatest;
  };

  double mean_side(const Nodes& nodes) const {
    double length = 0;
    for (const Quadrilateral& q : m_boundary)
      for (int i = 0; i < 4; ++i) length += (nodes[q[i]] - nodes[q[(i + 1) % 4]]).norm();
    return length / (4. * double(m_boundary.size()));
  }

  // Points of the surface that are at least `distance` away from the quadrilaterals, with the nearest of these.
  std::vector<Far_point> far_points(const Nodes& nodes, double distance) const {
    Triangles triangles;
    for (const Quadrilateral& q : m_boundary)
      for (int i = 0; i < 4; ++i) triangles.push_back(quarter(q, i, nodes));
    Tree tree(triangles.cbegin(), triangles.cend());
    tree.accelerate_distance_queries();
    std::vector<Far_point> result(m_surface_points.size());
    for_each_index<ConcurrencyTag>(result.size(), [&](std::size_t i) {
      const Kernel::Point_3 p = to_point(m_surface_points[i]);
      const auto foot = tree.closest_point_and_primitive(p);
      result[i] = {m_surface_points[i], to_vector(foot.first), std::size_t(foot.second - triangles.cbegin())};
    });
    result.erase(std::remove_if(result.begin(), result.end(), [&](const Far_point& p) { return p.distance() < distance; }),
                 result.end());
    return result;
  }

  // Whether a quadrilateral at node v is near enough to a point of the surface; k is likely to be.
  bool is_near(std::size_t v, const Nodes& nodes, std::size_t k, const Watched& w) const {
    const auto is_near_to = [&](std::size_t q) {
      for (int i = 0; i < 4; ++i)
        if (CGAL::squared_distance(to_point(w.point), quarter(m_boundary[q], i, nodes)) <= w.greatest * w.greatest)
          return true;
      return false;
    };
    return is_near_to(k) || std::any_of(m_stars[v].begin(), m_stars[v].end(), is_near_to);
  }

  // From p to the quadrilaterals at node v.
  double squared_distance_around(std::size_t v, const Nodes& nodes, const Vector& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k : m_stars[v])
      for (int i = 0; i < 4; ++i)
        least = (std::min)(least, CGAL::squared_distance(to_point(p), quarter(m_boundary[k], i, nodes)));
    return least;
  }

  static Kernel::Point_3 to_point(const Vector& p) { return {p.x(), p.y(), p.z()}; }
  static Vector to_vector(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

  // One of four triangles around the middle of a quadrilateral.
  static Kernel::Triangle_3 quarter(const Quadrilateral& q, int i, const Nodes& nodes) {
    return {to_point(nodes[q[i]]), to_point(nodes[q[(i + 1) % 4]]), to_point(middle(q, nodes))};
  }

  // Of the nodes of the quadrilateral, whose mean is the foot.
  std::array<double, 4> weights(const Far_point& p, const Nodes& nodes) const {
    const Quadrilateral& q = m_boundary[p.quadrilateral()];
    const int i = int(p.quarter % 4), j = (i + 1) % 4;
    const Vector a = nodes[q[i]] - p.foot, b = nodes[q[j]] - p.foot, c = middle(q, nodes) - p.foot;
    const Vector normal = (b - a).cross(c - a);
    const double area = normal.squaredNorm();
    const double of_a = area > 0 ? b.cross(c).dot(normal) / area : 1. / 3, of_b = area > 0 ? c.cross(a).dot(normal) / area : 1. / 3;
    std::array<double, 4> result;
    result.fill((1 - of_a - of_b) / 4);
    result[i] += of_a;
    result[j] += of_b;
    return result;
  }

  // Where on the surface a middle is drawn to.
  Vector place(const Vector& middle, const Vector& foot, const Vector& normal) const {
    constexpr double most_ratio = 3; // of the way along the normal to the shortest
    const std::optional<Vector> exit = Carriers_3::find_exit(m_surface, middle, normal);
    return exit && (*exit - middle).norm() < most_ratio * (foot - middle).norm() ? *exit : foot;
  }

  static Vector normal(const Quadrilateral& q, const Nodes& nodes) {
    return (nodes[q[2]] - nodes[q[0]]).cross(nodes[q[3]] - nodes[q[1]]);
  }

  static Vector middle(const Quadrilateral& q, const Nodes& nodes) {
    return (nodes[q[0]] + nodes[q[1]] + nodes[q[2]] + nodes[q[3]]) / 4;
  }
  // Of the side after a vertex: each side at a node is that of one quadrilateral there.
  static Vector side_middle(const Quadrilateral& q, int i, const Nodes& nodes) {
    return (nodes[q[i]] + nodes[q[(i + 1) % 4]]) / 2;
  }
  static std::array<Vector, 5> middles(const Quadrilateral& q, const Nodes& nodes) {
    return {middle(q, nodes), side_middle(q, 0, nodes), side_middle(q, 1, nodes), side_middle(q, 2, nodes),
            side_middle(q, 3, nodes)};
  }

  // Of the nodes in middles().
  static constexpr std::array<double, 4> middle_weights[] = {
      {0.25, 0.25, 0.25, 0.25}, {0.5, 0.5, 0, 0}, {0, 0.5, 0.5, 0}, {0, 0, 0.5, 0.5}, {0.5, 0, 0, 0.5}};

  // The nearest points of the surface.
  std::array<Vector, 5> feet_of_middles(const Quadrilateral& q, const Nodes& nodes) const {
    std::array<Vector, 5> result = middles(q, nodes);
    for (Vector& p : result) p = Carriers_3::project(m_surface, p).point;
    return result;
  }

  // Of the middles from the surface.
  double distance(const Quadrilateral& q, const Nodes& nodes) const {
    const std::array<Vector, 5> from = middles(q, nodes), to = feet_of_middles(q, nodes);
    double greatest = 0;
    for (int i = 0; i < 5; ++i) greatest = (std::max)(greatest, (to[i] - from[i]).norm());
    return greatest;
  }

  std::vector<Quadrilateral> m_boundary;
  Carriers_3::Handle m_surface;
  Nodes m_surface_points;
  Incidence_lists<std::size_t, std::size_t> m_stars; // the quadrilaterals around each node
  std::vector<double> m_greatest;                    // distance that each quadrilateral may have
  std::vector<std::vector<Watched>> m_watched;       // points of the surface that each quadrilateral is nearest to
  double m_allowed;                                  // distance in mean sides
  double m_side = 0;                                 // the mean length at the start
  double m_enough = 0, m_too_far = 0;                // for middles, for points of the surface
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_WATCH_H
