// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_BY_LOOPS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_BY_LOOPS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Splittable_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/cut_walls.h>
#include <CGAL/Volume_mesh_parameterization/internal/primitive_loops.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_fields.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_halves.h>
#include <CGAL/Volume_mesh_parameterization/partition_boundary.h>
#include <CGAL/Volume_mesh_parameterization/propose_directions.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Whether the floor carries the fundamental group is the condition on a partition that only the solid can tell.
template <typename GeomTraits>
Status validate_solid(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  Handlebody_certificate certificate;
  const Status status = certify_handlebody(mesh, certificate);
  return status.ok() ? validate_fundamental_group(mesh, certificate) : status;
}

// The boundary of a solid; vertices have the same numbers, those of the interior have no triangles.
template <typename GeomTraits>
Refined_surface refinable_boundary(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  Refined_surface surface;
  for (const auto& p : mesh.points()) surface.add_vertex(approximate(p));
  for (Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    surface.add_triangle({v[0], v[1], v[2]}, f, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  }
  surface.link();
  return surface;
}

// Bisects edges of the mesh one after the other; later ones may end at the midpoints of earlier ones.
template <typename GeomTraits>
Status bisect_edges(Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                    const std::vector<std::array<std::uint32_t, 2>>& edges) {
  Splittable_mesh<GeomTraits> splittable(mesh);
  Status status;
  for (std::size_t k = 0; k < edges.size() && status.ok(); ++k)
    status = splittable.insert_barycentre({Vertex_index(edges[k][0]), Vertex_index(edges[k][1])});
  return status.ok() ? std::move(splittable).write_to(mesh) : status;
}

// Bisects the edges that join vertices between floor and ceiling across one of them. Then walls that are narrow enough
// are annuli.
template <typename GeomTraits>
Status split_rim_chords(Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  const Facet_adjacency surface = boundary_adjacency(mesh);
  const std::vector<int> labels = boundary_labels(mesh);
  std::vector<char> is_on_rim(mesh.number_of_vertices(), 0);
  for (Facet_index f : surface.facets())
    for (int i = 0; i < 3; ++i)
      if (is_border(surface, labels, {f, i})) is_on_rim[surface.source({f, i})] = 1;
  std::vector<std::array<std::uint32_t, 2>> chords;
  for (Facet_index f : surface.facets())
    for (int i = 0; i < 3; ++i) {
      const Vertex_index v = surface.source({f, i}), w = surface.target({f, i});
      if (v < w && is_on_rim[v] && is_on_rim[w] && !is_border(surface, labels, {f, i}))
        chords.push_back({v, w});
    }
  sort_longest_first(chords, [&](std::uint32_t v) { return approximate(mesh.point(v)); });
  return bisect_edges(mesh, chords);
}

/*
Partitions the boundary of a handlebody of genus n. The words of its edges tell which loops are primitive: part of a
basis of the homology of the solid. n such loops, disjoint and short, and one more curve are where the walls will be.
*/
template <typename GeomTraits>
class Loop_partitioner {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Id = Refined_surface::Id;
  using Path = std::vector<Id>;

  explicit Loop_partitioner(const Mesh& mesh) : m_mesh(mesh), m_approximate(approximate_surface(mesh)) {}

  Status certify() {
    Status status = m_approximate.adjacency.status();
    if (status.ok() && genus_of(m_approximate.adjacency) < 0)
      status = {ERROR_SEVERAL_COMPONENTS, "the boundary is not connected"};
    if (status.ok()) status = certify_handlebody(m_mesh, m_certificate);
    if (status.ok()) m_normals = averaged_normals(m_approximate, averaged_share);
    return status;
  }

  // Labels the boundary with the help of a unit vector.
  Status run(const Sweep_direction_3& direction, Mesh& result) const {
    Mesh halves = m_mesh;
    Status status = halve(direction, halves);
    if (status.ok()) status = split_rim_chords(halves);
    if (status.ok()) status = widen_walls(halves, result);
    return status.ok() ? validate_solid(result) : status;
  }

private:
  static constexpr double averaged_share = 1e-3; // of the area, over which normals are averaged
  static constexpr double horizontal_length = 6; // of an edge that does not rise; of a steep one 1

  Status halve(const Sweep_direction_3& direction, Mesh& halves) const {
    const Vertex_field averaged =
        direction.x() * m_normals[0] + direction.y() * m_normals[1] + direction.z() * m_normals[2];
    std::vector<double> rise(averaged.begin(), averaged.end());
    Refined_surface surface = refinable_boundary(m_mesh);
    std::vector<Path> loops;
    std::vector<std::array<Id, 2>> splits;
    Status status = find_loops(surface, rise, loops, splits);
    if (!status.ok()) return status;
    Surface_halver halver(surface, loops, direction, rise);
    status = halver.run();
    splits.insert(splits.end(), halver.splits().begin(), halver.splits().end());
    if (status.ok()) status = bisect_edges(halves, splits);
    if (status.ok()) label_halves(halver, halves);
    return status;
  }

  // Steep edges count as shorter. Each loop is cut on the surface, and chords are bisected, so that there is room for the
  // next one; `splits` receives them.
  Status find_loops(Refined_surface& surface, std::vector<double>& rise, std::vector<Path>& loops,
                    std::vector<std::array<Id, 2>>& splits) const {
    const auto length = [&](Id v, Id w) {
      return surface.length(v, w) * (1 + (horizontal_length - 1) * std::abs(rise[v] + rise[w]) / 2);
    };
    Edge_classes classes(m_certificate, m_mesh.number_of_vertices());
    Free_quotient quotient(m_certificate.genus());
    while (loops.size() < std::size_t(m_certificate.genus())) {
      Primitive_loop_search<decltype(length)> search(surface, classes, quotient, length);
      loops.push_back(search.run());
      if (loops.back().empty())
        return {ERROR_NO_PARTITION, "no primitive loop is disjoint from the " +
                                        std::to_string(loops.size() - 1) + " loops chosen before"};
      quotient.divide_by(search.loop_class());
      surface.cut(loops.back());
      for (const auto& [v, w] : surface.split_chords()) {
        splits.push_back({v, w});
        classes.add_midpoint(v);
        rise.push_back((rise[v] + rise[w]) / 2);
      }
    }
    return {};
  }

  // Boundary facets of a mesh are numbered in the order of their sorted vertices.
  static void label_halves(const Surface_halver& halver, Mesh& mesh) {
    std::vector<std::pair<Refined_surface::Triangle, int>> labelled;
    for (int label : {FLOOR, CEILING})
      for (Refined_surface::Triangle t : halver.triangles(label == CEILING)) {
        std::sort(t.begin(), t.end());
        labelled.push_back({t, label});
      }
    std::sort(labelled.begin(), labelled.end());
    for (Facet_index f : mesh.boundary_facets()) mesh.set_label(f, labelled[f].second);
  }

  // Takes the widest walls that are legal; the last ones tried have only vertices of the curves inside.
  static Status widen_walls(const Mesh& halves, Mesh& result) {
    const Approximate_surface surface = approximate_surface(halves);
    const Vertex_field height = relative_height(surface, boundary_labels(halves), UP_TO_RIDGES);
    double least = std::numeric_limits<double>::max();
    for (double h : height)
      if (h != 0) least = std::min(least, std::abs(h));
    Status status;
    const double broadest = Partition_options().wall_width;
    for (double width = broadest; width >= std::min(broadest, least / 2); width /= 2) {
      status = cut_walls(halves, height / width, result);
      if (status.ok()) return status;
    }
    return {ERROR_NO_PARTITION, "no walls are narrow enough: " + status.message()};
  }

  const Mesh& m_mesh;
  Approximate_surface m_approximate;
  Handlebody_certificate m_certificate;
  std::array<Vertex_field, 3> m_normals;
};

template <typename GeomTraits>
double share_of_smaller_base(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  const Boundary_partition_3 summary = summarize_partition(mesh);
  double area = 0;
  for (const Boundary_patch_3& patch : summary.patches) area += patch.area;
  return std::min(summary.find(FLOOR)->area, summary.find(CEILING)->area) / area;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationPartition

labels the boundary of a handlebody of genus `n` where no direction tells floor from ceiling: by `n` disjoint loops on
the boundary, short and steep, whose classes are part of a basis of the first homology group of the solid, and one more
curve that separates two trees which join their sides. Walls are cut around these curves. The result passes
`validate_partition()` and `validate_fundamental_group()`.

A direction takes \f$ O(n^2 N \log N) \f$ for \f$ N \f$ tetrahedra.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param mesh gets the labels; edges of its boundary get bisected, vertices that it had come first. On failure it is left
as it was
\param directions are tried one after the other until both bases have a tenth of the area; else the one with the
broadest bases is taken. A direction is only a guide: loops rather run where the surface is steep, and what faces it
rather joins the ceiling
\param direction if not null, receives the direction that was taken

\returns `ERROR_EMPTY_MESH`, `ERROR_OPEN_SURFACE`, `ERROR_NON_MANIFOLD`, `ERROR_SEVERAL_COMPONENTS`,
`ERROR_NOT_A_HANDLEBODY`; `ERROR_WRONG_PARAMETER` for a direction of no length; `ERROR_NO_PARTITION` if there is no
direction or all fail, with the reason for the last one
*/
template <typename GeomTraits>
Status partition_by_loops(Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                          const std::vector<Sweep_direction_3>& directions,
                          Sweep_direction_3* direction = nullptr) {
  constexpr double broad_share = .1; // of the area, that ends the search
  internal::Loop_partitioner<GeomTraits> partitioner(mesh);
  Status status = internal::check_directions(directions);
  if (status.ok()) status = partitioner.certify();
  if (!status.ok()) return status;
  Status refusal(ERROR_NO_PARTITION, "there are no directions");
  Compact_tetrahedral_mesh_3<GeomTraits> best;
  double best_share = 0;
  for (const Sweep_direction_3& d : directions) {
    Compact_tetrahedral_mesh_3<GeomTraits> result;
    status = partitioner.run(d / internal::length(d), result);
    if (!status.ok())
      refusal = {ERROR_NO_PARTITION,
                 status.code() == ERROR_NO_PARTITION ? status.detail() : status.message()};
    const double share = status.ok() ? internal::share_of_smaller_base(result) : 0;
    if (share <= best_share) continue;
    best_share = share;
    best = std::move(result);
    if (direction) *direction = d;
    if (share > broad_share) break;
  }
  if (best_share == 0) return refusal;
  mesh = std::move(best);
  return {};
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_BY_LOOPS_H
