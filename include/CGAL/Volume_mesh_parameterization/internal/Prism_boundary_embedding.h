// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRISM_BOUNDARY_EMBEDDING_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRISM_BOUNDARY_EMBEDDING_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_images_3.h>
#include <CGAL/Volume_mesh_parameterization/Floor_map_options.h>
#include <CGAL/Volume_mesh_parameterization/internal/Axis_aligned_map.h>
#include <CGAL/Volume_mesh_parameterization/internal/Ceiling_map.h>
#include <CGAL/Volume_mesh_parameterization/internal/harmonic_wall_directions.h>
#include <CGAL/Volume_mesh_parameterization/internal/Wall_cutter.h>
#include <CGAL/Volume_mesh_parameterization/internal/relax_axis_aligned_map.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Extends the floor map to a map of the whole boundary of a solid onto that of the prism: corners of the ceiling, the ceiling
in convex pieces like the floor, creases along the walls, the rectangles between them. Then the whole surface is relaxed,
with vertices that slide and planes that move.

A picture of the surface, the images of its vertices under the map of the solid along curves, tells where corners and
cuts should run, and which way around the holes: a map of the boundary that takes another way does not extend to the inside.
*/
template <typename FloorMap>
class Prism_boundary_embedding {
public:
  using Geom_traits = typename FloorMap::Geom_traits;
  using Mesh = Compact_tetrahedral_mesh_3<Geom_traits>;
  using Id = Refined_surface::Id;
  using Point_3 = Double_kernel::Point_3;

  // picture: of the vertices of the mesh
  Prism_boundary_embedding(const Mesh& mesh, const FloorMap& floor_map, const Floor_map_options& options,
                           std::vector<Point_3> picture)
      : m_surface(mesh),
        m_floor_map(floor_map),
        m_domain(floor_map.domain()),
        m_options(options),
        m_picture(std::move(picture)) {
    cut_rims();
    copy_floor();
    for (std::size_t rim = 0; rim < m_domain.number_of_rims(); ++rim) m_walls.push_back(wall_over(rim));
  }

  // evenness: how much the corners of the ceiling depend on lengths alone, from 0 to 1
  Status embed(double evenness) {
    Wall_cutter wall_cutter(m_surface, m_walls,
                            harmonic_wall_directions(m_surface, m_walls, m_picture, evenness));
    wall_cutter.choose_corners();
    Status status = map_ceiling();
    if (status.ok()) status = wall_cutter.cut();
    if (!status.ok()) return status;
    add_planes();
    status = map_walls();
    if (status.ok()) relax(WHILE_FAST);
    return status;
  }

  // At the scale of the domain.
  void relax(Relaxation goal) {
    const auto& triangles = m_surface.surface.triangles();
    const double scale = std::sqrt(m_domain.base_area() / floor_area());
    std::vector<Point_3> points;
    for (const Point_3& p : m_surface.surface.points())
      points.push_back(CGAL::ORIGIN + scale * (p - CGAL::ORIGIN));
    Axis_aligned_map relaxed = m_map;
    const double energy = relax_axis_aligned_map(goal, triangles, points, relaxed);
    if (relaxed.count_flipped(triangles) > 0) return;
    m_energy = energy;
    m_map = std::move(relaxed);
  }

  // Over the area, at the scale of the domain: 4 for an isometry.
  double energy() const { return m_energy; }

  // The prism with the planes as they are now.
  Prism_3<Geom_traits> domain() const {
    std::vector<Rectangle_2> rims;
    for (const std::array<int, 4>& planes : m_planes_of_rims) rims.push_back(m_map.rectangle(planes));
    Prism_3<Geom_traits> prism(rims[0], {rims.begin() + 1, rims.end()}, m_map.planes[m_ceiling_plane].value);
    for (std::size_t rim = 0; rim < rims.size(); ++rim) prism.set_wall_label(rim, m_domain.wall_label(rim));
    return prism;
  }

  // The image of a vertex of the refined floor.
  const Point_3& floor_image(std::size_t v) const { return m_map.images[m_floor_vertices[v]]; }

  void write_to(Boundary_images_3<Geom_traits>& result) const {
    result = {};
    for (const Edge_split& s : m_surface.splits)
      result.bisected_edges.push_back({Vertex_index(s.v), Vertex_index(s.w)});
    for (const Point_3& p : m_map.images) result.images.emplace_back(p.x(), p.y(), p.z());
    result.energy = m_energy;
    result.may_slide = true;
  }

private:
  void cut_rims() {
    for (Id h = 0; h < m_surface.surface.number_of_half_edges(); ++h)
      if (m_surface.is_rim(h)) m_surface.surface.cut(h);
  }

