// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BALL_REFILLER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BALL_REFILLER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Star_shaped_ball.h>
#include <CGAL/Volume_mesh_parameterization/internal/analytic_centre.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Fills the image of a ball, which is star-shaped, with the images of its cells, all positive.

The cells are placed one by one, from the boundary of the ball inwards, so that what is left is a ball. The image is
triangulated at all times: by the cells that are placed, and by cones from the centre over the front, the boundary of what is
left. To place a cell is a bistellar flip of this triangulation:
  - with one facet on the front, it puts its fourth vertex into the cone over this facet: always possible;
  - with two, it replaces two cones by three tetrahedra: possible if the new edge passes behind the common one, as the centre sees
    it. If not, the new edge is bisected: its midpoint can be put close to the triangle of the centre and the common edge;
  - with three, it replaces three cones by two tetrahedra: possible if the common vertex is above the fourth facet. If not, this
    facet is split: its barycentre can be put behind the vertex;
  - with four, it is the last one.
Before anything is split, the vertices inside and the centre move to where there is room. As stars of a triangulation are never
empty, each has its place at any time: the analytic centre of its star.
*/
template <typename GeomTraits>
class Ball_refiller {
public:
  using Mapper = Interior_mapper<GeomTraits>;
  using Position = typename Mapper::Position;
  using Tetrahedron = std::array<Position, 4>;

  // most_added: cells that may be added by splits before the ball is given up
  Ball_refiller(Mapper& mapper, const Star_shaped_ball<GeomTraits>& ball, std::size_t most_added)
      : m_mapper(mapper),
        m_centre(ball.centre()),
        m_left(ball.cells()),
        m_cell_states(mesh().number_of_cells(), OUTSIDE),
        m_front(mesh().number_of_cells()),
        m_vertex_states(mapper.images().size(), WITHOUT_IMAGE),
        m_most_cells(mesh().number_of_cells() + most_added) {
    for (Cell_index c : m_left) m_cell_states[c] = REMAINING;
    for (Cell_index c : m_left)
      for (int i = 0; i < 4; ++i) {
        const Cell_index neighbor = mesh().neighbor(c, i);
        if (neighbor.is_valid() && m_cell_states[neighbor] == REMAINING) continue;
        m_front[c].set(i);
        for (int k = 1; k < 4; ++k) m_vertex_states[mesh().cell(c)[(i + k) % 4]] = FIXED;
      }
  }

  // Returns whether all cells are positive now. If not, all is as before.
  bool run() {
    constexpr std::size_t sweep_period = 8;
    constexpr int last_sweeps = 10;
    for (std::size_t step = 0; !m_left.empty(); ++step) {
      if (mesh().number_of_cells() > m_most_cells || !advance()) {
        undo();
        return false;
      }
      const auto is_placed = [this](Cell_index c) { return m_cell_states[c] == PLACED; };
      m_left.erase(std::remove_if(m_left.begin(), m_left.end(), is_placed), m_left.end());
      if (step % sweep_period == 0) relax(m_inside);
    }
    for (int sweep = 0; sweep < last_sweeps; ++sweep) relax(m_inside);
    return true;
  }

private:
  enum Cell_state : std::uint8_t { OUTSIDE, REMAINING, PLACED };
  enum Vertex_state : std::uint8_t { WITHOUT_IMAGE, FIXED, MOVABLE };
  // What can be done to a cell that has a facet on the front, the best first.
  enum Move { PLACE, PUT_VERTEX, SPLIT_FACET, SPLIT_EDGE, SPLIT_JOINING, NOTHING };
  using Facets = std::bitset<4>; // of a cell, by the vertices opposite to them

