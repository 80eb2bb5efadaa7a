// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_MAP_BUILDER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_MAP_BUILDER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Floor_cutter.h>
#include <CGAL/Volume_mesh_parameterization/internal/Floor_rim.h>
#include <CGAL/Volume_mesh_parameterization/internal/Planar_positions.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/relax_planar_map.h>
#include <CGAL/Volume_mesh_parameterization/internal/tutte_embedding.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Returns how many triangles are not counterclockwise, by exact signs.
inline std::size_t count_flipped(const std::vector<Refined_surface::Triangle>& triangles,
                                 const std::vector<Double_kernel::Point_2>& images) {
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  const auto point = [&](Refined_surface::Id v) { return Kernel::Point_2(images[v].x(), images[v].y()); };
  return std::count_if(triangles.begin(), triangles.end(), [&](const Refined_surface::Triangle& t) {
    return CGAL::orientation(point(t[0]), point(t[1]), point(t[2])) != CGAL::LEFT_TURN;
  });
}

// Moves bottoms and tops of holes that are on nearly the same line to one line: each line becomes one of the hexahedra,
// and two that almost coincide would leave slivers between them.
inline std::vector<Rectangle_2> align(std::vector<Rectangle_2> rectangles) {
  constexpr double tolerance = 0.05; // of the edge of a square as large as the base
  const double distance = tolerance * std::sqrt(rectangles[0].area());
  std::vector<std::pair<double*, std::size_t>> lines;
  for (std::size_t r = 1; r < rectangles.size(); ++r) {
    lines.push_back({&rectangles[r].ymin, r});
    lines.push_back({&rectangles[r].ymax, r});
  }
  std::sort(lines.begin(), lines.end(), [](const auto& a, const auto& b) { return *a.first < *b.first; });
  for (std::size_t first = 0, end; first < lines.size(); first = end) {
    std::vector<char> is_in(rectangles.size(), 0); // both lines of one hole are never moved to the same
    double sum = 0;
    for (end = first; end < lines.size(); ++end) {
      if (is_in[lines[end].second]++ || *lines[end].first - *lines[first].first > distance) break;
      sum += *lines[end].first;
    }
    for (std::size_t k = first; k < end; ++k)
      *lines[k].first = first + 1 == end ? *lines[k].first : sum / double(end - first);
  }
  return rectangles;
}

// The steps from the floor of a mesh to its image in the plane.
template <typename GeomTraits>
class Floor_map_builder {
public:
  using Id = Refined_surface::Id;
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Point_2 = Double_kernel::Point_2;

  explicit Floor_map_builder(const Mesh& mesh) : m_mesh(mesh) {}

  Status build() {
    Status status = copy_floor();
    if (status.ok()) status = find_rims();
    if (status.ok()) status = choose_corners();
    if (status.ok()) status = embed();
    return status;
  }

