// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_AXIS_ALIGNED_SURFACE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_AXIS_ALIGNED_SURFACE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Box_tree_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/triangle_weights_2.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/enum.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The axis that is normal to a triangle, and whether the triangle turns counterclockwise seen from the positive end.
struct Axis_normal {
  int axis = -1; // none
  Orientation orientation = COLLINEAR;

  bool exists() const { return orientation != COLLINEAR; }
  bool operator==(const Axis_normal& n) const { return axis == n.axis && orientation == n.orientation; }
};

// Triangles in planes orthogonal to the axes, each with a label.
template <typename GeomTraits>
class Axis_aligned_surface {
public:
  using FT = typename GeomTraits::FT;
  using Point_2 = typename GeomTraits::Point_2;
  using Point_3 = typename GeomTraits::Point_3;
  using Triangle = std::array<Point_3, 3>;
  using Weights = std::array<FT, 3>;

  static Axis_normal normal(const Triangle& t) {
    for (int axis = 0; axis < 3; ++axis)
      if (t[0][axis] == t[1][axis] && t[0][axis] == t[2][axis]) {
        const Triangle_corners_2<GeomTraits> c = projected(t, axis);
        const Orientation o = typename GeomTraits::Orientation_2()(c[0], c[1], c[2]);
        if (o != COLLINEAR) return {axis, o};
      }
    return {};
  }

  /// \pre each triangle has a normal
  Axis_aligned_surface(std::vector<Triangle> triangles, std::vector<int> labels)
      : m_triangles(std::move(triangles)), m_labels(std::move(labels)), m_tree(boxes(m_triangles)) {
    for (const Triangle& t : m_triangles) m_normals.push_back(normal(t));
  }

  std::size_t number_of_triangles() const { return m_triangles.size(); }
  const Triangle& triangle(std::size_t t) const { return m_triangles[t]; }
  const Axis_normal& normal(std::size_t t) const { return m_normals[t]; }
  int label(std::size_t t) const { return m_labels[t]; }

  // The least triangle with that normal and label that contains p; a nearest one where p is rounded off the surface; the
  // number of triangles if none has that normal and label.
  std::size_t find(const Point_3& p, const Axis_normal& normal, int label) const {
    const auto is_like = [&](std::size_t k) { return m_normals[k] == normal && m_labels[k] == label; };
    const std::size_t t = m_tree.find(p.bbox(), [&](std::size_t k) { return is_like(k) && contains(k, p); });
    return t < m_triangles.size() ? t : nearest(p, is_like);
  }

  Weights weights(std::size_t t, const Point_3& p) const {
    const int axis = m_normals[t].axis;
    return weights_in<GeomTraits>(projected(m_triangles[t], axis), projected(p, axis));
  }

  // The point with the given weights. Starts from the nearest corner: a coordinate that all corners of non-zero weight
  // share is kept.
  Point_3 point(std::size_t t, const Weights& w) const {
    const Triangle& c = m_triangles[t];
    const int n = int(std::max_element(w.begin(), w.end()) - w.begin()), i = (n + 1) % 3, j = (n + 2) % 3;
    std::array<FT, 3> x;
    for (int k = 0; k < 3; ++k) x[k] = c[n][k] + (w[i] * (c[i][k] - c[n][k]) + w[j] * (c[j][k] - c[n][k]));
    return Point_3(x[0], x[1], x[2]);
  }

  static Point_2 projected(const Point_3& p, int axis) {
    return Point_2(p[(axis + 1) % 3], p[(axis + 2) % 3]);
  }

private:
  static Triangle_corners_2<GeomTraits> projected(const Triangle& t, int axis) {
    return {projected(t[0], axis), projected(t[1], axis), projected(t[2], axis)};
  }

  static std::vector<Bbox_3> boxes(const std::vector<Triangle>& triangles) {
    std::vector<Bbox_3> result;
    for (const Triangle& t : triangles) result.push_back(t[0].bbox() + t[1].bbox() + t[2].bbox());
    return result;
  }

  bool contains(std::size_t t, const Point_3& p) const {
    const int axis = m_normals[t].axis;
    return p[axis] == m_triangles[t][0][axis] &&
           internal::contains<GeomTraits>(projected(m_triangles[t], axis), projected(p, axis));
  }

