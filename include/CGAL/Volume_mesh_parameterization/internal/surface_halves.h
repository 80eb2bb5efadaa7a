// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_HALVES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_HALVES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>
#include <CGAL/Volume_mesh_parameterization/internal/shortest_path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
A closed surface that is cut open along disjoint simple loops, which together do not separate it. Of each loop there
are two copies on the border, its sides. A vertex knows which vertex of the closed surface it comes from; to one that
bisects an edge the next free number of the closed surface is given.
*/
class Open_surface {
public:
  using Id = Refined_surface::Id;
  using Path = std::vector<Id>;

  // The loops must be cut on the closed surface.
  explicit Open_surface(const Refined_surface& closed)
      : m_closed(closed), m_number_of_origins(closed.number_of_vertices()), m_vertex_of(copy_vertices()) {
    for (Id t = 0; t < closed.number_of_triangles(); ++t)
      surface.add_triangle({m_vertex_of[3 * t], m_vertex_of[3 * t + 1], m_vertex_of[3 * t + 2]},
                           closed.parent(t), closed.weights(t));
    surface.link();
    surface.cut_border();
  }

  // The copies of a loop on its left.
  Path left_side(const Path& loop) const {
    Path side;
    for (std::size_t i = 1; i < loop.size(); ++i)
      side.push_back(m_vertex_of[half_edge(loop[i - 1], loop[i])]);
    return side;
  }
  Path right_side(const Path& loop) const { return left_side(Path(loop.rbegin(), loop.rend())); }

  Id bisect(Id v, Id w) {
    origins.push_back(Id(m_number_of_origins++));
    splits.push_back({origins[v], origins[w]});
    return surface.bisect(surface.half_edge(v, w));
  }

  void cut(const Path& path) {
    surface.cut(path);
    for (const auto& [v, w] : surface.split_chords()) {
      origins.push_back(Id(m_number_of_origins++));
      splits.push_back({origins[v], origins[w]});
    }
  }

  Refined_surface surface;
  Path origins; // of vertices
  std::vector<std::array<Id, 2>>
      splits; // edges of the closed surface, in the order of the vertices that bisect them

private:
  // The half-edge of the closed surface from v to w.
  Id half_edge(Id v, Id w) const {
    const Id h = m_closed.half_edge(v, w);
    return m_closed.source(h) == v ? h : m_closed.opposite(h);
  }

  // A vertex for each class of corners that are glued along edges off the cuts.
  Path copy_vertices() {
    Disjoint_sets fans(m_closed.number_of_half_edges());
    for (Id h = 0; h < m_closed.number_of_half_edges(); ++h) {
      if (m_closed.is_cut(h)) continue;
      const Id g = m_closed.opposite(h);
      fans.join(h, Refined_surface::next(g));
      fans.join(Refined_surface::next(h), g);
    }
    Path vertex_of(m_closed.number_of_half_edges());
    for (Id corner = 0; corner < vertex_of.size(); ++corner) {
      const Id representative = fans.representative(corner), v = m_closed.source(corner);
      if (representative == corner) {
        vertex_of[corner] = surface.add_vertex(m_closed.points()[v]);
        origins.push_back(v);
      }
      vertex_of[corner] = vertex_of[representative];
    }
    return vertex_of;
  }

  const Refined_surface& m_closed;
  std::size_t m_number_of_origins;
  Path m_vertex_of; // corners of the closed surface
};

/*
Halves a closed surface of genus n along n loops and one more curve, so that each half is a disk with n holes.

Cut open along the loops, the surface is a sphere with 2 n holes. Of each loop the side that looks up belongs to the
ceiling, the other one to the floor. Two disjoint trees of shortest paths join the sides of either kind, and from both
the halves grow until they meet: both are connected, hence there is one curve between them. `rise`, by vertices of the
closed surface, is the height of the outward unit normal; to go where it has the wrong sign costs more.
*/
class Surface_halver {
public:
  using Id = Refined_surface::Id;
  using Path = std::vector<Id>;
  using Vector_3 = Double_kernel::Vector_3;

  Surface_halver(const Refined_surface& closed, const std::vector<Path>& loops, const Vector_3& direction,
                 std::vector<double> rise)
      : m_direction(direction), m_rise(std::move(rise)), m_open(closed) {
    for (const Path& loop : loops) {
      const bool is_left_up = ascent_to_left(closed, loop) > 0;
      m_sides[is_left_up ? up : down].push_back(m_open.left_side(loop));
      m_sides[is_left_up ? down : up].push_back(m_open.right_side(loop));
    }
  }

  Status run() {
    Status status = join_sides(down);
    if (status.ok()) status = join_sides(up);
    if (!status.ok()) return status;
    grow();
    split_crossed_edges();
    return {};
  }

  const std::vector<std::array<Id, 2>>& splits() const { return m_open.splits; }

  // The triangles of one half, with vertices of the closed surface.
  std::vector<Refined_surface::Triangle> triangles(bool upper) const {
    std::vector<Refined_surface::Triangle> result;
    for (const Refined_surface::Triangle& t : m_open.surface.triangles())
      if ((m_half[t[0]] == up || m_half[t[1]] == up || m_half[t[2]] == up) == upper)
        result.push_back({m_open.origins[t[0]], m_open.origins[t[1]], m_open.origins[t[2]]});
    return result;
  }

private:
  enum Half : char { down, up, neither };
  static constexpr double wrong_way = 20; // how many times longer a way against the rise is

