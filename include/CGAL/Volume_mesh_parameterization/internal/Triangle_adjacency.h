// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TRIANGLE_ADJACENCY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TRIANGLE_ADJACENCY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Which triangles of a soup share edges, and whether they form a closed manifold: whatever their orientations, and
// whatever else they form. Edge i of a triangle goes from its corner i to the next one.
class Triangle_adjacency {
public:
  using Triangles = std::vector<std::array<std::size_t, 3>>;

  explicit Triangle_adjacency(const Triangles& triangles) : m_triangles(triangles) {}

  // \returns ERROR_OPEN_SURFACE or ERROR_NON_MANIFOLD.
  Status assign_neighbors() {
    const std::vector<Sorted_edge> edges = sorted_edges();
    m_opposite.resize(3 * m_triangles.size());
    Status open;
    for (std::size_t k = 0, end; k < edges.size(); k = end) {
      for (end = k + 1; end < edges.size() && same_edge(edges[k], edges[end]);) ++end;
      if (end - k > 2)
        return {ERROR_NON_MANIFOLD, std::to_string(end - k) + " triangles share " + name(edges[k])};
      if (end - k == 1 && open.ok())
        open = {ERROR_OPEN_SURFACE,
                name(edges[k]) + " is in triangle " + std::to_string(edges[k][2] / 3) + " only"};
      m_opposite[edges[k][2]] = std::uint32_t(edges[end - 1][2]);
      m_opposite[edges[end - 1][2]] = std::uint32_t(edges[k][2]);
    }
    return open.ok() ? check_duplicates() : open;
  }

  // \returns ERROR_NON_MANIFOLD if the triangles around a vertex are not one fan.
  Status check_vertices(std::size_t number_of_vertices) const {
    Disjoint_sets fans(m_opposite.size());
    for (std::uint32_t e = 0; e < m_opposite.size(); ++e)
      for (std::uint32_t corner : {m_opposite[e], next(m_opposite[e])})
        fans.join(vertex(corner) == vertex(e) ? e : next(e), corner);
    std::vector<char> seen(number_of_vertices, 0);
    for (std::uint32_t corner = 0; corner < m_opposite.size(); ++corner)
      if (fans.is_representative(corner)) {
        if (seen[vertex(corner)])
          return {ERROR_NON_MANIFOLD,
                  "parts of the surface touch at vertex " + std::to_string(vertex(corner))};
        seen[vertex(corner)] = 1;
      }
    return {};
  }

  std::size_t number_of_components() const {
    Disjoint_sets components(m_triangles.size());
    for (std::uint32_t e = 0; e < m_opposite.size(); ++e) components.join(e / 3, m_opposite[e] / 3);
    return components.number_of_sets();
  }

  // The triangle beyond edge i of triangle t.
  std::uint32_t neighbor(std::uint32_t t, int i) const { return m_opposite[3 * t + std::uint32_t(i)] / 3; }

  // Tells which triangles to turn around for all to be oriented as the first one; the surface is connected.
  // \returns ERROR_NON_MANIFOLD if the surface has one side only.
  Status find_reversed(std::vector<char>& is_reversed) const {
    constexpr char unknown = 2;
    is_reversed.assign(m_triangles.size(), unknown);
    is_reversed[0] = 0;
    std::vector<std::uint32_t> stack(1, 0);
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (std::uint32_t e = 3 * t; e < 3 * t + 3; ++e) {
        const std::uint32_t n = m_opposite[e] / 3;
        const char reversed = char(is_reversed[t] ^ (vertex(e) == vertex(m_opposite[e])));
        if (is_reversed[n] == unknown) {
          is_reversed[n] = reversed;
          stack.push_back(n);
        } else if (is_reversed[n] != reversed)
          return {ERROR_NON_MANIFOLD, "the surface has one side only, as triangles " + std::to_string(t) +
                                          " and " + std::to_string(n) + " show"};
      }
    }
    return {};
  }

private:
  using Sorted_edge = std::array<std::size_t, 3>; // both ends in increasing order, number of the edge

  static std::uint32_t next(std::uint32_t e) { return e % 3 == 2 ? e - 2 : e + 1; }
  std::size_t vertex(std::uint32_t corner) const { return m_triangles[corner / 3][corner % 3]; }

  static bool same_edge(const Sorted_edge& a, const Sorted_edge& b) { return a[0] == b[0] && a[1] == b[1]; }
  static std::string name(const Sorted_edge& e) {
    return "the edge between vertices " + std::to_string(e[0]) + " and " + std::to_string(e[1]);
  }

  std::vector<Sorted_edge> sorted_edges() const {
    std::vector<Sorted_edge> edges;
    edges.reserve(3 * m_triangles.size());
    for (std::uint32_t e = 0; e < 3 * m_triangles.size(); ++e) {
      const std::size_t a = vertex(e), b = vertex(next(e));
      edges.push_back({std::min(a, b), std::max(a, b), e});
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  // Two triangles on the same vertices close each other: a manifold by the edges, but not one with a volume.
  Status check_duplicates() const {
    for (std::uint32_t e = 0; e < m_opposite.size(); ++e)
      if (m_opposite[e] / 3 == m_opposite[next(e)] / 3)
        return {ERROR_NON_MANIFOLD, "triangles " + std::to_string(e / 3) + " and " +
                                        std::to_string(m_opposite[e] / 3) + " have the same vertices"};
    return {};
  }

  const Triangles& m_triangles;
  std::vector<std::uint32_t> m_opposite; // of edge 3 t + i of triangle t
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TRIANGLE_ADJACENCY_H
