// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CARRIERS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CARRIERS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/AABB_types.h>
#include <CGAL/Volume_mesh_parameterization/internal/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Facet_adjacency.h>

#include <CGAL/Simple_cartesian.h>

#include <Eigen/Dense>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A point of a carrier, and an orthonormal basis of the directions in which it may move there.
struct Foot_point {
  Eigen::Vector3d point;
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> directions;
};

// What the nodes of a hexahedral mesh of a solid move on: the solid's patches, and the rims between two patches. Where a
// rim is smooth, it may be left out: then the patches on both sides are one.
class Carriers_3 {
  using Kernel = Simple_cartesian<double>; // feet are rounded anyway
  using Point_3 = Kernel::Point_3;
  using Types = AABB_types<Kernel>;
  using Labels =
      std::pair<int, int>; // of the two sides of a rim, in increasing order; twice the same for a patch

  template <typename Shape, typename Primitive>
  struct Carrier {
    std::vector<Shape> shapes;
    Types::Tree<Primitive> tree;
  };
  using Patch = Carrier<Kernel::Triangle_3, Types::Triangle_primitive>;
  using Rim = Carrier<Kernel::Segment_3, Types::Segment_primitive>;

public:
  // Stands for one patch, for one rim, or for the whole space.
  class Handle {
    friend Carriers_3;
    const Patch* patch = nullptr;
    const Rim* rim = nullptr;
  };

  // Returns `ERROR_NON_MANIFOLD` if the boundary of the solid is no surface.
  template <typename GeomTraits>
  Status build(const Compact_tetrahedral_mesh_3<GeomTraits>& object, bool has_smooth_rims) {
    const Facet_adjacency surface = boundary_adjacency(object);
    if (!surface.status().ok()) return surface.status();
    std::vector<Kernel::Triangle_3>& triangles = m_surface.shapes;
    const auto point = [&](Vertex_index v) { return to_point(approximate(object.point(v))); };
    for (Facet_index f : surface.facets()) {
      const Facet_adjacency::Triangle& v = surface.triangle(f);
      triangles.emplace_back(point(v[0]), point(v[1]), point(v[2]));
      m_labels.push_back(object.label(f));
    }
    std::sort(m_labels.begin(), m_labels.end());
    m_labels.erase(std::unique(m_labels.begin(), m_labels.end()), m_labels.end());
    m_regions = Disjoint_sets(m_labels.size());
    for (Facet_index f : surface.facets())
      for (int i = 0; i < 3; ++i) {
        const Facet_index g = surface.neighbor(f, i);
        const Labels labels(object.label(f), object.label(g));
        if (labels.first >= labels.second) continue;
        const bool is_rim = has_smooth_rims || is_crease(triangles[f], triangles[g]);
        if (!is_rim) m_regions.join(index(labels.first), index(labels.second));
        (is_rim ? m_rims : m_left_out)[labels].shapes.emplace_back(point(surface.source({f, i})),
                                                                   point(surface.target({f, i})));
      }
    for (Facet_index f : surface.facets()) m_patches[region(object.label(f))].shapes.push_back(triangles[f]);
    build_tree(m_surface);
    for (auto& patch : m_patches) build_tree(patch.second);
    for (auto* rims : {&m_rims, &m_left_out})
      for (auto& rim : *rims) build_tree(rim.second);
    return {};
  }

  // The carrier of a node at p on patches with these labels. Returns false if there is no such patch, or no edge between
  // the two.
  bool find(const Labels& labels, const Eigen::Vector3d& p, Handle& handle) const {
    if (!std::binary_search(m_labels.begin(), m_labels.end(), labels.first)) return false;
    const auto rim = m_rims.find(labels), left_out = m_left_out.find(labels);
    const bool has_rim = rim != m_rims.end(), has_left_out = left_out != m_left_out.end();
    if (labels.first != labels.second && !has_rim && !has_left_out) return false;
    handle = Handle();
    handle.patch = &m_patches.find(region(labels.first))->second;
    if (has_rim && (!has_left_out || distance(rim->second, p) <= distance(left_out->second, p))) {
      handle.patch = nullptr;
      handle.rim = &rim->second;
    }
    return true;
  }

  // All patches together.
  Handle surface() const {
    Handle handle;
    handle.patch = &m_surface;
    return handle;
  }