  // How far it goes up from a loop into the facets on its left and down into those on its right, by length.
  double ascent_to_left(const Refined_surface& closed, const Path& loop) const {
    double ascent = 0;
    for (std::size_t i = 1; i < loop.size(); ++i) {
      const Id h = closed.half_edge(loop[i - 1], loop[i]);
      const Vector_3 edge = closed.points()[loop[i]] - closed.points()[loop[i - 1]];
      const Vector_3 normal = closed.unit_normal(h / 3) + closed.unit_normal(closed.opposite(h) / 3);
      ascent += CGAL::cross_product(normal, edge) * m_direction;
    }
    return ascent;
  }

  double length(Id v, Id w, Half half) const {
    const double rise = (m_rise[m_open.origins[v]] + m_rise[m_open.origins[w]]) / 2;
    return m_open.surface.length(v, w) * (1 + wrong_way * std::max(0., half == up ? -rise : rise));
  }

  Status join_sides(Half half) {
    std::vector<Path>& sides = m_sides[half];
    const auto length_here = [&](Id v, Id w) { return length(v, w, half); };
    if (!sides.empty()) m_trees[half] = sides[0];
    for (std::size_t k = 1; k < sides.size(); ++k) {
      Path targets;
      for (std::size_t i = k; i < sides.size(); ++i)
        targets.insert(targets.end(), sides[i].begin(), sides[i].end());
      const Path path = shortest_path(m_open.surface, m_trees[half], targets, length_here);
      if (path.empty())
        return {ERROR_NO_PARTITION,
                "no path on the " + std::string(half == up ? "ceiling" : "floor") + " joins two loops"};
      const auto reached = std::find_if(sides.begin() + k, sides.end(), [&](const Path& side) {
        return std::find(side.begin(), side.end(), path.back()) != side.end();
      });
      std::swap(*reached, sides[k]);
      m_trees[half].insert(m_trees[half].end(), path.begin(), path.end());
      m_trees[half].insert(m_trees[half].end(), sides[k].begin(), sides[k].end());
      cut(path);
    }
    return {};
  }

  void cut(const Path& path) {
    const std::size_t first = m_open.splits.size();
    m_open.cut(path);
    for (std::size_t k = first; k < m_open.splits.size(); ++k)
      m_rise.push_back((m_rise[m_open.splits[k][0]] + m_rise[m_open.splits[k][1]]) / 2);
  }

  // From the trees, or from the lowest and the highest vertex if there are no loops, each vertex joins the half that
  // reaches it first.
  void grow() {
    using Entry = std::pair<double, Id>;
    const std::size_t n = m_open.surface.number_of_vertices();
    std::vector<double> distance(n, std::numeric_limits<double>::infinity());
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    m_half.assign(n, neither);
    for (Half half : {down, up})
      for (Id v : m_trees[half].empty() ? Path{extreme_vertex(half)} : m_trees[half]) {
        m_half[v] = half;
        queue.push({distance[v] = 0, v});
      }
    while (!queue.empty()) {
      const auto [at_v, v] = queue.top();
      queue.pop();
      if (at_v > distance[v]) continue;
      m_open.surface.for_each_neighbor(v, [&, at = at_v, v = v](Id w) {
        const double d = at + length(v, w, m_half[v]);
        if (!(d < distance[w])) return;
        m_half[w] = m_half[v];
        queue.push({distance[w] = d, w});
      });
    }
  }

  Id extreme_vertex(Half half) const {
    const auto& points = m_open.surface.points();
    Id best = 0;
    for (Id v = 1; v < points.size(); ++v) {
      const double ascent = (points[v] - points[best]) * m_direction;
      const bool is_first = ascent == 0 && comes_before(v, best, [&](Id u) { return points[u]; });
      if ((half == up ? ascent > 0 : ascent < 0) || is_first) best = v;
    }
    return best;
  }

  // Then no triangle has vertices in both halves.
  void split_crossed_edges() {
    const Refined_surface& surface = m_open.surface;
    std::vector<std::array<Id, 2>> crossed;
    for (Id h = 0; h < surface.number_of_half_edges(); ++h)
      if (h < surface.opposite(h) && m_half[surface.source(h)] != m_half[surface.target(h)])
        crossed.push_back({surface.source(h), surface.target(h)});
    sort_longest_first(crossed, [&](Id v) { return surface.points()[v]; });
    for (const auto& [v, w] : crossed) m_open.bisect(v, w);
    m_half.resize(surface.number_of_vertices(), neither);
  }

  Vector_3 m_direction;
  std::vector<double> m_rise; // by origin
  Open_surface m_open;
  std::array<std::vector<Path>, 2> m_sides; // of the loops, by half
  std::array<Path, 2> m_trees; // all vertices on the sides and on the paths between them, by half
  std::vector<Half> m_half;    // of vertices
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_HALVES_H
