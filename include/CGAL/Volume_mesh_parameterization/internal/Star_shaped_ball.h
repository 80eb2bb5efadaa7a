// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAR_SHAPED_BALL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAR_SHAPED_BALL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Interior_mapper.h>
#include <CGAL/Volume_mesh_parameterization/internal/Surface_topology.h>
#include <CGAL/Volume_mesh_parameterization/internal/analytic_centre.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
A ball of cells around flipped ones whose boundary is mapped one to one onto a surface that a point, the centre, sees all of.
What is flipped inside does not matter: the image of the ball can be filled anew.

The boundary is a sphere, and the centre is on the inner side of each of its triangles: so the projection from the centre is a
covering of a sphere, but for vertices that it may wind around more than once. One ray meets one triangle only: as its degree is
one, it does not. What a sphere bounds in space is a ball.
*/
template <typename GeomTraits>
class Star_shaped_ball {
public:
  using Mapper = Interior_mapper<GeomTraits>;
  using Position = typename Mapper::Position;
  using Cells = std::vector<Cell_index>;

  explicit Star_shaped_ball(const Mapper& mapper) : m_mapper(mapper) {}

  // The smallest ball around flipped cells that is seen whole from the middle of one of them or of their neighbors, of some of
  // them if there are many; returns whether there is one of at most that many cells.
  bool grow_around(const Cells& flipped, const Cells& flipped_and_neighbors, std::size_t most_cells) {
    m_is_in.resize(m_mapper.mesh().number_of_cells(), 0);
    Position best = Position::Zero();
    bool is_found = false;
    const std::size_t stride = 1 + flipped_and_neighbors.size() / most_candidates;
    for (std::size_t k = 0; k < flipped_and_neighbors.size(); k += stride) {
      const Position middle = m_mapper.middle(flipped_and_neighbors[k]);
      if (!grow(flipped, middle, most_cells)) continue;
      is_found = true;
      best = middle;
      most_cells = m_cells.size() - 1;
    }
    if (!is_found || !grow(flipped, best, most_cells + 1)) return false;
    move_centre();
    return true;
  }

  const Cells& cells() const { return m_cells; }
  const Position& centre() const { return m_centre; }

private:
  static constexpr std::size_t most_candidates = 100;

  // Of a cell of the ball.
  struct Facet {
    Cell_index cell;
    int index;
  };

  const Splittable_mesh<GeomTraits>& mesh() const { return m_mapper.mesh(); }

  // Adds cells behind facets that the centre cannot see, until there is nothing left of that.
  bool grow(const Cells& flipped, const Position& centre, std::size_t most_cells) {
    for (Cell_index c : m_cells) m_is_in[c] = 0;
    m_cells.clear();
    m_centre = centre;
    for (Cell_index c : flipped) add(c);
    for (std::size_t first = 0; first < m_cells.size();) {
      for (; first < m_cells.size(); ++first)
        if (m_cells.size() > most_cells || !add_behind_hidden_facets(m_cells[first])) return false;
      find_facets();
      add_around_pinched_vertices();
    }
    return is_sphere() && has_degree_one();
  }

  // Returns false where there is nothing behind.
  bool add_behind_hidden_facets(Cell_index c) {
    for (int i = 0; i < 4; ++i) {
      if (is_seen({c, i})) continue;
      const Cell_index neighbor = mesh().neighbor(c, i);
      if (!neighbor.is_valid()) return false;
      add(neighbor);
    }
    return true;
  }

  // To where it sees all well.
  void move_centre() {
    constexpr int steps = 20;
    std::vector<Half_space<3>> half_spaces;
    for (const Facet& f : m_facets)
      half_spaces.push_back(half_space_inside(m_mapper.images(f.cell), f.index));
    const Position before = m_centre;
    climb_barrier<3>(half_spaces, Position::Zero(), steps, m_centre);
    if (!is_seen_whole()) m_centre = before;
  }

