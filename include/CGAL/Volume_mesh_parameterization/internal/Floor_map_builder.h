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
#include <CGAL/Volume_mesh_parameterization/Floor_map_options.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Floor_embedding.h>
#include <CGAL/Volume_mesh_parameterization/internal/Floor_layout.h>
#include <CGAL/Volume_mesh_parameterization/internal/Floor_rim.h>
#include <CGAL/Volume_mesh_parameterization/internal/Planar_positions.h>
#include <CGAL/Volume_mesh_parameterization/internal/Rectangle_slicing.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/arrange_rectangles.h>

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

// The steps from the floor of a mesh to its image in the plane.
template <typename GeomTraits>
class Floor_map_builder {
public:
  using Id = Refined_surface::Id;
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Point_2 = Double_kernel::Point_2;

  Floor_map_builder(const Mesh& mesh, const Floor_map_options& options) : m_mesh(mesh), m_options(options) {}

  Status build() {
    Status status = check_options();
    if (status.ok()) status = copy_floor();
    if (status.ok()) status = find_rims();
    if (status.ok()) status = embed();
    return status.ok() ? meet_options() : status;
  }

  Floor_embedding floor;
  std::vector<Vertex_index> mesh_vertices; // of the vertices that are no midpoints
  std::vector<int> wall_labels;            // of the rims
  double height = 0;

private:
  Status check_options() const {
    for (double size : m_options.size)
      if (!(size >= 0 && std::isfinite(size)) || (m_options.integer_planes && size != std::round(size)))
        return {ERROR_WRONG_PARAMETER, "the size " + std::to_string(size) + " of the domain"};
    return {};
  }