  // With exact number types it is never called.
  template <typename Predicate>
  std::size_t nearest(const Point_3& p, const Predicate& is_wanted) const {
    std::size_t result = m_triangles.size();
    FT least(0);
    for (std::size_t t = 0; t < m_triangles.size(); ++t) {
      if (!is_wanted(t)) continue;
      const FT distance = CGAL::squared_distance(p, point(t, weights(t, p)));
      if (result == m_triangles.size() || distance < least) {
        result = t;
        least = distance;
      }
    }
    return result;
  }

  std::vector<Triangle> m_triangles;
  std::vector<Axis_normal> m_normals;
  std::vector<int> m_labels;
  Box_tree_3 m_tree;
};

/*
The border of the parts of a surface that have the same label and lie in the same plane orthogonal to an axis, as a chain:
equal for two surfaces only if these cover each point of each plane equally often, by triangles of each label and
orientation.

A directed edge is the difference of two rays from its ends, so that it does not matter how a straight border is
subdivided.
*/
template <typename GeomTraits>
class Border_chain {
public:
  using Surface = Axis_aligned_surface<GeomTraits>;
  using Point_3 = typename GeomTraits::Point_3;

  // An edge, or the ray from its first point with the same slope.
  struct Term {
    int label;
    Axis_normal normal;
    Point_3 from, to;
    int factor;
  };

  explicit Border_chain(const Surface& surface) {
    std::vector<Term> edges;
    for (std::size_t t = 0; t < surface.number_of_triangles(); ++t)
      for (int i = 0; i < 3; ++i) {
        const Point_3 &p = surface.triangle(t)[i], &q = surface.triangle(t)[(i + 1) % 3];
        edges.push_back(
            {surface.label(t), surface.normal(t), (std::min)(p, q), (std::max)(p, q), p < q ? 1 : -1});
      }
    sum_up(edges, compare_edges); // leaves few for the costly comparison of slopes
    for (const Term& e : edges) {
      m_rays.push_back(e);
      m_rays.push_back({e.label, e.normal, e.to, e.from, -e.factor});
    }
    sum_up(m_rays, compare_rays);
  }

  // The first ray that one chain has and the other has not, or null.
  static const Term* difference(const Border_chain& a, const Border_chain& b) {
    const auto mismatch = std::mismatch(
        a.m_rays.begin(), a.m_rays.end(), b.m_rays.begin(), b.m_rays.end(),
        [](const Term& s, const Term& t) { return compare_rays(s, t) == EQUAL && s.factor == t.factor; });
    if (mismatch.first != a.m_rays.end()) return &*mismatch.first;
    return mismatch.second != b.m_rays.end() ? &*mismatch.second : nullptr;
  }

private:
  static Comparison_result compare_planes(const Term& s, const Term& t) {
    const auto key = [](const Term& r) { return std::tie(r.label, r.normal.axis, r.normal.orientation); };
    return key(s) < key(t) ? SMALLER : key(t) < key(s) ? LARGER : EQUAL;
  }

  static Comparison_result compare_edges(const Term& s, const Term& t) {
    Comparison_result result = compare_planes(s, t);
    if (result == EQUAL) result = CGAL::compare_xyz(s.from, t.from);
    return result == EQUAL ? CGAL::compare_xyz(s.to, t.to) : result;
  }

  static Comparison_result compare_rays(const Term& s, const Term& t) {
    Comparison_result result = compare_planes(s, t);
    if (result == EQUAL) result = typename GeomTraits::Compare_slope_2()(segment(s), segment(t));
    return result == EQUAL ? CGAL::compare_xyz(s.from, t.from) : result;
  }

  static typename GeomTraits::Segment_2 segment(const Term& t) {
    return {Surface::projected(t.from, t.normal.axis), Surface::projected(t.to, t.normal.axis)};
  }

  // Sorts the terms and adds those that compare equal; zeros vanish.
  template <typename Compare>
  static void sum_up(std::vector<Term>& terms, const Compare& compare) {
    std::sort(terms.begin(), terms.end(),
              [&](const Term& s, const Term& t) { return compare(s, t) == SMALLER; });
    std::vector<Term> sums;
    for (Term& t : terms)
      if (!sums.empty() && compare(sums.back(), t) == EQUAL)
        sums.back().factor += t.factor;
      else
        sums.push_back(std::move(t));
    sums.erase(std::remove_if(sums.begin(), sums.end(), [](const Term& t) { return t.factor == 0; }),
               sums.end());
    terms = std::move(sums);
  }

  std::vector<Term> m_rays; // sorted
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_AXIS_ALIGNED_SURFACE_H