  const Splittable_mesh<GeomTraits>& mesh() const { return m_mapper.mesh(); }
  int slot(Cell_index c, Vertex_index v) const { return mesh().slot(mesh().cell(c), v); }
  std::vector<Vertex_index> facet(Cell_index c, int i) const {
    const auto& v = mesh().cell(c);
    return {v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4]};
  }
  bool has_image(Vertex_index v) const { return m_vertex_states[v] != WITHOUT_IMAGE; }

  bool advance() {
    Cell_index next;
    Move move = NOTHING;
    for (Cell_index c : m_left)
      if (const Move m = move_of(c); m < move) {
        move = m;
        next = c;
      }
    if ((move == SPLIT_FACET || move == SPLIT_EDGE) && place_where_room_can_be_made()) return true;
    if (move == NOTHING) return false;
    const auto v = mesh().cell(next);
    if (!make(move, next)) return false;
    relax({v.begin(), v.end()});
    return true;
  }

  Move move_of(Cell_index c) const {
    if (m_front[c].none()) return NOTHING;
    if (!leaves_ball(c)) return SPLIT_JOINING;
    if (m_front[c].count() == 1) return PUT_VERTEX;
    if (can_be_placed(c, m_front[c])) return PLACE;
    return m_front[c].count() == 2 ? SPLIT_EDGE : m_front[c].count() == 3 ? SPLIT_FACET : NOTHING;
  }

  bool make(Move move, Cell_index c) {
    switch (move) {
    case PLACE:
      place(c);
      return true;
    case PUT_VERTEX:
      return put_fourth_vertex(c);
    case SPLIT_FACET:
      return split_facet(c);
    case SPLIT_EDGE:
      return split_edge(c);
    case SPLIT_JOINING:
      return split_joining(c);
    default:
      return false;
    }
  }

  // The vertex opposite to the only facet on the front.
  Vertex_index fourth_vertex(Cell_index c) const {
    int i = 0;
    while (!m_front[c][i]) ++i;
    return mesh().cell(c)[i];
  }

  // Whether what is left without a cell is a ball: what the cell adds to the front must not be on it.
  bool leaves_ball(Cell_index c) const {
    if (m_front[c].count() == 1) return !has_image(fourth_vertex(c));
    if (m_front[c].count() > 2) return true;
    const auto [p, q] = new_edge(c);
    return !is_front_edge(p, q);
  }

  // The vertices opposite to the two facets that are on the front.
  std::array<Vertex_index, 2> new_edge(Cell_index c) const {
    std::array<Vertex_index, 2> result;
    std::size_t n = 0;
    for (int i = 0; i < 4 && n < 2; ++i)
      if (m_front[c][i]) result[n++] = mesh().cell(c)[i];
    return result;
  }

  bool is_front_edge(Vertex_index a, Vertex_index b) const {
    for (Cell_index c : mesh().cells_around({a, b}))
      for (int i = 0; i < 4; ++i)
        if (m_front[c][i] && mesh().cell(c)[i] != a && mesh().cell(c)[i] != b) return true;
    return false;
  }

  // Whether a cell is positive, and the centre is on the far sides of its facets that are not on the front.
  bool can_be_placed(Cell_index c, Facets front) const {
    if (!m_mapper.is_positive(c)) return false;
    for (int i = 0; i < 4; ++i)
      if (!front[i] && Mapper::orientation(cone(c, i)) != NEGATIVE) return false;
    return true;
  }

  void place(Cell_index c) {
    m_cell_states[c] = PLACED;
    for (int i = 0; i < 4; ++i) {
      if (m_front[c][i]) continue;
      const Cell_index neighbor = mesh().neighbor(c, i);
      for (int j = 0; j < 4; ++j)
        if (slot(c, mesh().cell(neighbor)[j]) == 4) m_front[neighbor].set(j);
    }
    m_front[c].reset();
  }

  void put(Vertex_index v, const Position& image) {
    if (m_vertex_states[v] == WITHOUT_IMAGE) {
      m_inside.push_back(v);
      m_before.push_back(m_mapper.images()[v]);
    }
    m_vertex_states[v] = MOVABLE;
    m_mapper.set_image(v, image);
  }

  // Into the middle of the cone.
  bool put_fourth_vertex(Cell_index c) {
    const Vertex_index v = fourth_vertex(c);
    const Tetrahedron t = cone(c, slot(c, v));
    put(v, (t[0] + t[1] + t[2] + t[3]) / 4);
    if (!can_be_placed(c, m_front[c])) return false;
    place(c);
    return true;
  }

  // The midpoint goes close to the triangle of the centre and the edge on the front, on one side of it. A cell that has not been
  // placed then has one facet on the front, and can be placed later.
  bool split_edge(Cell_index c) {
    const auto [p, q] = new_edge(c);
    std::vector<Vertex_index> front_edge;
    for (Vertex_index v : mesh().cell(c))
      if (v != p && v != q) front_edge.push_back(v);
    const Position at_edge = (m_mapper.images()[front_edge[0]] + m_mapper.images()[front_edge[1]]) / 2,
                   at_p = m_mapper.images()[p];
    if (!insert({p, q})) return false;
    const Vertex_index m(m_mapper.images().size() - 1);
    const Cell_index first = mesh().cells_around({front_edge[0], front_edge[1], m, p})[0],
                     second = mesh().cells_around({front_edge[0], front_edge[1], m, q})[0];
    Facets front_then = m_front[second];
    front_then.set(slot(second, q));
    constexpr double least_share = 1e-6;
    for (double share = .25; share > least_share; share /= 4) {
      m_mapper.set_image(m, (m_centre + (1 - share) * at_edge + share * at_p) / 2);
      if (!can_be_placed(first, m_front[first]) || !can_be_placed(second, front_then)) continue;
      put(m, m_mapper.images()[m]);
      place(first);
      place(second);
      return true;
    }
    return true;
  }

  // Behind the common vertex of the facets on the front.
  bool split_facet(Cell_index c) {
    int i = 0;
    while (m_front[c][i]) ++i;
    const Vertex_index apex = mesh().cell(c)[i];
    if (!insert(facet(c, i))) return false;
    const Vertex_index m(m_mapper.images().size() - 1);
    put(m, (m_centre + m_mapper.images()[apex]) / 2);
    const std::vector<Cell_index> children = mesh().cells_around({m, apex});
    for (Cell_index child : children)
      if (!m_mapper.is_positive(child) || Mapper::orientation(cone(child, slot(child, apex))) != NEGATIVE)
        return false;
    for (Cell_index child : children) place(child);
    return true;
  }

  // Splits an edge or else a facet inside that joins vertices of the front.
  bool split_joining(Cell_index c) {
    const auto v = mesh().cell(c);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j)
        if (has_image(v[i]) && has_image(v[j]) && !is_front_edge(v[i], v[j])) return insert({v[j], v[i]});
    for (int i = 0; i < 4; ++i) {
      const std::vector<Vertex_index> joining = facet(c, i);
      const bool is_joining =
          std::all_of(joining.begin(), joining.end(), [this](Vertex_index w) { return has_image(w); });
      if (!m_front[c][i] && is_joining) return insert(joining);
    }
    return false;
  }

  // Splits a simplex inside of what is left: its cells keep their facets that are on the front.
  bool insert(const std::vector<Vertex_index>& simplex) {
    std::vector<std::vector<Vertex_index>> on_front;
    for (Cell_index c : mesh().cells_around(simplex))
      for (int i = 0; i < 4; ++i)
        if (m_front[c][i]) on_front.push_back(sorted(facet(c, i)));
    const std::size_t before = mesh().number_of_cells();
    if (!m_unsplit) m_unsplit = m_mapper;
    if (!m_mapper.insert_inside(simplex).ok()) return false;
    m_cell_states.resize(mesh().number_of_cells(), REMAINING);
    m_front.resize(mesh().number_of_cells());
    m_vertex_states.push_back(WITHOUT_IMAGE);
    for (std::size_t c = before; c < mesh().number_of_cells(); ++c) m_left.emplace_back(c);
    const Vertex_index m(m_mapper.images().size() - 1);
    for (Cell_index c : mesh().star(m)) {
      const int i = slot(c, m);
      m_front[c].reset();
      m_front[c].set(i, std::find(on_front.begin(), on_front.end(), sorted(facet(c, i))) != on_front.end());
    }
    return true;
  }

  static std::vector<Vertex_index> sorted(std::vector<Vertex_index> vertices) {
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  void undo() {
    if (m_unsplit) m_mapper = std::move(*m_unsplit);
    for (std::size_t k = 0; k < m_inside.size(); ++k)
      if (m_inside[k] < m_mapper.images().size()) m_mapper.set_image(m_inside[k], m_before[k]);
  }

  // A tetrahedron that is to be positive, with a corner that may move.
  struct Corner {
    Tetrahedron tetrahedron;
    int slot;

    Half_space<3> half_space() const { return half_space_inside(tetrahedron, slot); }
    bool is_positive_at(const Position& p) const {
      Tetrahedron moved = tetrahedron;
      moved[slot] = p;
      return Mapper::orientation(moved) == POSITIVE;
    }
  };
  using Corners = std::vector<Corner>;

  Tetrahedron cone(Cell_index c, int i) const {
    Tetrahedron result = m_mapper.images(c);
    result[i] = m_centre;
    return result;
  }

  Corners star(Vertex_index v) const {
    Corners result;
    for (Cell_index c : mesh().star(v)) {
      const int k = slot(c, v);
      if (m_cell_states[c] == PLACED) result.push_back({m_mapper.images(c), k});
      for (int i = 0; i < 4; ++i)
        if (m_front[c][i] && i != k) result.push_back({cone(c, i), k});
    }
    return result;
  }

  Corners star_of_centre() const {
    Corners result;
    for (Cell_index c : m_left)
      for (int i = 0; i < 4; ++i)
        if (m_front[c][i]) result.push_back({cone(c, i), i});
    return result;
  }

  // Moves those of the vertices that may move, and the centre.
  void relax(const std::vector<Vertex_index>& vertices) {
    for (Vertex_index v : vertices)
      if (m_vertex_states[v] == MOVABLE) m_mapper.set_image(v, moved(m_mapper.images()[v], star(v), {}));
    if (!m_left.empty()) m_centre = moved(m_centre, star_of_centre(), {});
  }

  // Some cells are tried: each attempt moves the centre, which takes as long as the front is big.
  bool place_where_room_can_be_made() {
    int attempts = 20;
    for (Cell_index c : m_left) {
      const Move move = move_of(c);
      if (move != SPLIT_FACET && move != SPLIT_EDGE) continue;
      if (attempts-- == 0) return false;
      if (!make_room(c)) continue;
      place(c);
      return true;
    }
    return false;
  }

  // Moves the vertices of a cell that cannot be placed, and the centre, so that it can; returns whether that succeeded.
  bool make_room(Cell_index c) {
    constexpr int most_rounds = 5;
    for (int round = 0; round < most_rounds; ++round) {
      for (int k = 0; k < 4; ++k) {
        const Vertex_index v = mesh().cell(c)[k];
        if (m_vertex_states[v] == MOVABLE)
          m_mapper.set_image(v, moved(m_mapper.images()[v], star(v), wishes(c, k)));
      }
      m_centre = moved(m_centre, star_of_centre(), wishes_for_centre(c));
      if (can_be_placed(c, m_front[c])) return true;
    }
    return false;
  }

  // What has to be positive for a cell to be placed, as it depends on one of its vertices: itself, and the cones over its facets
  // that are not on the front, which are turned over.
  Corners wishes(Cell_index c, int k) const {
    Corners result{{m_mapper.images(c), k}};
    for (int i = 0; i < 4; ++i)
      if (!m_front[c][i] && i != k) result.push_back(turned({cone(c, i), k}));
    return result;
  }
  Corners wishes_for_centre(Cell_index c) const {
    Corners result;
    for (int i = 0; i < 4; ++i)
      if (!m_front[c][i]) result.push_back(turned({cone(c, i), i}));
    return result;
  }

  static Corner turned(Corner corner) {
    std::swap(corner.tetrahedron[(corner.slot + 1) % 4], corner.tetrahedron[(corner.slot + 2) % 4]);
    return corner;
  }

  // Where there is room in a star of positive tetrahedra, and where wishes that are not fulfilled come closer to it.
  static Position moved(const Position& start, const Corners& star, const Corners& wishes) {
    constexpr int steps = 3;
    constexpr double weight = 10; // of a wish, against that of a tetrahedron
    constexpr double flat = 1e-3; // the least depth, as a share of an edge
    std::vector<Half_space<3>> half_spaces;
    for (const Corner& corner : star) half_spaces.push_back(corner.half_space());
    Position direction = Position::Zero(), result = start;
    for (const Corner& wish : wishes) {
      const Half_space<3> h = wish.half_space();
      const double depth = -h.height(start), edge = (start - wish.tetrahedron[(wish.slot + 1) % 4]).norm();
      if (depth < 0)
        half_spaces.push_back(h);
      else
        direction += weight * h.slope / (std::max)(depth, flat * edge * h.slope.norm());
    }
    climb_barrier<3>(half_spaces, direction, steps, result);
    const bool is_fine =
        std::all_of(star.begin(), star.end(), [&](const Corner& c) { return c.is_positive_at(result); });
    return is_fine ? result : start;
  }

  Mapper& m_mapper;
  Position m_centre;
  std::vector<Cell_index> m_left;
  std::vector<Cell_state> m_cell_states;     // of the cells
  std::vector<Facets> m_front;               // facets of cells that are left
  std::vector<Vertex_state> m_vertex_states; // of the vertices
  std::vector<Vertex_index> m_inside;        // the movable ones
  std::size_t m_most_cells;
  std::vector<Position> m_before;  // where the movable ones were
  std::optional<Mapper> m_unsplit; // before the first split
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BALL_REFILLER_H