  // The floor seen from inside of the solid, so that the floor map with w upwards preserves the orientation.
  Status copy_floor() {
    std::vector<Id> vertex_of(m_mesh.number_of_vertices(), Refined_surface::none);
    for (Facet_index f : m_mesh.boundary_facets()) {
      if (m_mesh.label(f) != FLOOR) continue;
      const auto v = m_mesh.vertices(f);
      for (Vertex_index w : v)
        if (vertex_of[w] == Refined_surface::none) {
          vertex_of[w] = floor.surface.add_vertex(approximate(m_mesh.point(w)));
          mesh_vertices.push_back(w);
        }
      floor.surface.add_triangle({vertex_of[v[0]], vertex_of[v[2]], vertex_of[v[1]]}, f,
                                 {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}});
    }
    if (floor.surface.number_of_triangles() == 0) return {ERROR_NUMBER_OF_PATCHES, "there is no floor"};
    return floor.surface.link() ? check_topology() : Status(ERROR_NON_MANIFOLD, "an edge of the floor");
  }

  Status check_topology() const {
    std::vector<char> has_border(floor.surface.number_of_vertices(), 0);
    std::size_t border = 0;
    for (Id h = 0; h < floor.surface.number_of_half_edges(); ++h) {
      if (!floor.surface.is_border(h)) continue;
      ++border;
      if (has_border[floor.surface.source(h)]++)
        return {ERROR_PATCH_NOT_A_SURFACE,
                "floor at vertex " + std::to_string(mesh_vertices[floor.surface.source(h)])};
    }
    if (!is_connected()) return {ERROR_PATCH_NOT_CONNECTED, "floor"};
    const long edges = long(floor.surface.number_of_half_edges() + border) / 2;
    const long euler =
        long(floor.surface.number_of_vertices()) - edges + long(floor.surface.number_of_triangles());
    const long loops = long(internal::find_rims(floor.surface).size());
    if (loops == 0 || euler != 2 - loops) return {ERROR_PATCH_TOPOLOGY, "the floor is no disk with holes"};
    return {};
  }

  bool is_connected() const {
    std::vector<char> is_seen(floor.surface.number_of_triangles(), 0);
    std::vector<Id> stack(1, 0);
    std::size_t seen = is_seen[0] = 1;
    while (!stack.empty()) {
      const Id t = stack.back();
      stack.pop_back();
      for (Id h = 3 * t; h < 3 * t + 3; ++h)
        if (!floor.surface.is_border(h) && !is_seen[floor.surface.opposite(h) / 3]) {
          is_seen[floor.surface.opposite(h) / 3] = 1;
          stack.push_back(floor.surface.opposite(h) / 3);
          ++seen;
        }
    }
    return seen == floor.surface.number_of_triangles();
  }

  // The longest rim is the outer one; the others are turned to run counterclockwise.
  Status find_rims() {
    std::vector<Floor_rim>& rims = floor.rims;
    rims = internal::find_rims(floor.surface);
    const auto shorter = [&](const Floor_rim& a, const Floor_rim& b) {
      return loop_length(floor.surface, a) < loop_length(floor.surface, b);
    };
    std::iter_swap(rims.begin(), std::max_element(rims.begin(), rims.end(), shorter));
    for (Floor_rim& rim : rims) refine_rim(floor.surface, Corner_chooser::least_size, rim);
    for (std::size_t r = 1; r < rims.size(); ++r) std::reverse(rims[r].loop.begin(), rims[r].loop.end());
    floor.surface.cut_border();
    floor.surface.split_chords();
    return {};
  }

  void find_wall_labels() {
    std::vector<int> wall_at(m_mesh.number_of_vertices(), INTERIOR);
    for (Facet_index f : m_mesh.boundary_facets())
      if (m_mesh.label(f) >= FIRST_WALL)
        for (Vertex_index v : m_mesh.vertices(f)) wall_at[v] = m_mesh.label(f);
    const auto is_old = [this](Id v) { return v < mesh_vertices.size(); };
    for (const Floor_rim& rim : floor.rims)
      wall_labels.push_back(wall_at[mesh_vertices[*std::find_if(rim.loop.begin(), rim.loop.end(), is_old)]]);
  }

  // First roughly from several starts, then with the rectangles that fit best, aligned.
  Status embed() {
    Status status = embed_roughly();
    if (!status.ok()) return status;
    find_wall_labels();
    static_cast<void>(floor.move_to(aligned(floor.rectangles))); // or else lines that nearly coincide stay so
    floor.relax(TO_MINIMUM);
    height = mean_height();
    return {};
  }

  // With all directions of x, corners that are extreme or right angles, and two layouts for each: it is hard to foretell what
  // suits a floor that is bent.
  Status embed_roughly() {
    const Floor_embedding start = floor;
    const Planar_positions planar(start.surface, start.rims);
    std::vector<Point_2> unturned;
    Status status = planar.compute(unturned);
    for (double axis : status.ok() ? planar.axes(unturned) : std::vector<double>()) {
      const std::vector<Point_2> positions = Planar_positions::turned(unturned, axis);
      Floor_embedding extreme = start, angular = start;
      choose_corners(positions, 0, extreme.rims);
      status = try_layouts(extreme, positions);
      choose_corners(positions, 1, angular.rims);
      const auto same_corners = [](const Floor_rim& a, const Floor_rim& b) { return a.has_corners_of(b); };
      if (!std::equal(extreme.rims.begin(), extreme.rims.end(), angular.rims.begin(), same_corners))
        status = try_layouts(angular, positions);
    }
    return floor.images.empty() ? status : Status();
  }

  static void choose_corners(const std::vector<Point_2>& positions, double angle_weight, std::vector<Floor_rim>& rims) {
    std::sort(rims.begin() + 1, rims.end(), [&](const Floor_rim& a, const Floor_rim& b) {
      return Planar_positions::center(a, positions).x() < Planar_positions::center(b, positions).x();
    });
    for (Floor_rim& rim : rims) Corner_chooser(positions, angle_weight, rim);
  }

  Status try_layouts(const Floor_embedding& uncut, const std::vector<Point_2>& positions) {
    Floor_layout layout(uncut.surface, uncut.rims);
    std::vector<Rectangle_2> rectangles;
    Status status = layout.measure(rectangles);
    if (status.ok()) status = try_layout(uncut, rectangles);
    if (uncut.rims.size() > 1 && layout.measure_positions(positions, rectangles)) status = try_layout(uncut, rectangles);
    return status;
  }

  // Keeps the result if it is the best so far.
  Status try_layout(const Floor_embedding& uncut, const std::vector<Rectangle_2>& rectangles) {
    constexpr double little = 0.01; // less of the energy is no reason to prefer a later one
    Floor_embedding candidate = uncut;
    const Status status = candidate.embed(separated(rectangles));
    if (!status.ok()) return status;
    const double energy = candidate.relax(ROUGHLY);
    if (energy < (1 - little) * m_energy || floor.images.empty()) {
      m_energy = energy;
      floor = std::move(candidate);
    }
    return status;
  }

  double mean_height() const {
    const auto point = [&](Vertex_index v) { return approximate(m_mesh.point(v)); };
    double volume = 0, bases = 0;
    for (Cell_index c : m_mesh.cells()) {
      const auto& v = m_mesh.cell(c);
      volume += CGAL::abs(CGAL::volume(point(v[0]), point(v[1]), point(v[2]), point(v[3])));
    }
    for (Facet_index f : m_mesh.boundary_facets()) {
      const auto v = m_mesh.vertices(f);
      if (m_mesh.label(f) == FLOOR || m_mesh.label(f) == CEILING)
        bases += std::sqrt(CGAL::squared_area(point(v[0]), point(v[1]), point(v[2])));
    }
    return 2 * volume / bases;
  }

  // Moves the planes to the sizes and the integers that are asked for.
  Status meet_options() {
    const std::array<double, 3>& size = m_options.size;
    if (!has_sizes() && !m_options.integer_planes) return {};
    const std::array<double, 3> factors = size_factors();
    floor.stretch({factors[0], factors[1]});
    std::vector<Rectangle_2> asked = floor.rectangles;
    for (int axis = 0; axis < 2; ++axis)
      if (size[axis] > 0) asked[0].high(axis) = size[axis];
    height = size[2] > 0 ? size[2] : height * factors[2];
    if (m_options.integer_planes) {
      asked = rounded(asked);
      height = (std::max)(1., std::round(height));
    }
    if (!are_rims(asked)) return {ERROR_WRONG_PARAMETER, "the domain is too small for integer planes"};
    const double scale = std::sqrt(factors[0] * factors[1]);
    const Status status = floor.move_to(asked, scale);
    if (status.ok()) floor.relax(TO_MINIMUM, m_options.integer_planes ? ALL_PLANES : OUTER_PLANES, scale);
    return status;
  }

  bool has_sizes() const { return m_options.size != std::array<double, 3>{0, 0, 0}; }

  // The sizes that are given over those found; for the others the geometric mean of these, or what leads to an integer grid.
  std::array<double, 3> size_factors() const {
    const std::array<double, 3> sizes = {floor.rectangles[0].width(), floor.rectangles[0].height(), height};
    double product = 1;
    int given = 0;
    std::array<double, 3> factors;
    for (int axis = 0; axis < 3; ++axis) {
      factors[axis] = m_options.size[axis] / sizes[axis];
      if (factors[axis] == 0) continue;
      product *= factors[axis];
      ++given;
    }
    const double common =
        given > 0 ? std::pow(product, 1. / given) : coarsest_integer_scale(floor.rectangles, height);
    for (double& factor : factors)
      if (factor == 0) factor = common;
    return factors;
  }

  const Mesh& m_mesh;
  const Floor_map_options& m_options;
  double m_energy = std::numeric_limits<double>::infinity(); // of the best embedding so far
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_MAP_BUILDER_H
