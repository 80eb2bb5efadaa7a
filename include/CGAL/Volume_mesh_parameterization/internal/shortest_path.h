// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SHORTEST_PATH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SHORTEST_PATH_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The vertices on the way to v, of each of which the one before it is known; the first has none.
inline std::vector<Refined_surface::Id> path_to(Refined_surface::Id v, const std::vector<Refined_surface::Id>& before) {
  std::vector<Refined_surface::Id> path;
  for (; v != Refined_surface::none; v = before[v]) path.push_back(v);
  std::reverse(path.begin(), path.end());
  return path;
}

// Dijkstra's algorithm in O(n log n): the shortest path along edges, whose lengths are length(v, w), from one of the
// sources to one of the targets whose inner vertices, at least one, are off the cuts. Empty if there is none. Of equally
// short paths it takes the one whose last vertices come first by coordinates.
template <typename Length>
std::vector<Refined_surface::Id>
shortest_path(const Refined_surface& surface, const std::vector<Refined_surface::Id>& sources,
              const std::vector<Refined_surface::Id>& targets, const Length& length) {
  using Id = Refined_surface::Id;
  using Entry = std::pair<double, Id>;
  std::vector<double> distance(surface.number_of_vertices(), std::numeric_limits<double>::infinity());
  std::vector<Id> before(surface.number_of_vertices(), Refined_surface::none);
  std::vector<char> is_target(surface.number_of_vertices(), 0);
  for (Id v : targets) is_target[v] = 1;
  const auto comes_before = [&](Id v, Id w) {
    return internal::comes_before(v, w, [&](Id u) { return surface.points()[u]; });
  };
  const auto is_later = [&](const Entry& a, const Entry& b) {
    return a.first != b.first ? a.first > b.first : comes_before(b.second, a.second);
  };
  std::priority_queue<Entry, std::vector<Entry>, decltype(is_later)> queue(is_later);
  for (Id v : sources) queue.push({distance[v] = 0, v});
  while (!queue.empty()) {
    const Entry entry = queue.top();
    const Id v = entry.second;
    queue.pop();
    if (entry.first > distance[v]) continue;
    if (is_target[v]) return path_to(v, before);
    surface.for_each_neighbor(v, [&](Id w) {
      const bool may_enter = !surface.is_on_cut(w) || (is_target[w] && !surface.is_on_cut(v));
      const double d = entry.first + length(v, w);
      const bool is_shorter = d < distance[w];
      // never along an edge so short that it adds nothing: the path must not close up
      const bool is_equal = d == distance[w] && entry.first < d && before[w] != Refined_surface::none &&
                            comes_before(v, before[w]);
      if (!may_enter || !(is_shorter || is_equal)) return;
      distance[w] = d;
      before[w] = v;
      if (is_shorter) queue.push({d, w});
    });
  }
  return {};
}

inline std::vector<Refined_surface::Id> shortest_path(const Refined_surface& surface,
                                                      const std::vector<Refined_surface::Id>& sources,
                                                      const std::vector<Refined_surface::Id>& targets) {
  using Id = Refined_surface::Id;
  return shortest_path(surface, sources, targets, [&](Id v, Id w) { return surface.length(v, w); });
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SHORTEST_PATH_H