  void add(Cell_index c) {
    if (m_is_in[c] != 0) return;
    m_is_in[c] = 1;
    m_cells.push_back(c);
  }

  void find_facets() {
    m_facets.clear();
    for (Cell_index c : m_cells)
      for (int i = 0; i < 4; ++i) {
        const Cell_index neighbor = mesh().neighbor(c, i);
        if (!neighbor.is_valid() || m_is_in[neighbor] == 0) m_facets.push_back({c, i});
      }
  }

  // Counterclockwise, seen from outside.
  std::array<Vertex_index, 3> vertices(const Facet& f) const {
    const auto& v = mesh().cell(f.cell);
    std::array<Vertex_index, 3> result{v[(f.index + 1) % 4], v[(f.index + 2) % 4], v[(f.index + 3) % 4]};
    if (f.index % 2 != 0) std::swap(result[1], result[2]);
    return result;
  }

  bool is_seen(const Facet& f) const {
    std::array<Position, 4> cone = m_mapper.images(f.cell);
    cone[f.index] = m_centre;
    return Mapper::orientation(cone) == POSITIVE;
  }
  bool is_seen_whole() const {
    return std::all_of(m_facets.begin(), m_facets.end(), [this](const Facet& f) { return is_seen(f); });
  }

  // A vertex, and the edge opposite to it of a triangle.
  using Link_edge = std::array<Vertex_index, 3>;

  // Where the boundary is no surface.
  void add_around_pinched_vertices() {
    std::vector<Link_edge> links;
    for (const Facet& f : m_facets) {
      const auto [a, b, c] = vertices(f);
      links.insert(links.end(), {{a, b, c}, {b, c, a}, {c, a, b}});
    }
    std::sort(links.begin(), links.end());
    for (std::size_t first = 0, end; first < links.size(); first = end) {
      for (end = first + 1; end < links.size() && links[end][0] == links[first][0];) ++end;
      if (is_one_cycle(links.begin() + first, links.begin() + end)) continue;
      for (Cell_index c : mesh().star(links[first][0])) add(c);
    }
  }

  template <typename Iterator>
  static bool is_one_cycle(Iterator begin, Iterator end) {
    const auto next = [&](Vertex_index v) {
      return std::find_if(begin, end, [&](const Link_edge& e) { return e[1] == v; });
    };
    std::ptrdiff_t length = 1;
    for (Iterator e = next((*begin)[2]); e != begin && e != end && length <= end - begin; e = next((*e)[2]))
      ++length;
    return length == end - begin;
  }

  bool is_sphere() const {
    std::vector<std::array<std::size_t, 3>> triangles;
    for (const Facet& f : m_facets) {
      const auto [a, b, c] = vertices(f);
      triangles.push_back({a, b, c});
    }
    const Surface_topology<3> surface(triangles);
    return surface.is_closed_manifold() && surface.number_of_components() == 1 &&
           surface.euler_characteristic() == 2;
  }

  bool has_degree_one() const {
    Position target = Position::Zero(); // in the first triangle
    for (Vertex_index v : vertices(m_facets[0])) target += m_mapper.images()[v] / 3;
    return std::none_of(m_facets.begin() + 1, m_facets.end(),
                        [&](const Facet& f) { return covers(f, target); });
  }

  // Whether the ray from the centre through a point meets a facet.
  bool covers(const Facet& f, const Position& target) const {
    for (int k = 1; k < 4; ++k) {
      std::array<Position, 4> tetrahedron = m_mapper.images(f.cell);
      tetrahedron[f.index] = m_centre;
      tetrahedron[(f.index + k) % 4] = target;
      if (Mapper::orientation(tetrahedron) == NEGATIVE) return false;
    }
    return true;
  }

  const Mapper& m_mapper;
  std::vector<char> m_is_in; // cells
  Cells m_cells;
  std::vector<Facet> m_facets;
  Position m_centre = Position::Zero();
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAR_SHAPED_BALL_H
