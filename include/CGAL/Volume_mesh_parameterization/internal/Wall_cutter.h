// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_WALL_CUTTER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_WALL_CUTTER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Prism_wall.h>
#include <CGAL/Volume_mesh_parameterization/internal/shortest_path.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Cuts the walls of a solid along the creases of a prism.

A crease is a shortest path that keeps to the angle of its corner.
*/
class Wall_cutter {
public:
  using Id = Refined_surface::Id;
  using Path = std::vector<Id>;
  using Point_2 = Double_kernel::Point_2;

  // directions: the points of the unit circle, about, at the angles of the first vertices of the surface; all rims are cut
  Wall_cutter(Labelled_surface& surface, std::vector<Prism_wall>& walls, std::vector<Point_2> directions)
      : m_surface(surface), m_walls(walls), m_direction(std::move(directions)) {
    extend_angles();
  }

  // Chooses the corners of the ceiling.
  void choose_corners() {
    for (Prism_wall& wall : m_walls) choose_corners(wall);
  }

  Status cut() {
    m_surface.split_chords(); // or there may be no path
    extend_angles();
    for (Prism_wall& wall : m_walls)
      for (int k = 0; k < 4; ++k) {
        const Status status = cut_crease(wall, k);
        if (!status.ok()) return status;
      }
    return {};
  }

private:
  // Edges between neighbouring corners of the ceiling: room for the cuts that end there.
  std::size_t least_gap() const { return m_walls.size() + 3; }

  void extend_angles() {
    for (Id v = Id(m_direction.size()); v < m_surface.surface.number_of_vertices(); ++v) {
      const auto& ends = m_surface.surface.split_edge(v);
      m_direction.push_back(CGAL::midpoint(m_direction[ends[0]], m_direction[ends[1]]));
    }
  }

  // Between 0 and pi.
  double angle_between(Id v, Id w) const {
    const Point_2 &p = m_direction[v], &q = m_direction[w];
    return CGAL::abs(std::atan2(p.x() * q.y() - p.y() * q.x(), p.x() * q.x() + p.y() * q.y()));
  }

  std::size_t best_place(const Path& rim, std::size_t begin, std::size_t end, Id corner) const {
    const auto closer = [&](Id v, Id w) { return angle_between(v, corner) < angle_between(w, corner); };
    return std::min_element(rim.begin() + begin, rim.begin() + end, closer) - rim.begin();
  }

  void choose_corners(Prism_wall& wall) {
    Path rim = wall_rim(m_surface, wall.label, CEILING);
    while (rim.size() < 4 * least_gap()) {
      for (std::size_t i = 0; i < rim.size(); ++i) m_surface.bisect(rim[i], rim[(i + 1) % rim.size()]);
      extend_angles();
      rim = wall_rim(m_surface, wall.label, CEILING);
    }
    std::rotate(rim.begin(), rim.begin() + best_place(rim, 0, rim.size(), wall.bottom[0]), rim.end());
    wall.top[0] = rim[0];
    for (std::size_t k = 1, place = 0; k < 4; ++k) {
      place = best_place(rim, place + least_gap(), rim.size() - (4 - k) * least_gap() + 1, wall.bottom[k]);
      wall.top[k] = rim[place];
    }
  }

  Status cut_crease(Prism_wall& wall, int k) {
    constexpr double keeping = 20; // lengthens an edge by this for each radian off the angle
    const Id corner = wall.bottom[k];
    const auto length = [&](Id v, Id w) {
      return m_surface.surface.length(v, w) * (1 + keeping * angle_between(w, corner));
    };
    wall.creases[k] = shortest_path(m_surface.surface, {corner}, {wall.top[k]}, length);
    if (wall.creases[k].empty())
      return {ERROR_BOUNDARY_MAP, "no path joins corner " + std::to_string(k) + " of wall " +
                                      std::to_string(wall.label - FIRST_WALL) + " to the ceiling"};
    m_surface.surface.cut(wall.creases[k]);
    m_surface.split_chords();
    extend_angles();
    return {};
  }

  Labelled_surface& m_surface;
  std::vector<Prism_wall>& m_walls;
  std::vector<Point_2> m_direction; // of each vertex, about of unit length
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_WALL_CUTTER_H
