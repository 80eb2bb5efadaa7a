// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FACET_ADJACENCY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FACET_ADJACENCY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>

#include <boost/range/irange.hpp>
#include <boost/range/adaptor/transformed.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Which facet lies behind each edge of a closed triangle surface. Side i of a facet is the edge opposite to its
// corner i.
class Facet_adjacency {
public:
  using Triangle = std::array<Vertex_index, 3>;
  struct Side {
    Facet_index facet;
    int index = 0;
  };

  Facet_adjacency(std::size_t number_of_vertices, std::vector<Triangle> triangles)
      : m_triangles(std::move(triangles)),
        m_opposite(3 * m_triangles.size(), none),
        m_stars(number_of_vertices, m_triangles.size(), [&](Facet_index f) { return m_triangles[f]; }) {
    pair_sides();
    if (m_status.ok()) check_vertices();
  }

  // `ERROR_EMPTY_MESH`, `ERROR_OPEN_SURFACE` or `ERROR_NON_MANIFOLD`, which includes facets that are oriented against
  // each other; then only triangles and stars can be relied on.
  const Status& status() const { return m_status; }

  std::size_t number_of_vertices() const { return m_stars.size(); }
  std::size_t number_of_facets() const { return m_triangles.size(); }
  auto facets() const {
    return boost::irange(std::size_t(0), number_of_facets()) |
           boost::adaptors::transformed([](std::size_t f) { return Facet_index(f); });
  }

  const Triangle& triangle(Facet_index f) const { return m_triangles[f]; }
  // the ends of a side, with the facet on their left
  Vertex_index source(Side s) const { return m_triangles[s.facet][(s.index + 1) % 3]; }
  Vertex_index target(Side s) const { return m_triangles[s.facet][(s.index + 2) % 3]; }

  Side opposite(Side s) const {
    const std::uint32_t o = m_opposite[3 * s.facet + s.index];
    return {Facet_index(o / 3), int(o % 3)};
  }
  Facet_index neighbor(Facet_index f, int i) const { return opposite({f, i}).facet; }

  // returns an iterator range of the facets around a vertex; it is empty for a vertex in the interior.
  auto star(Vertex_index v) const { return m_stars[v]; }

  // returns V - E + F, counting vertices with facets only.
  long euler_number() const {
    long vertices = 0;
    for (std::size_t v = 0; v < number_of_vertices(); ++v) vertices += !m_stars[Vertex_index(v)].empty();
    return vertices - long(number_of_facets()) / 2;
  }

private:
  static constexpr std::uint32_t none = std::uint32_t(-1);
  using Edge = std::array<std::uint32_t, 3>; // smaller end, larger end, packed side

  std::vector<Edge> sorted_sides() const {
    std::vector<Edge> sides;
    sides.reserve(m_opposite.size());
    for (Facet_index f : facets())
      for (int i = 0; i < 3; ++i) {
        const Vertex_index v = source({f, i}), w = target({f, i});
        sides.push_back({std::min(v, w), std::max(v, w), 3 * f + i});
      }
    std::sort(sides.begin(), sides.end());
    return sides;
  }

  void pair_sides() {
    if (m_triangles.empty()) m_status = {ERROR_EMPTY_MESH, "it has no facets"};
    const std::vector<Edge> sides = sorted_sides();
    for (std::size_t k = 0, end; k < sides.size(); k = end) {
      for (end = k + 1; end < sides.size() && sides[k][0] == sides[end][0] && sides[k][1] == sides[end][1];)
        ++end;
      const std::uint32_t a = sides[k][2], b = sides[end - 1][2];
      if (end - k == 2 && source(unpack(a)) == target(unpack(b))) {
        m_opposite[a] = b;
        m_opposite[b] = a;
      } else if (m_status.ok())
        m_status = {end - k == 1 ? ERROR_OPEN_SURFACE : ERROR_NON_MANIFOLD,
                    "the edge from vertex " + std::to_string(sides[k][0]) + " to " +
                        std::to_string(sides[k][1])};
    }
  }

  void check_vertices() {
    for (std::size_t v = 0; v < number_of_vertices(); ++v) {
      const auto around = star(Vertex_index(v));
      if (!around.empty() && fan_size(Vertex_index(v), around.front()) != std::size_t(around.size())) {
        m_status = {ERROR_NON_MANIFOLD, "the boundary touches itself at vertex " + std::to_string(v)};
        return;
      }
    }
  }

  std::size_t fan_size(Vertex_index v, Facet_index start) const {
    std::size_t size = 0;
    Facet_index f = start;
    do {
      const Triangle& t = m_triangles[f];
      const int i = int(std::find(t.begin(), t.end(), v) - t.begin());
      f = neighbor(f, (i + 1) % 3);
      ++size;
    } while (f != start);
    return size;
  }

  static Side unpack(std::uint32_t s) { return {Facet_index(s / 3), int(s % 3)}; }

  std::vector<Triangle> m_triangles;
  std::vector<std::uint32_t> m_opposite;
  Incidence_lists<Vertex_index, Facet_index> m_stars;
  Status m_status;
};

// The boundary of a tetrahedral mesh, with the mesh's numbers of vertices and facets.
template <typename GeomTraits>
Facet_adjacency boundary_adjacency(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  std::vector<Facet_adjacency::Triangle> triangles;
  triangles.reserve(mesh.number_of_boundary_facets());
  for (Facet_index f : mesh.boundary_facets()) triangles.push_back(mesh.vertices(f));
  return Facet_adjacency(mesh.number_of_vertices(), std::move(triangles));
}

template <typename GeomTraits>
std::vector<int> boundary_labels(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  std::vector<int> labels;
  labels.reserve(mesh.number_of_boundary_facets());
  for (Facet_index f : mesh.boundary_facets()) labels.push_back(mesh.label(f));
  return labels;
}

// Numbers the edge-connected parts in which `same(f, g)` holds for neighbors, in the order of their first facets.
class Facet_components {
public:
  template <typename Same>
  Facet_components(const Facet_adjacency& surface, const Same& same)
      : m_of(surface.number_of_facets(), unset) {
    std::vector<Facet_index> stack;
    for (Facet_index seed : surface.facets()) {
      if (m_of[seed] != unset) continue;
      m_of[seed] = m_size;
      stack.push_back(seed);
      while (!stack.empty()) {
        const Facet_index f = stack.back();
        stack.pop_back();
        for (int i = 0; i < 3; ++i) {
          const Facet_index g = surface.neighbor(f, i);
          if (m_of[g] != unset || !same(f, g)) continue;
          m_of[g] = m_size;
          stack.push_back(g);
        }
      }
      ++m_size;
    }
  }

  std::size_t size() const { return m_size; }
  std::size_t operator[](Facet_index f) const { return m_of[f]; }

private:
  static constexpr std::size_t unset = std::size_t(-1);
  std::vector<std::size_t> m_of;
  std::size_t m_size = 0;
};

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FACET_ADJACENCY_H