  // Returns the point nearest to p.
  static Foot_point project(const Handle& carrier, const Eigen::Vector3d& p) {
    if (carrier.patch) return project(*carrier.patch, p);
    if (carrier.rim) return project(*carrier.rim, p);
    return {p, Eigen::Matrix3d::Identity()};
  }

  // Returns where the line through p along an outward normal leaves the solid: ahead if p is inside, else behind.
  static std::optional<Eigen::Vector3d> find_exit(const Handle& surface, const Eigen::Vector3d& p, const Eigen::Vector3d& normal) {
    if (normal.isZero(0)) return {};
    for (int sign : {1, -1}) {
      const Eigen::Vector3d direction = sign * normal;
      const Kernel::Ray_3 ray(to_point(p), Kernel::Vector_3(direction.x(), direction.y(), direction.z()));
      const auto hit = surface.patch->tree.first_intersected_primitive(ray);
      if (!hit) continue;
      const Kernel::Triangle_3& t = **hit;
      const Eigen::Vector3d normal_of_triangle = to_vector(CGAL::normal(t[0], t[1], t[2]));
      const double slope = normal_of_triangle.dot(normal);
      if (slope > 0) return p + normal_of_triangle.dot(to_vector(t[0]) - p) / slope * normal;
    }
    return {};
  }

  // Whether the carrier, which is not the whole space, comes as near as `distance` to p.
  static bool is_near(const Handle& carrier, const Eigen::Vector3d& p, double distance) {
    const Kernel::Sphere_3 ball(to_point(p), distance * distance);
    return carrier.patch ? carrier.patch->tree.do_intersect(ball) : carrier.rim->tree.do_intersect(ball);
  }

private:
  template <typename Point>
  static Point_3 to_point(const Point& p) {
    return {p.x(), p.y(), p.z()};
  }
  template <typename Vector>
  static Eigen::Vector3d to_vector(const Vector& v) {
    return {v.x(), v.y(), v.z()};
  }

  static bool is_crease(const Kernel::Triangle_3& t, const Kernel::Triangle_3& u) {
    constexpr double least_cosine = 0.7; // of the angle between normals on a smooth surface
    const auto normal = [](const Kernel::Triangle_3& triangle) {
      return to_vector(CGAL::normal(triangle[0], triangle[1], triangle[2])).normalized();
    };
    return normal(t).dot(normal(u)) < least_cosine;
  }

  std::size_t index(int label) const {
    return std::lower_bound(m_labels.begin(), m_labels.end(), label) - m_labels.begin();
  }
  // The patches that are one with that of a label, by the least of their labels.
  int region(int label) const { return m_labels[m_regions.representative(index(label))]; }

  template <typename AnyCarrier>
  static double distance(const AnyCarrier& carrier, const Eigen::Vector3d& p) {
    return (project(carrier, p).point - p).norm();
  }

  template <typename AnyCarrier>
  static void build_tree(AnyCarrier& carrier) {
    carrier.tree.rebuild(carrier.shapes.cbegin(), carrier.shapes.cend());
    carrier.tree.accelerate_distance_queries();
  }

  template <typename AnyCarrier>
  static Foot_point project(const AnyCarrier& carrier, const Eigen::Vector3d& p) {
    const auto foot = carrier.tree.closest_point_and_primitive(to_point(p));
    return {to_vector(foot.first), directions(*foot.second)};
  }

  static Eigen::Matrix<double, 3, 2> directions(const Kernel::Triangle_3& t) {
    const Eigen::Vector3d a = to_vector(t[1] - t[0]).normalized();
    const Eigen::Vector3d normal = a.cross(to_vector(t[2] - t[0])).normalized();
    Eigen::Matrix<double, 3, 2> basis;
    basis << a, normal.cross(a);
    return basis;
  }
  static Eigen::Vector3d directions(const Kernel::Segment_3& s) {
    return to_vector(s.to_vector()).normalized();
  }

  std::vector<int> m_labels; // sorted
  mutable Disjoint_sets m_regions{0};
  Patch m_surface;
  std::map<int, Patch> m_patches;
  std::map<Labels, Rim> m_rims, m_left_out; // parts of one rim may be in both
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CARRIERS_3_H