  Refined_surface surface;
  std::vector<Vertex_index> mesh_vertices; // of the vertices that are no midpoints
  std::vector<Floor_rim> rims;             // the outer one, then the holes from left to right
  std::vector<int> wall_labels;            // of the rims
  std::vector<Rectangle_2> rectangles;     // of the rims
  std::vector<Point_2> images;

private:
  // The floor seen from inside of the solid, so that the floor map with w upwards preserves the orientation.
  Status copy_floor() {
    std::vector<Id> vertex_of(m_mesh.number_of_vertices(), Refined_surface::none);
    for (Facet_index f : m_mesh.boundary_facets()) {
      if (m_mesh.label(f) != FLOOR) continue;
      const auto v = m_mesh.vertices(f);
      for (Vertex_index w : v)
        if (vertex_of[w] == Refined_surface::none) {
          vertex_of[w] = surface.add_vertex(approximate(m_mesh.point(w)));
          mesh_vertices.push_back(w);
        }
      surface.add_triangle({vertex_of[v[0]], vertex_of[v[2]], vertex_of[v[1]]}, f,
                           {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}});
    }
    if (surface.number_of_triangles() == 0) return {ERROR_NUMBER_OF_PATCHES, "there is no floor"};
    return surface.link() ? check_topology() : Status(ERROR_NON_MANIFOLD, "an edge of the floor");
  }

  Status check_topology() const {
    std::vector<char> has_border(surface.number_of_vertices(), 0);
    std::size_t border = 0;
    for (Id h = 0; h < surface.number_of_half_edges(); ++h) {
      if (!surface.is_border(h)) continue;
      ++border;
      if (has_border[surface.source(h)]++)
        return {ERROR_PATCH_NOT_A_SURFACE,
                "floor at vertex " + std::to_string(mesh_vertices[surface.source(h)])};
    }
    if (!is_connected()) return {ERROR_PATCH_NOT_CONNECTED, "floor"};
    const long edges = long(surface.number_of_half_edges() + border) / 2;
    const long euler = long(surface.number_of_vertices()) - edges + long(surface.number_of_triangles());
    const long loops = long(internal::find_rims(surface).size());
    if (loops == 0 || euler != 2 - loops) return {ERROR_PATCH_TOPOLOGY, "the floor is no disk with holes"};
    return {};
  }

  bool is_connected() const {
    std::vector<char> is_seen(surface.number_of_triangles(), 0);
    std::vector<Id> stack(1, 0);
    std::size_t seen = is_seen[0] = 1;
    while (!stack.empty()) {
      const Id t = stack.back();
      stack.pop_back();
      for (Id h = 3 * t; h < 3 * t + 3; ++h)
        if (!surface.is_border(h) && !is_seen[surface.opposite(h) / 3]) {
          is_seen[surface.opposite(h) / 3] = 1;
          stack.push_back(surface.opposite(h) / 3);
          ++seen;
        }
    }
    return seen == surface.number_of_triangles();
  }

  // The longest rim is the outer one; the others are turned to run counterclockwise.
  Status find_rims() {
    rims = internal::find_rims(surface);
    const auto shorter = [&](const Floor_rim& a, const Floor_rim& b) {
      return loop_length(surface, a) < loop_length(surface, b);
    };
    std::iter_swap(rims.begin(), std::max_element(rims.begin(), rims.end(), shorter));
    for (std::size_t r = 0; r < rims.size(); ++r)
      refine_rim(surface, Corner_chooser::least_size(room(r)), rims[r]);
    for (std::size_t r = 1; r < rims.size(); ++r) std::reverse(rims[r].loop.begin(), rims[r].loop.end());
    surface.cut_border();
    surface.split_chords();
    return {};
  }

  // For the separators of the holes, which end on the bottom and the top of the outer rim.
  std::size_t room(std::size_t rim) const { return rim == 0 ? rims.size() : 1; }

  Status choose_corners() {
    std::vector<Point_2> positions;
    const Status status = Planar_positions(surface, rims).compute(positions);
    if (!status.ok()) return status;
    std::sort(rims.begin() + 1, rims.end(), [&](const Floor_rim& a, const Floor_rim& b) {
      return Planar_positions::center(a, positions).x() < Planar_positions::center(b, positions).x();
    });
    for (std::size_t r = 0; r < rims.size(); ++r) Corner_chooser(positions, room(r), rims[r]);
    find_wall_labels();
    return {};
  }

  void find_wall_labels() {
    std::vector<int> wall_at(m_mesh.number_of_vertices(), INTERIOR);
    for (Facet_index f : m_mesh.boundary_facets())
      if (m_mesh.label(f) >= FIRST_WALL)
        for (Vertex_index v : m_mesh.vertices(f)) wall_at[v] = m_mesh.label(f);
    const auto is_old = [this](Id v) { return v < mesh_vertices.size(); };
    for (const Floor_rim& rim : rims)
      wall_labels.push_back(wall_at[mesh_vertices[*std::find_if(rim.loop.begin(), rim.loop.end(), is_old)]]);
  }

  // Once with the rectangles measured on the floor, then, if all goes well, with those that fit best, aligned.
  Status embed() {
    Floor_cutter cutter(rims, surface);
    Status status = cutter.cut();
    if (status.ok()) status = embed_pieces(cutter);
    if (!status.ok()) return status;
    relax(ROUGHLY);
    const std::vector<Rectangle_2> aligned = align(rectangles);
    if (aligned != rectangles) {
      const std::vector<Point_2> relaxed = images;
      const std::vector<Rectangle_2> relaxed_rectangles = rectangles;
      cutter.set_rectangles(aligned);
      if (!embed_pieces(cutter).ok()) {
        images = relaxed;
        rectangles = relaxed_rectangles;
      }
    }
    relax(TO_MINIMUM);
    return {};
  }

  Status embed_pieces(const Floor_cutter& cutter) {
    std::vector<char> is_fixed;
    cutter.place(images, is_fixed);
    rectangles = cutter.rectangles();
    const auto& triangles = surface.triangles();
    Status status = tutte_embedding(triangles, is_fixed, Mean_value_weights{surface.points()}, images);
    if (status.ok() && count_flipped(triangles, images) > 0)
      status = tutte_embedding(triangles, is_fixed, Uniform_weights(), images);
    if (status.ok() && count_flipped(triangles, images) > 0) status = embed_adaptively(is_fixed);
    return status.ok() ? check() : status;
  }

  // Where the floor bulges behind a neck, an embedding shrinks it beyond the precision of numbers.
  Status embed_adaptively(const std::vector<char>& is_fixed) {
    constexpr int most_attempts = 30;
    const auto& triangles = surface.triangles();
    Stretch_weights weights(surface.number_of_vertices());
    Status status;
    for (int i = 0; i < most_attempts && status.ok() && count_flipped(triangles, images) > 0; ++i) {
      weights.adapt(triangles, surface.points(), images);
      status = tutte_embedding(triangles, is_fixed, weights, images);
    }
    return status;
  }

  // Positive triangles and a border that runs once along the rims: then the map is one to one, by its degree.
  Status check() const {
    const std::size_t flipped = count_flipped(surface.triangles(), images);
    if (flipped > 0) return {ERROR_FLOOR_MAP, std::to_string(flipped) + " of its triangles are flipped"};
    for (std::size_t r = 0; r < rims.size(); ++r)
      for (int k = 0; k < 4; ++k)
        if (!is_monotone(rims[r].side(k), rectangles[r].corners()[k], rectangles[r].corners()[(k + 1) % 4]))
          return {ERROR_FLOOR_MAP, "side " + std::to_string(k) + " of rim " + std::to_string(r) + " folds"};
    return {};
  }

  bool is_monotone(const std::vector<Id>& side, const std::array<double, 2>& from,
                   const std::array<double, 2>& to) const {
    const int axis = from[0] != to[0] ? 0 : 1;
    const double sign = to[axis] > from[axis] ? 1 : -1;
    for (std::size_t i = 0; i < side.size(); ++i) {
      if (images[side[i]][1 - axis] != from[1 - axis]) return false;
      if (i > 0 && !(sign * images[side[i - 1]][axis] < sign * images[side[i]][axis])) return false;
    }
    return images[side.front()][axis] == from[axis] && images[side.back()][axis] == to[axis];
  }

  // Less distortion, if the result is still exactly one to one.
  void relax(Relaxation goal) {
    std::vector<Point_2> start = images;
    std::vector<Rectangle_2> start_rectangles = rectangles;
    relax_planar_map(goal, surface, rims, rectangles, images);
    if (check().ok()) return;
    images.swap(start);
    rectangles.swap(start_rectangles);
  }

  const Mesh& m_mesh;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_MAP_BUILDER_H
