// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CEILING_MAP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CEILING_MAP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Floor_embedding.h>
#include <CGAL/Volume_mesh_parameterization/internal/Prism_wall.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Maps the ceiling of a solid to that of a prism: to given rectangles, with given corners, cut as the floor is. The cuts are
shortest in a picture of the ceiling, the images of its vertices under a map of the whole solid: so the way that they take
around the holes is the right one.
*/
class Ceiling_map {
public:
  using Id = Refined_surface::Id;
  using Point_2 = Double_kernel::Point_2;

  Ceiling_map(const Labelled_surface& surface, const std::vector<Prism_wall>& walls,
              const std::vector<Rectangle_2>& rectangles, const std::vector<Double_kernel::Point_3>& picture)
      : m_surface(surface), m_rectangles(rectangles) {
    copy_ceiling(picture);
    for (std::size_t k = 0; k < walls.size(); ++k) m_ceiling.rims.push_back(rim_of(walls[k]));
  }

  Status embed() {
    m_ceiling.surface.cut_border();
    m_ceiling.surface.split_chords();
    const Status status = m_ceiling.embed(m_rectangles);
    return status.ok() ? status : Status(ERROR_BOUNDARY_MAP, "ceiling: " + status.detail());
  }

  // Repeats the splits in the whole surface, and puts the images at the level of the ceiling.
  void write_to(Labelled_surface& surface, double level, std::vector<Double_kernel::Point_3>& images) {
    for (Id v = Id(m_vertices.size()); v < m_ceiling.surface.number_of_vertices(); ++v) {
      const auto& ends = m_ceiling.surface.split_edge(v);
      m_vertices.push_back(surface.bisect(m_vertices[ends[0]], m_vertices[ends[1]]));
    }
    images.resize(surface.surface.number_of_vertices(), Double_kernel::Point_3(0, 0, 0));
    for (Id v = 0; v < m_vertices.size(); ++v)
      images[m_vertices[v]] = {m_ceiling.images[v].x(), m_ceiling.images[v].y(), level};
  }

private:
  void copy_ceiling(const std::vector<Double_kernel::Point_3>& picture) {
    const Refined_surface& s = m_surface.surface;
    m_number.assign(s.number_of_vertices(), Refined_surface::none);
    for (Id t = 0; t < s.number_of_triangles(); ++t) {
      if (m_surface.labels[t] != CEILING) continue;
      Refined_surface::Triangle corners = s.triangles()[t];
      for (Id& v : corners) v = number(v, picture);
      m_ceiling.surface.add_triangle(corners, s.parent(t), s.weights(t));
    }
    m_ceiling.surface.link();
  }

  Id number(Id v, const std::vector<Double_kernel::Point_3>& picture) {
    constexpr double share = 0.01; // of the solid's own shape, so that no triangle of the picture degenerates
    if (m_number[v] == Refined_surface::none) {
      const Double_kernel::Point_3 flat(picture[v].x(), picture[v].y(), 0);
      m_number[v] =
          m_ceiling.surface.add_vertex(flat + share * (m_surface.surface.points()[v] - CGAL::ORIGIN));
      m_vertices.push_back(v);
    }
    return m_number[v];
  }

  // Rims of the plane run counterclockwise; those of walls around holes clockwise.
  Floor_rim rim_of(const Prism_wall& wall) const {
    std::vector<Id> loop = wall_rim(m_surface, wall.label, CEILING, wall.top[0]);
    std::array<Id, 4> corners = wall.top;
    const auto& c = wall.corners;
    const bool is_clockwise = CGAL::orientation(Point_2(c[0][0], c[0][1]), Point_2(c[1][0], c[1][1]),
                                                Point_2(c[2][0], c[2][1])) == RIGHT_TURN;
    if (is_clockwise) {
      std::reverse(loop.begin() + 1, loop.end());
      std::swap(corners[1], corners[3]);
    }
    for (Id& v : loop) v = m_number[v];
    for (Id& v : corners) v = m_number[v];
    return Floor_rim::with_corners(loop, corners);
  }

  const Labelled_surface& m_surface;
  const std::vector<Rectangle_2>& m_rectangles;
  Floor_embedding m_ceiling;
  std::vector<Id> m_number;   // of the vertices of the whole surface
  std::vector<Id> m_vertices; // of the whole surface
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CEILING_MAP_H
