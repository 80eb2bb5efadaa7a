// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_WALLS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_WALLS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/cut_along_level.h>
#include <CGAL/Volume_mesh_parameterization/internal/patch_cleanup.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_fields.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

// From a surface whose facets are all floor or ceiling to one with walls between them.

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Whether floor, ceiling and walls of a surface are those of a product, as far as counting can tell.
template <typename Surface>
Status validate_labels(const Surface& surface) {
  const Approximate_surface approximate = approximate_surface(surface);
  const auto& labels = boundary_labels(surface);
  return Partition_validator(approximate.adjacency, labels,
                             summarize(approximate.adjacency, labels, approximate.areas))
      .validate();
}

// Labels a surface if the labels, all walls being FIRST_WALL, are legal once fragments of less than `share` are removed.
template <typename Surface>
Status label_patches(Surface surface, const Approximate_surface& approximate, std::vector<int> labels,
                     double share, Surface& result) {
  remove_fragments(approximate, labels, share);
  number_walls(approximate, labels);
  assign_labels(surface, labels);
  const Status status = validate_labels(surface);
  if (status.ok()) result = std::move(surface);
  return status;
}

// No facet has values on both sides of `level`.
inline std::vector<int> labels_by_level(const Facet_adjacency& surface, const Vertex_field& values,
                                        double level, int below, int above) {
  std::vector<int> labels;
  for (Facet_index f : surface.facets()) {
    const auto& t = surface.triangle(f);
    labels.push_back(std::min({values[t[0]], values[t[1]], values[t[2]]}) < level ? below : above);
  }
  return labels;
}

// Isolines run in the middle between the bases: averaged ways give smooth walls, and better hexahedra. Other loops may run
// anywhere.
enum Way_to_middle { AVERAGED, UP_TO_RIDGES };

/*
How far the loops between floor and ceiling are away, as a share of the way to the middle of the base. That way is
averaged over the base. Up to ridges, where what is nearest changes from one loop to another or to a far part of the same
loop, it ends there at the latest: walls as wide as less than the whole way do not merge.
*/
class Loop_distances {
public:
  Loop_distances(const Approximate_surface& surface, const std::vector<int>& labels)
      : m_surface(surface),
        m_labels(labels),
        m_loop_of(surface.points.size(), none),
        m_arc_of(surface.points.size(), 0),
        m_nearest(surface.points.size(), none) {
    trace_loops();
    m_distance = Surface_distance(surface).from(m_loop_vertices);
    find_nearest();
  }

  // Negative on the floor.
  Vertex_field relative_height(Way_to_middle way) const {
    const Vertex_field ways = way_to_middle(way);
    Vertex_field height = m_distance;
    for (Facet_index f : m_surface.adjacency.facets())
      for (Vertex_index v : m_surface.adjacency.triangle(f))
        if (m_distance[v] > 0) height[v] = (m_labels[f] == FLOOR ? -1 : 1) * m_distance[v] / ways[v];
    return height;
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

  // The mean distance of a strip is half of that way, hence the factor.
  Vertex_field way_to_middle(Way_to_middle way) const {
    const double mean = m_distance.sum() / std::max<double>(1, double((m_distance.array() > 0).count()));
    Vertex_field ways = 2 * Surface_diffusion(m_surface, 4 * mean * mean).average(m_distance);
    if (way == AVERAGED) return ways;
    const Vertex_field to_ridges = way_to_ridges();
    for (Eigen::Index v = 0; v < ways.size(); ++v)
      if (to_ridges[v] > 0) ways[v] = std::min(ways[v], to_ridges[v]);
    return ways;
  }

  const Approximate_surface& m_surface;
  const std::vector<int>& m_labels;
  std::vector<Vertex_index> m_loop_vertices;
  std::vector<double> m_loop_lengths;
  std::vector<std::uint32_t> m_loop_of; // of vertices on loops
  std::vector<double> m_arc_of;         // of vertices on loops
  Vertex_field m_distance;
  std::vector<std::uint32_t> m_nearest; // vertices on loops
};

inline Vertex_field relative_height(const Approximate_surface& surface, const std::vector<int>& labels,
                                    Way_to_middle way) {
  return Loop_distances(surface, labels).relative_height(way);
}

// Makes what lies between the heights -1 and 1 the walls. If the two halves are disks with holes, this is legal for
// heights that are scaled up far enough.
template <typename Surface>
Status cut_walls(Surface halves, Vertex_field height, Surface& result) {
  // What isolines cut off may join a wall up to this share of the area; if it is more, the wall is too wide.
  constexpr double fragment_share = .005;
  Status status = cut_along_level(halves, height, -1);
  if (status.ok()) status = cut_along_level(halves, height, 1);
  if (!status.ok()) return status;
  const Approximate_surface approximate = approximate_surface(halves);
  std::vector<int> labels = labels_by_level(approximate.adjacency, height, -1, FLOOR, FIRST_WALL);
  const std::vector<int> upper = labels_by_level(approximate.adjacency, height, 1, FIRST_WALL, CEILING);
  for (std::size_t f = 0; f < labels.size(); ++f)
    labels[f] = std::max(labels[f] == FLOOR ? 0 : upper[f], int(FLOOR));
  return label_patches(std::move(halves), approximate, std::move(labels), fragment_share, result);
}

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_WALLS_H
