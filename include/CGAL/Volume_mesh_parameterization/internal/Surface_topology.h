// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_TOPOLOGY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_TOPOLOGY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The topology of a soup of polygons with N corners: is it a closed oriented 2-manifold, of how many components?
template <std::size_t N>
class Surface_topology {
public:
  using Polygon = std::array<std::size_t, N>;

  explicit Surface_topology(const std::vector<Polygon>& polygons)
      : m_polygons(polygons), m_fans(N * polygons.size()), m_parts(polygons.size()) {
    const std::vector<Half_edge> edges = sorted_half_edges();
    bool edges_are_manifold = true;
    for (std::size_t k = 0, end; k < edges.size(); k = end) {
      for (end = k + 1; end < edges.size() && edges[k].same_edge(edges[end]);) ++end;
      ++m_number_of_edges;
      if (end - k == 2 && edges[k].reversed != edges[k + 1].reversed)
        glue(edges[k].corner, edges[k + 1].corner);
      else
        edges_are_manifold = false;
    }
    m_number_of_vertices = count_vertices();
    m_number_of_components = m_parts.number_of_sets();
    // around each vertex the corners must form one fan
    m_is_closed_manifold = edges_are_manifold && m_fans.number_of_sets() == m_number_of_vertices;
  }

  bool is_closed_manifold() const { return m_is_closed_manifold; }
  std::size_t number_of_components() const { return m_number_of_components; }
  long euler_characteristic() const {
    return long(m_number_of_vertices) - long(m_number_of_edges) + long(m_polygons.size());
  }

private:
  // From the corner numbered N * polygon + position to the next one.
  struct Half_edge {
    std::size_t lower, upper, corner;
    bool reversed;
    bool same_edge(const Half_edge& e) const { return lower == e.lower && upper == e.upper; }
    bool operator<(const Half_edge& e) const {
      return std::tie(lower, upper, corner) < std::tie(e.lower, e.upper, e.corner);
    }
  };

  static std::size_t next(std::size_t corner) { return corner % N + 1 < N ? corner + 1 : corner + 1 - N; }
  std::size_t vertex(std::size_t corner) const { return m_polygons[corner / N][corner % N]; }

  std::vector<Half_edge> sorted_half_edges() const {
    std::vector<Half_edge> edges;
    edges.reserve(N * m_polygons.size());
    for (std::size_t c = 0; c < N * m_polygons.size(); ++c) {
      const std::size_t a = vertex(c), b = vertex(next(c));
      edges.push_back({std::min(a, b), std::max(a, b), c, b < a});
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  // Two half-edges with opposite directions: the start of one is the end of the other.
  void glue(std::size_t c, std::size_t d) {
    m_fans.join(c, next(d));
    m_fans.join(next(c), d);
    m_parts.join(c / N, d / N);
  }

  std::size_t count_vertices() const {
    std::vector<std::size_t> vertices;
    vertices.reserve(N * m_polygons.size());
    for (const Polygon& p : m_polygons) vertices.insert(vertices.end(), p.begin(), p.end());
    std::sort(vertices.begin(), vertices.end());
    return std::unique(vertices.begin(), vertices.end()) - vertices.begin();
  }

  const std::vector<Polygon>& m_polygons;
  Disjoint_sets m_fans, m_parts; // of corners, of polygons
  std::size_t m_number_of_vertices = 0, m_number_of_edges = 0, m_number_of_components = 0;
  bool m_is_closed_manifold = false;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_TOPOLOGY_H
