// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CURVE_RIDGES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CURVE_RIDGES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_fields.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Where, between the loops on a surface that separate floor and ceiling, the nearest one changes: to another loop, or to a
far part of the same loop.
*/
class Curve_ridges {
public:
  // `distance` is that of vertices from the nearest loop.
  Curve_ridges(const Approximate_surface& surface, const std::vector<int>& labels,
               const Vertex_field& distance)
      : m_surface(surface),
        m_labels(labels),
        m_distance(distance),
        m_loop_of(surface.points.size(), none),
        m_arc_of(surface.points.size(), 0),
        m_nearest(surface.points.size(), none) {
    trace_loops();
    find_nearest();
  }

  // The length of the way from the nearest loop across each vertex to the ridges; 0 if there are none.
  Vertex_field way_to_ridges() const {
    std::vector<Vertex_index> ridges;
    std::vector<double> ways;
    for (std::size_t k = 0; k < m_surface.points.size(); ++k) {
      const Vertex_index v(k);
      bool found = false;
      if (m_distance[v] > 0) for_each_neighbor(v, [&](Vertex_index w) { found |= is_ridge(v, w); });
      if (!found) continue;
      ridges.push_back(v);
      ways.push_back(m_distance[v]);
    }
    return Surface_distance(m_surface).from(ridges, ways);
  }

private:
  static constexpr std::uint32_t none = std::uint32_t(-1);
  // Parts of one loop are far from each other if it runs on for so many times their distance. At a right-angled corner it
  // is 2, between opposite points of a circle 3.1.
  static constexpr double far_along = 3;

  double length(Vertex_index v, Vertex_index w) const {
    return std::sqrt(CGAL::squared_distance(m_surface.points[v], m_surface.points[w]));
  }

  // With the floor on their left. Where loops touch, one is taken for two.
  void trace_loops() {
    std::vector<Vertex_index> next(m_surface.points.size());
    for (Facet_index f : m_surface.adjacency.facets())
      for (int i = 0; i < 3; ++i)
        if (m_labels[f] == FLOOR && is_border(m_surface.adjacency, m_labels, {f, i})) {
          next[m_surface.adjacency.source({f, i})] = m_surface.adjacency.target({f, i});
          m_loop_vertices.push_back(m_surface.adjacency.source({f, i}));
        }
    for (Vertex_index start : m_loop_vertices) {
      if (m_loop_of[start] != none) continue;
      double arc = 0;
      for (Vertex_index v = start; m_loop_of[v] == none; v = next[v]) {
        m_loop_of[v] = std::uint32_t(m_loop_lengths.size());
        m_arc_of[v] = arc;
        arc += length(v, next[v]);
      }
      m_loop_lengths.push_back(arc);
    }
  }

  template <typename Visitor>
  void for_each_neighbor(Vertex_index v, const Visitor& visit) const {
    for (Facet_index f : m_surface.adjacency.star(v))
      for (Vertex_index w : m_surface.adjacency.triangle(f))
        if (w != v) visit(w);
  }

  // The vertices of the loops from which the shortest paths come.
  void find_nearest() {
    std::vector<Vertex_index> order;
    for (std::size_t v = 0; v < m_surface.points.size(); ++v) order.emplace_back(v);
    std::stable_sort(order.begin(), order.end(),
                     [&](Vertex_index v, Vertex_index w) { return m_distance[v] < m_distance[w]; });
    for (Vertex_index v : order) {
      if (m_loop_of[v] != none) m_nearest[v] = v;
      double least = std::numeric_limits<double>::infinity();
      if (m_nearest[v] == none)
        for_each_neighbor(v, [&](Vertex_index w) {
          const double d = m_distance[w] + length(v, w);
          if (m_nearest[w] == none || !(d < least)) return;
          least = d;
          m_nearest[v] = m_nearest[w];
        });
    }
  }

  bool is_ridge(Vertex_index v, Vertex_index w) const {
    const std::uint32_t a = m_nearest[v], b = m_nearest[w];
    if (a == none || b == none || m_loop_of[a] != m_loop_of[b]) return a != b;
    const double arc = std::abs(m_arc_of[a] - m_arc_of[b]);
    const double across =
        std::max(m_distance[v], m_distance[w]) + length(v, w); // the nearest vertices are not exact
    return std::min(arc, m_loop_lengths[m_loop_of[a]] - arc) > far_along * across;
  }

  const Approximate_surface& m_surface;
  const std::vector<int>& m_labels;
  const Vertex_field& m_distance;
  std::vector<Vertex_index> m_loop_vertices;
  std::vector<double> m_loop_lengths;
  std::vector<std::uint32_t> m_loop_of; // of vertices on loops
  std::vector<double> m_arc_of;         // of vertices on loops
  std::vector<std::uint32_t> m_nearest; // vertices on loops
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CURVE_RIDGES_H
