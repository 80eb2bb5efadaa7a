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

// A place on the surface, and the node that is to be there.
struct Drawn_node {
  std::size_t node;
  Eigen::Vector3d place;
};

// Keeps the boundary of a hexahedral mesh near to the surface that its nodes move on: corners at rims get better the more
// surface their hexahedra cut off. The middles of quadrilaterals and of their sides, and the points of the surface, have to be
// as near as they are, or as is enough. Tells which nodes could cover what is too far: tips, creases, and what chords cut off.
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
      m_watched[p.quadrilateral].push_back({p.point, (std::max)(m_too_far, p.distance)});
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

  // For places on the surface that are too far from the quadrilaterals, or that middles of these are too far from, a node of
  // the quadrilateral and the point of its carrier there; for each node the farthest.
  std::vector<Drawn_node> nodes_to_draw(const Nodes& nodes, const std::vector<Carriers_3::Handle>& carriers) const {
    std::vector<std::pair<double, Vector>> farthest(nodes.size(), {m_too_far, Vector::Zero()});
    for (const Far_point& p : too_far(nodes)) {
      const std::optional<Drawn_node> d = node_to_draw(m_boundary[p.quadrilateral], p.point, nodes, carriers);
      if (d && p.distance > farthest[d->node].first) farthest[d->node] = {p.distance, d->place};
    }
    std::vector<Drawn_node> result;
    for (std::size_t v = 0; v < nodes.size(); ++v)
      if (farthest[v].first > m_too_far) result.push_back({v, farthest[v].second});
    return result;
  }

  // How much farther than is allowed the two surfaces are from each other, in mean sides.
  double excess(const Nodes& nodes) const {
    double greatest = m_too_far;
    for (const Far_point& p : too_far(nodes)) greatest = (std::max)(greatest, p.distance);
    return (greatest - m_too_far) / m_side;
  }

private:
  using Kernel = Simple_cartesian<double>;
  using Triangles = AABB_types<Kernel>::Triangles;
  using Tree = AABB_types<Kernel>::Tree<AABB_types<Kernel>::Triangle_primitive>;

  // A point of the surface, its distance from a quadrilateral, or from one of its middles, and that quadrilateral.
  struct Far_point {
    Vector point;
    double distance;
    std::size_t quadrilateral;
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

  std::vector<Far_point> too_far(const Nodes& nodes) const {
    std::vector<Far_point> result = far_points(nodes, m_too_far);
    for (std::size_t k = 0; k < m_boundary.size(); ++k)
      for (const Vector& p : middles(m_boundary[k], nodes)) {
        const Vector foot = Carriers_3::project(m_surface, p).point;
        if ((foot - p).norm() > m_too_far) result.push_back({foot, (foot - p).norm(), k});
      }
    return result;
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
      result[i] = {m_surface_points[i], std::sqrt(CGAL::squared_distance(p, foot.first)),
                   std::size_t(foot.second - triangles.cbegin()) / 4};
    });
    result.erase(std::remove_if(result.begin(), result.end(), [&](const Far_point& p) { return p.distance < distance; }),
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

  // One of four triangles around the middle of a quadrilateral.
  static Kernel::Triangle_3 quarter(const Quadrilateral& q, int i, const Nodes& nodes) {
    return {to_point(nodes[q[i]]), to_point(nodes[q[(i + 1) % 4]]), to_point(middle(q, nodes))};
  }

  // The first of the two nearest nodes that is not at the nearest place on its carrier already.
  std::optional<Drawn_node> node_to_draw(Quadrilateral quadrilateral, const Vector& p, const Nodes& nodes,
                                         const std::vector<Carriers_3::Handle>& carriers) const {
    constexpr double least_way = 0.01; // of what is enough
    const auto is_nearer = [&](std::size_t v, std::size_t w) { return (nodes[v] - p).norm() < (nodes[w] - p).norm(); };
    std::stable_sort(quadrilateral.begin(), quadrilateral.end(), is_nearer);
    for (int k = 0; k < 2; ++k) {
      const std::size_t v = quadrilateral[k];
      const Vector place = Carriers_3::project(carriers[v], p).point;
      if ((place - nodes[v]).norm() > least_way * m_enough) return Drawn_node{v, place};
    }
    return {};
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

  // Of the middles from the surface.
  double distance(const Quadrilateral& q, const Nodes& nodes) const {
    double greatest = 0;
    for (const Vector& p : middles(q, nodes))
      greatest = (std::max)(greatest, (Carriers_3::project(m_surface, p).point - p).norm());
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