  void copy_floor() {
    for (std::size_t v = 0; v < m_floor_map.number_of_vertices(); ++v) {
      const Vertex_index old = m_floor_map.mesh_vertex(v);
      if (old.is_valid())
        m_floor_vertices.push_back(old);
      else {
        const auto& ends = m_floor_map.bisected_edge(v);
        m_floor_vertices.push_back(m_surface.bisect(m_floor_vertices[ends[0]], m_floor_vertices[ends[1]]));
      }
    }
    m_map.images.assign(m_surface.surface.number_of_vertices(), Point_3(0, 0, 0));
    for (std::size_t v = 0; v < m_floor_vertices.size(); ++v) {
      const auto& p = m_floor_map.image(v);
      m_map.images[m_floor_vertices[v]] = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), 0};
    }
  }

  Prism_wall wall_over(std::size_t rim) const {
    Prism_wall wall;
    wall.label = m_domain.wall_label(rim);
    const auto corners = m_domain.rim(rim).corners();
    const auto is_at = [&](Id v, const std::array<double, 2>& c) {
      return m_map.images[v].x() == c[0] && m_map.images[v].y() == c[1];
    };
    std::vector<Id> loop = wall_rim(m_surface, wall.label, FLOOR);
    std::rotate(loop.begin(),
                std::find_if(loop.begin(), loop.end(), [&](Id v) { return is_at(v, corners[0]); }),
                loop.end());
    std::size_t k = 0;
    for (Id v : loop)
      for (const auto& c : corners)
        if (is_at(v, c)) {
          wall.bottom[k] = v;
          wall.corners[k++] = c;
        }
    CGAL_assertion(k == 4);
    return wall;
  }

  Status map_ceiling() {
    std::vector<Rectangle_2> rectangles;
    for (std::size_t rim = 0; rim < m_domain.number_of_rims(); ++rim) rectangles.push_back(m_domain.rim(rim));
    for (Id v = Id(m_picture.size()); v < m_surface.surface.number_of_vertices(); ++v) {
      const auto& ends = m_surface.surface.split_edge(v);
      m_picture.push_back(CGAL::midpoint(m_picture[ends[0]], m_picture[ends[1]]));
    }
    Ceiling_map ceiling(m_surface, m_walls, rectangles, m_picture);
    const Status status = ceiling.embed();
    if (status.ok()) ceiling.write_to(m_surface, m_domain.height(), m_map.images);
    return status;
  }

  // Sides of rims on the same line share a plane. A corner of the prism is where it is.
  void add_planes() {
    m_map.images.resize(m_surface.surface.number_of_vertices(), Point_3(0, 0, 0));
    m_map.vertex_planes.assign(m_map.images.size(), {m_map.no_plane, m_map.no_plane, m_map.no_plane});
    m_map.frames.assign(m_surface.surface.number_of_triangles(), Plane_frame());
    m_floor_plane = m_map.add_plane(2, 0, true);
    m_ceiling_plane = m_map.add_plane(2, m_domain.height(), false);
    for (std::size_t rim = 0; rim < m_domain.number_of_rims(); ++rim)
      m_planes_of_rims.push_back(m_map.add_planes(m_domain.rim(rim)));
    fix_planes();
    for (Id t = 0; t < m_map.frames.size(); ++t)
      if (m_surface.labels[t] < FIRST_WALL)
        put_on_plane(t, m_surface.labels[t] == FLOOR ? m_floor_plane : m_ceiling_plane,
                     m_surface.labels[t] == FLOOR ? -1 : 1);
  }

  // Two, as a map may be shifted, and those that the user asks for.
  void fix_planes() {
    for (int axis : {0, 1}) {
      m_map.planes[m_planes_of_rims[0][axis]].is_fixed = true;
      if (m_options.size[axis] > 0) m_map.planes[m_planes_of_rims[0][axis + 2]].is_fixed = true;
    }
    if (m_options.size[2] > 0) m_map.planes[m_ceiling_plane].is_fixed = true;
    for (Axis_aligned_map::Plane& plane : m_map.planes)
      plane.is_fixed = plane.is_fixed || m_options.integer_planes;
  }

  void put_on_plane(Id t, int plane, int normal_sign) {
    m_map.frames[t] = Plane_frame::orthogonal_to(m_map.planes[plane].axis, normal_sign);
    for (Id v : m_surface.surface.triangles()[t]) m_map.put_on_plane(v, plane);
  }

  // The plane of side k of a wall, whose outer side is on the right of the rim as seen from above.
  void put_side_on_plane(const Prism_wall& wall, int k, const std::vector<Id>& triangles) {
    const auto &from = wall.corners[k], &to = wall.corners[(k + 1) % 4];
    const int axis = from[0] == to[0] ? 0 : 1;
    const bool forward = to[1 - axis] > from[1 - axis];
    const int normal_sign = (axis == 0) == forward ? 1 : -1;
    for (Id t : triangles) put_on_plane(t, m_map.plane_at(axis, from[axis]), normal_sign);
  }

  // The triangles of the wall over side k: those reached from the rim without crossing a cut.
  std::vector<Id> triangles_over(const std::vector<Id>& side, int label, std::vector<char>& is_seen) const {
    const Refined_surface& s = m_surface.surface;
    Id start = s.half_edge(side[0], side[1]);
    if (m_surface.label(start) != label) start = s.opposite(start);
    std::vector<Id> found(1, start / 3);
    is_seen[start / 3] = 1;
    for (std::size_t i = 0; i < found.size(); ++i)
      for (Id h = 3 * found[i]; h < 3 * found[i] + 3; ++h) {
        const Id next = s.opposite(h) / 3;
        if (s.is_cut(h) || is_seen[next]) continue;
        is_seen[next] = 1;
        found.push_back(next);
      }
    return found;
  }

  void place_crease(const Prism_wall& wall, int k, std::vector<char>& is_fixed) {
    const std::vector<Id>& path = wall.creases[k];
    const double total = m_surface.surface.length(path);
    double arc = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (i > 0) arc += m_surface.surface.length(path[i - 1], path[i]);
      m_map.images[path[i]] = {wall.corners[k][0], wall.corners[k][1], arc / total * m_domain.height()};
      is_fixed[path[i]] = 1;
    }
  }

  Status map_walls() {
    const auto& triangles = m_surface.surface.triangles();
    std::vector<char> is_seen(triangles.size(), 0), is_fixed(m_map.images.size(), 1);
    for (const Prism_wall& wall : m_walls) {
      const std::vector<Id> rim = wall_rim(m_surface, wall.label, FLOOR, wall.bottom[0]);
      for (int k = 0; k < 4; ++k)
        put_side_on_plane(wall, k,
                          triangles_over(Prism_wall::side(rim, wall.bottom, k), wall.label, is_seen));
    }
    std::vector<Refined_surface::Triangle> of_walls;
    std::vector<Id> numbers;
    for (Id t = 0; t < triangles.size(); ++t)
      if (m_surface.labels[t] >= FIRST_WALL) {
        of_walls.push_back(triangles[t]);
        numbers.push_back(t);
        for (Id v : triangles[t]) is_fixed[v] = m_surface.surface.is_on_cut(v);
      }
    for (const Prism_wall& wall : m_walls)
      for (int k = 0; k < 4; ++k) place_crease(wall, k, is_fixed);
    m_map.snap_to_planes();
    const auto area = [&](std::size_t k) { return m_map.signed_area(of_walls[k], m_map.frames[numbers[k]]); };
    const auto count = [&] {
      m_map.snap_to_planes();
      return m_map.count_flipped(triangles);
    };
    const Status status =
        embed_convex_pieces(of_walls, m_surface.surface.points(), is_fixed, area, count, m_map.images);
    const std::size_t flipped = count();
    if (!status.ok() || flipped == 0) return status;
    return {ERROR_BOUNDARY_MAP, std::to_string(flipped) + " triangles of the walls are flipped"};
  }

  double floor_area() const {
    const auto& p = m_surface.surface.points();
    double area = 0;
    for (Id t = 0; t < m_surface.surface.number_of_triangles(); ++t) {
      const auto& v = m_surface.surface.triangles()[t];
      if (m_surface.labels[t] == FLOOR) area += std::sqrt(CGAL::squared_area(p[v[0]], p[v[1]], p[v[2]]));
    }
    return area;
  }

  Labelled_surface m_surface;
  Axis_aligned_map m_map;
  double m_energy = std::numeric_limits<double>::infinity();
  const FloorMap& m_floor_map;
  const Prism_3<Geom_traits>& m_domain;
  const Floor_map_options& m_options;
  std::vector<Point_3> m_picture;   // of the vertices
  std::vector<Id> m_floor_vertices; // of those of the refined floor
  std::vector<Prism_wall> m_walls;
  std::vector<std::array<int, 4>> m_planes_of_rims; // xmin, ymin, xmax, ymax
  int m_floor_plane = 0, m_ceiling_plane = 0;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRISM_BOUNDARY_EMBEDDING_H
