// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_BOUNDARY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_BOUNDARY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/cut_along_level.h>
#include <CGAL/Volume_mesh_parameterization/internal/cut_walls.h>
#include <CGAL/Volume_mesh_parameterization/internal/patch_cleanup.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_fields.h>
#include <CGAL/Volume_mesh_parameterization/propose_directions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationPartition

steers `partition_boundary()`.
*/
struct Partition_options {
  /// the width of walls on smooth surfaces, as a share of the way from the floor to the ceiling
  double wall_width = .5;
  /// parts of a patch that lie apart and have less than this share of the area are flipped
  double island_share = .15;
  /// whether edges of the surface may be split, to let the rims run where they should
  bool may_refine = true;
};

namespace internal {

/*
Labels a surface along directions. Two ways are tried:
- bands: the facets that are steep against the direction are the walls, if creases set them off;
- isolines: averaged normals n tell floor from ceiling by the sign of n * direction. The surface is cut where it
  changes, and again on both sides along lines of constant distance, relative to how far it is to the middle of the
  base: what lies between is the wall. For walls narrow enough this is legal if the first cut was.
*/
template <typename Surface>
class Boundary_partitioner {
public:
  using Vector_3 = Approximate_surface::Vector_3;

  Boundary_partitioner(const Surface& surface, const Partition_options& options)
      : m_surface(surface), m_options(options), m_approximate(approximate_surface(surface)) {}

  Status check_surface() const {
    if (!m_approximate.adjacency.status().ok()) return m_approximate.adjacency.status();
    return genus_of(m_approximate.adjacency) < 0
               ? Status(ERROR_SEVERAL_COMPONENTS, "the surface is not connected")
               : Status();
  }

  // Labels the surface along a unit vector, with walls of this width; on success `result` is the labelled surface.
  Status run(const Vector_3& direction, double wall_width, Surface& result) {
    Status status = try_bands(direction, result);
    for (std::size_t k = 0; k < number_of_averages && !status.ok() && m_options.may_refine; ++k)
      status = try_isolines(direction, k, wall_width, result);
    return status;
  }

private:
  // Walls at creases: the steep facets hardly depend on where steepness starts.
  static constexpr double least_steepness = .2, steepness = .4, largest_steepness = .6;
  static constexpr double undecided_share = .02;
  // Normals are averaged over these shares of the area.
  static constexpr std::size_t number_of_averages = 5;
  static constexpr double averages[number_of_averages] = {1e-4, 3e-4, 1e-3, 3e-3, 1e-2};

  // The cosine of the angle between the normal of a facet and the direction.
  double rise(Facet_index f, const Vector_3& direction) const {
    const double area = m_approximate.areas[f];
    return area > 0 ? m_approximate.area_vector(f) * direction / area : 0;
  }

  Status try_bands(const Vector_3& direction, Surface& result) const {
    double undecided = 0;
    for (Facet_index f : m_approximate.adjacency.facets()) {
      const double r = std::abs(rise(f, direction));
      if (r > least_steepness && r < largest_steepness) undecided += m_approximate.areas[f];
    }
    return undecided > undecided_share * m_approximate.total_area
               ? Status(ERROR_NO_PARTITION, "no creases set the walls off")
               : label_bands(direction, result);
  }

  Status label_bands(const Vector_3& direction, Surface& result) const {
    std::vector<int> labels;
    for (Facet_index f : m_approximate.adjacency.facets()) {
      const double r = rise(f, direction);
      labels.push_back(r < -steepness ? FLOOR : r > steepness ? CEILING : FIRST_WALL);
    }
    return label_patches(m_surface, m_approximate, std::move(labels), m_options.island_share, result);
  }

  Status try_isolines(const Vector_3& direction, std::size_t k, double wall_width, Surface& result) {
    Surface halves = m_surface;
    Vertex_field rise = average_rise(direction, k);
    Status status = cut_along_level(halves, rise, 0);
    if (!status.ok()) return status;
    const Approximate_surface approximate = approximate_surface(halves);
    std::vector<int> labels = labels_by_level(approximate.adjacency, rise, 0, FLOOR, CEILING);
    remove_islands(approximate, labels, m_options.island_share);
    status = check_halves(approximate, labels);
    if (!status.ok()) return status;
    return cut_walls(std::move(halves), relative_height(approximate, labels, AVERAGED) / wall_width, result);
  }

  const std::array<Vertex_field, 3>& normals(std::size_t k) {
    if (m_normals[k][0].size() == 0) m_normals[k] = averaged_normals(m_approximate, averages[k]);
    return m_normals[k];
  }

  Vertex_field average_rise(const Vector_3& d, std::size_t k) {
    const auto& n = normals(k);
    return d.x() * n[0] + d.y() * n[1] + d.z() * n[2];
  }

