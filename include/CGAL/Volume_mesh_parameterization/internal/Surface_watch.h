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

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A quadrilateral of the boundary and the patch that it is near.
struct Carried_quadrilateral {
  std::array<std::size_t, 4> nodes;
  Carriers_3::Handle carrier;
};

// A place on the surface, and the node that is to be there.
struct Drawn_node {
  std::size_t node;
  Eigen::Vector3d place;
};

// Keeps the boundary of a hexahedral mesh near to the surface that its nodes move on: corners at rims get better the more
// surface their hexahedra cut off. The middles of quadrilaterals and of their sides have to be as near as they are, or as is
// enough. Tells which nodes could cover vertices of the surface that the boundary is too far from: tips and creases.
class Surface_watch {
  using Vector = Eigen::Vector3d;
  using Nodes = std::vector<Vector>;

public:
  // `greatest_distance` is in mean lengths of the sides, and a little of it is kept in reserve. Then start().
  Surface_watch(std::vector<Carried_quadrilateral> boundary, Nodes surface_vertices, const Nodes& nodes,
                double greatest_distance)
      : m_boundary(std::move(boundary)),
        m_surface_vertices(std::move(surface_vertices)),
        m_stars(nodes.size(), m_boundary.size(), [this](std::size_t q) { return m_boundary[q].nodes; }) {
    constexpr double enough = 0.8, too_far = 0.95; // other points are farther than middles; sides become shorter
    double length = 0;
    for (const Carried_quadrilateral& q : m_boundary)
      for (int i = 0; i < 4; ++i) length += (nodes[q.nodes[i]] - nodes[q.nodes[(i + 1) % 4]]).norm();
    m_side = length / (4. * double(m_boundary.size()));
    m_enough = enough * greatest_distance * m_side;
    m_too_far = too_far * greatest_distance * m_side;
  }

  // Takes the present distances for those that may be.
  void start(const Nodes& nodes) {
    m_greatest.clear();
    for (const Carried_quadrilateral& q : m_boundary) m_greatest.push_back((std::max)(m_enough, distance(q, nodes)));
  }

  // Whether no quadrilateral at node v is too far.
  bool accepts(std::size_t v, const Nodes& nodes) const {
    for (std::size_t k : m_stars[v]) {
      const Carried_quadrilateral& q = m_boundary[k];
      const auto place = std::find(q.nodes.begin(), q.nodes.end(), v) - q.nodes.begin();
      for (const Vector& p : {middle(q, nodes), side_middle(q, int(place), nodes)})
        if (!Carriers_3::is_near(q.carrier, p, m_greatest[k])) return false;
    }
    return true;
  }

  // Those at node v that were farther than is enough must not return there.
  void take_note(std::size_t v, const Nodes& nodes) {
    for (std::size_t k : m_stars[v])
      if (m_greatest[k] > m_enough)
        m_greatest[k] = (std::min)(m_greatest[k], (std::max)(m_enough, distance(m_boundary[k], nodes)));
  }

  // Vertices of the surface that are too far from the quadrilaterals, each with a node of the nearest quadrilateral and
  // the point of its carrier there; for each node the farthest.
  std::vector<Drawn_node> nodes_to_draw(const Nodes& nodes, const std::vector<Carriers_3::Handle>& carriers) const {
    std::vector<std::pair<double, Vector>> farthest(nodes.size(), {m_too_far, Vector::Zero()});
    for (const Left_out& l : left_out(nodes)) {
      const std::optional<Drawn_node> d = node_to_draw(m_boundary[l.quadrilateral].nodes, l.vertex, nodes, carriers);
      if (d && l.distance > farthest[d->node].first) farthest[d->node] = {l.distance, d->place};
    }
    std::vector<Drawn_node> result;
    for (std::size_t v = 0; v < nodes.size(); ++v)
      if (farthest[v].first > m_too_far) result.push_back({v, farthest[v].second});
    return result;
  }

  // How much farther than is allowed the vertices of the surface are, in mean sides.
  double excess(const Nodes& nodes) const {
    double greatest = m_too_far;
    for (const Left_out& l : left_out(nodes)) greatest = (std::max)(greatest, l.distance);
    return (greatest - m_too_far) / m_side;
  }

private:
  using Kernel = Simple_cartesian<double>;
  using Triangles = AABB_types<Kernel>::Triangles;
  using Tree = AABB_types<Kernel>::Tree<AABB_types<Kernel>::Triangle_primitive>;

  // A vertex of the surface that is too far from the quadrilaterals, and the nearest of them.
  struct Left_out {
    Vector vertex;
    double distance;
    std::size_t quadrilateral;
  };

  std::vector<Left_out> left_out(const Nodes& nodes) const {
    const Triangles triangles = quarters(nodes);
    const Tree tree(triangles.cbegin(), triangles.cend());
    std::vector<Left_out> result;
    for (const Vector& p : m_surface_vertices) {
      const auto foot = tree.closest_point_and_primitive(to_point(p));
      const double distance = std::sqrt(CGAL::squared_distance(to_point(p), foot.first));
      if (distance > m_too_far) result.push_back({p, distance, std::size_t(foot.second - triangles.cbegin()) / 4});
    }
    return result;
  }

  static Kernel::Point_3 to_point(const Vector& p) { return {p.x(), p.y(), p.z()}; }

  // Four triangles around the middle of each quadrilateral.
  Triangles quarters(const Nodes& nodes) const {
    Triangles triangles;
    for (const Carried_quadrilateral& q : m_boundary)
      for (int i = 0; i < 4; ++i)
        triangles.emplace_back(to_point(nodes[q.nodes[i]]), to_point(nodes[q.nodes[(i + 1) % 4]]),
                               to_point(middle(q, nodes)));
    return triangles;
  }

  // The first of the two nearest nodes that is not at the nearest place on its carrier already.
  std::optional<Drawn_node> node_to_draw(std::array<std::size_t, 4> quadrilateral, const Vector& p, const Nodes& nodes,
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

  static Vector middle(const Carried_quadrilateral& q, const Nodes& nodes) {
    return (nodes[q.nodes[0]] + nodes[q.nodes[1]] + nodes[q.nodes[2]] + nodes[q.nodes[3]]) / 4;
  }
  // Of the side after a vertex: each side at a node is that of one quadrilateral there.
  static Vector side_middle(const Carried_quadrilateral& q, int i, const Nodes& nodes) {
    return (nodes[q.nodes[i]] + nodes[q.nodes[(i + 1) % 4]]) / 2;
  }

  static double distance(const Carried_quadrilateral& q, const Nodes& nodes) {
    const auto to_carrier = [&](const Vector& p) { return (Carriers_3::project(q.carrier, p).point - p).norm(); };
    double greatest = to_carrier(middle(q, nodes));
    for (int i = 0; i < 4; ++i) greatest = (std::max)(greatest, to_carrier(side_middle(q, i, nodes)));
    return greatest;
  }

  std::vector<Carried_quadrilateral> m_boundary;
  Nodes m_surface_vertices;
  Incidence_lists<std::size_t, std::size_t> m_stars; // the quadrilaterals around each node
  std::vector<double> m_greatest;                    // distance that each quadrilateral may have
  double m_side = 0;                                 // the mean length in the beginning
  double m_enough = 0, m_too_far = 0;                // for middles, for vertices of the surface
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_WATCH_H
