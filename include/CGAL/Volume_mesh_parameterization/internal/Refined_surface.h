// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINED_SURFACE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINED_SURFACE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>
#include <CGAL/Volume_mesh_parameterization/internal/point_between.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
A triangulated surface with border whose edges can be split. Half-edge 3 t + i runs from corner i of triangle t to
corner i + 1 and has t on its left. Each triangle knows the facet of the mesh that it is a part of, and the
barycentric coordinates of its corners there: by bisection alone these are dyadic, so exact as doubles.

Cut edges and cut vertices are those on the border or on a path along which the surface is to be cut.
*/
class Refined_surface {
public:
  using Id = std::uint32_t;
  using Triangle = std::array<Id, 3>;
  using Weights = std::array<double, 3>;
  using Corner_weights = std::array<Weights, 3>;
  using Point_3 = Double_kernel::Point_3;
  static constexpr Id none = Id(-1);

  Id add_vertex(const Point_3& point) {
    m_points.push_back(point);
    m_outgoing.push_back(none);
    m_on_cut.push_back(0);
    m_split_edges.push_back({none, none});
    return Id(m_points.size() - 1);
  }

  void add_triangle(const Triangle& vertices, Facet_index parent, const Corner_weights& weights) {
    m_triangles.push_back(vertices);
    m_parents.push_back(parent);
    m_weights.push_back(weights);
    m_opposite.insert(m_opposite.end(), 3, none);
    m_is_cut.insert(m_is_cut.end(), 3, 0);
  }

  // Pairs half-edges, after all triangles are added; false if two have the same ends in the same order.
  bool link() {
    std::vector<std::array<Id, 3>> edges;
    for (Id h = 0; h < number_of_half_edges(); ++h)
      edges.push_back({std::min(source(h), target(h)), std::max(source(h), target(h)), h});
    std::sort(edges.begin(), edges.end());
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
      const Id g = edges[k][2], h = edges[k + 1][2];
      if (edges[k][0] != edges[k + 1][0] || edges[k][1] != edges[k + 1][1]) continue;
      if (source(g) == source(h) || m_opposite[g] != none) return false;
      pair(g, h);
    }
    find_outgoing();
    return true;
  }

  std::size_t number_of_vertices() const { return m_points.size(); }
  std::size_t number_of_triangles() const { return m_triangles.size(); }
  std::size_t number_of_half_edges() const { return 3 * m_triangles.size(); }

  const std::vector<Triangle>& triangles() const { return m_triangles; }
  const std::vector<Point_3>& points() const { return m_points; }
  Facet_index parent(Id triangle) const { return m_parents[triangle]; }
  const Corner_weights& weights(Id triangle) const { return m_weights[triangle]; }

  static Id next(Id h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Id previous(Id h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Id source(Id h) const { return m_triangles[h / 3][h % 3]; }
  Id target(Id h) const { return source(next(h)); }
  Id opposite(Id h) const { return m_opposite[h]; }
  bool is_border(Id h) const { return m_opposite[h] == none; }
  // The half-edge that leaves v; at the border the one on the border.
  Id outgoing(Id v) const { return m_outgoing[v]; }
  // The ends of the edge that v has split; none for a vertex that was added.
  const std::array<Id, 2>& split_edge(Id v) const { return m_split_edges[v]; }
  bool is_on_cut(Id v) const { return m_on_cut[v] != 0; }
  bool is_cut(Id h) const { return m_is_cut[h] != 0; }
  double length(Id v, Id w) const { return std::sqrt(CGAL::squared_distance(m_points[v], m_points[w])); }

  double length(const std::vector<Id>& path) const {
    double sum = 0;
    for (std::size_t i = 1; i < path.size(); ++i) sum += length(path[i - 1], path[i]);
    return sum;
  }

  // 0 for a flat triangle
  Double_kernel::Vector_3 unit_normal(Id triangle) const {
    const Triangle& t = m_triangles[triangle];
    const auto n = CGAL::cross_product(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]]);
    const double length = std::sqrt(n.squared_length());
    return length > 0 ? n / length : Double_kernel::Vector_3(CGAL::NULL_VECTOR);
  }

  // Calls visit(w) for each neighbor w of v, counterclockwise.
  template <typename Visitor>
  void for_each_neighbor(Id v, Visitor visit) const {
    const Id first = m_outgoing[v];
    for (Id h = first;;) {
      visit(target(h));
      const Id incoming = previous(h);
      h = m_opposite[incoming];
      if (h == none) visit(source(incoming));
      if (h == none || h == first) return;
    }
  }

  // One of the half-edges between two neighbors.
  Id half_edge(Id v, Id w) const {
    for (Id h = m_outgoing[v];;) {
      const Id incoming = previous(h);
      if (target(h) == w) return h;
      if (source(incoming) == w) return incoming;
      h = m_opposite[incoming];
    }
  }

  Id bisect(Id h) { return split(h, .5); }

  // Splits the edge of h at this part of the way from its source, and the one or two triangles at it.
  Id split(Id h, double part) {
    const Id a = source(h), b = target(h), g = m_opposite[h];
    const Id m = add_vertex(point_between(m_points[a], m_points[b], part));
    m_on_cut[m] = m_is_cut[h];
    m_split_edges[m] = {a, b};
    const Id second_h = split_triangle(h, m, part);
    m_outgoing[m] = second_h;
    if (g == none) return m;
    const Id second_g = split_triangle(g, m, 1 - part);
    pair(h, second_g);
    pair(second_h, g);
    return m;
  }

  void cut(Id h) {
    m_is_cut[h] = m_on_cut[source(h)] = m_on_cut[target(h)] = 1;
    if (!is_border(h)) m_is_cut[m_opposite[h]] = 1;
  }

  void cut_border() {
    for (Id h = 0; h < number_of_half_edges(); ++h)
      if (is_border(h)) cut(h);
  }

  void cut(const std::vector<Id>& path) {
    for (std::size_t i = 1; i < path.size(); ++i) cut(half_edge(path[i - 1], path[i]));
  }

  // Takes back cut(path); its ends stay on their cuts.
  void uncut(const std::vector<Id>& path) {
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Id h = half_edge(path[i - 1], path[i]);
      m_is_cut[h] = m_is_cut[m_opposite[h]] = 0;
      if (i > 1) m_on_cut[path[i - 1]] = 0;
    }
  }

  // The edges that are not cut and join two cut vertices, the longest first.
  std::vector<std::array<Id, 2>> chords() const {
    std::vector<std::array<Id, 2>> result;
    for (Id h = 0; h < number_of_half_edges(); ++h)
      if (!m_is_cut[h] && h < m_opposite[h] && is_on_cut(source(h)) && is_on_cut(target(h)))
        result.push_back({source(h), target(h)});
    sort_longest_first(result, [this](Id v) { return m_points[v]; });
    return result;
  }

  // Bisects all chords. Then no triangle is squeezed flat when the cuts become straight, and the vertices off the cuts are
  // connected within each piece, so that the next path exists. Once is enough: no edge at a midpoint is a chord. Returns
  // the chords in the order of the new vertices.
  std::vector<std::array<Id, 2>> split_chords() {
    const std::vector<std::array<Id, 2>> result = chords();
    for (const auto& [v, w] : result) bisect(half_edge(v, w));
    return result;
  }