  // A closed surface of genus n is cut into two disks with n holes if it falls into two parts with n + 1 loops between.
  static Status check_halves(const Approximate_surface& surface, const std::vector<int>& labels) {
    const Boundary_partition_3 summary = summarize(surface.adjacency, labels, surface.areas);
    if (summary.patches.size() != 2) return {ERROR_NO_PARTITION, "all of the surface faces one side"};
    for (const Boundary_patch_3& patch : summary.patches) {
      if (patch.number_of_components != 1)
        return {ERROR_NO_PARTITION,
                "the " + patch.name() + " has " + std::to_string(patch.number_of_components) + " parts"};
      if (patch.number_of_border_loops != std::size_t(summary.genus + 1))
        return {ERROR_NO_PARTITION, std::to_string(patch.number_of_border_loops) +
                                        " loops separate floor and ceiling, but the genus is " +
                                        std::to_string(summary.genus)};
    }
    return {};
  }

  const Surface& m_surface;
  Partition_options m_options;
  Approximate_surface m_approximate;
  std::array<std::array<Vertex_field, 3>, number_of_averages> m_normals;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationPartition

finds partitions of the boundary of a solid, one after the other: those with walls as wide as the options say first, in
the order of the directions, then those for which the walls have to be narrower.

A partition has the counts that `validate_partition()` asks for. For a solid of positive genus this does not make it
legal: when `validate_fundamental_group()` refuses it, ask for the next one.

\tparam Surface `Triangle_soup_3<Point>`, oriented outwards, to be tetrahedralized later, or
`Compact_tetrahedral_mesh_3<GeomTraits>`
*/
template <typename Surface>
class Boundary_partition_search_3 {
public:
  /// starts a search. `surface` is kept by reference.
  Boundary_partition_search_3(const Surface& surface, std::vector<Sweep_direction_3> directions,
                              const Partition_options& options = {})
      : m_partitioner(surface, options),
        m_directions(std::move(directions)),
        m_is_done(m_directions.size(), 0),
        m_wall_width(options.wall_width) {}

  /// finds the next partition.
  /// \param result gets the surface with its labels; where the partitioner split edges it has more triangles
  /// \returns `ERROR_NO_PARTITION` if there are no more, with the reason for the last direction;
  /// `ERROR_WRONG_PARAMETER` for a zero direction, `ERROR_EMPTY_MESH`, `ERROR_OPEN_SURFACE`,
  /// `ERROR_NON_MANIFOLD` or `ERROR_SEVERAL_COMPONENTS`
  Status next(Surface& result) {
    Status status = check();
    for (; status.ok() && m_level < number_of_levels; ++m_level, m_next = 0)
      while (m_next < m_directions.size()) {
        if (m_is_done[m_next++]) continue;
        m_last = m_partitioner.run(direction() / internal::length(direction()),
                                   m_wall_width / std::pow(2, m_level), result);
        m_is_done[m_next - 1] = m_last.ok();
        if (m_last.ok()) return {};
      }
    if (!status.ok() || m_last.code() == ERROR_NO_PARTITION) return status.ok() ? m_last : status;
    return {ERROR_NO_PARTITION, m_last.ok() ? "there are no more directions" : m_last.message()};
  }

  /// returns the direction of the partition that was found last.
  const Sweep_direction_3& direction() const { return m_directions[m_next - 1]; }

private:
  static constexpr int number_of_levels = 6; // of halving the width of the walls

  Status check() const {
    const Status status = internal::check_directions(m_directions);
    return status.ok() ? m_partitioner.check_surface() : status;
  }

  internal::Boundary_partitioner<Surface> m_partitioner;
  std::vector<Sweep_direction_3> m_directions;
  std::vector<char> m_is_done;
  double m_wall_width;
  int m_level = 0;
  std::size_t m_next = 0;
  Status m_last;
};

/*!
\ingroup PkgVolumeMeshParameterizationPartition

labels a closed surface as floor, ceiling and walls of a sweep along `direction`: what faces away from it, what faces
it, and annuli between. On smooth surfaces edges are split, so that rims are smooth and walls broad.

\param surface gets the labels; on failure it is left as it was
\param direction from the floor to the ceiling, of any length
\param options see there

\returns the errors of `Boundary_partition_search_3::next()`
*/
template <typename Surface>
Status partition_boundary(Surface& surface, const Sweep_direction_3& direction,
                          const Partition_options& options = {}) {
  Surface result;
  const Status status = Boundary_partition_search_3<Surface>(surface, {direction}, options).next(result);
  if (status.ok()) surface = std::move(result);
  return status;
}

/*!
\ingroup PkgVolumeMeshParameterizationPartition

labels a closed surface along the first of the `propose_directions()` that works, which is written to `direction`.
*/
template <typename Surface>
Status partition_boundary(Surface& surface, const Partition_options& options = {},
                          Sweep_direction_3* direction = nullptr) {
  Surface result;
  Boundary_partition_search_3<Surface> search(surface, propose_directions(surface), options);
  const Status status = search.next(result);
  if (status.ok() && direction) *direction = search.direction();
  if (status.ok()) surface = std::move(result);
  return status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_BOUNDARY_H