private:
  void pair(Id g, Id h) {
    m_opposite[g] = h;
    m_opposite[h] = g;
  }

  // At a border vertex the half-edge on the border, from which for_each_neighbor() sees all others.
  void find_outgoing() {
    for (Id h = 0; h < number_of_half_edges(); ++h)
      if (m_outgoing[source(h)] == none || is_border(h)) m_outgoing[source(h)] = h;
  }

  // (a, b, c) with h from a to b becomes (a, m, c), and (m, b, c) is added; returns the half-edge from m to b.
  Id split_triangle(Id h, Id m, double part) {
    const Id t = h / 3, i = h % 3, j = (i + 1) % 3, added = Id(m_triangles.size());
    const Id old_next = 3 * t + j, new_h = 3 * added + i, new_next = 3 * added + j;
    Triangle vertices = m_triangles[t];
    Corner_weights weights = m_weights[t];
    const Weights middle = between(weights[i], weights[j], part);
    vertices[i] = m;
    weights[i] = middle;
    add_triangle(vertices, m_parents[t], weights);
    m_triangles[t][j] = m;
    m_weights[t][j] = middle;
    if (m_outgoing[vertices[j]] == old_next) m_outgoing[vertices[j]] = new_next;
    m_is_cut[new_h] = m_is_cut[h];
    std::swap(m_is_cut[new_next], m_is_cut[old_next]);
    if (!is_border(old_next)) pair(new_next, m_opposite[old_next]);
    pair(old_next, previous(new_h));
    return new_h;
  }

  static Weights between(const Weights& a, const Weights& b, double part) {
    Weights result;
    for (int i = 0; i < 3; ++i) result[i] = part == .5 ? (a[i] + b[i]) / 2 : a[i] + part * (b[i] - a[i]);
    return result;
  }

  std::vector<Point_3> m_points;
  std::vector<Id> m_outgoing; // of vertices
  std::vector<char> m_on_cut; // of vertices
  std::vector<std::array<Id, 2>> m_split_edges; // of vertices
  std::vector<Triangle> m_triangles;
  std::vector<Facet_index> m_parents;
  std::vector<Corner_weights> m_weights;
  std::vector<Id> m_opposite; // of half-edges
  std::vector<char> m_is_cut; // of half-edges
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINED_SURFACE_H
