// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_VALIDATE_PARTITION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_VALIDATE_PARTITION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/internal/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Facet_adjacency.h>
#include <CGAL/Volume_mesh_parameterization/internal/Stallings_graph.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The conditions of a legal partition, one function for each, in the order in which they may rely on each other.
class Partition_validator {
public:
  Partition_validator(const Facet_adjacency& surface, const std::vector<int>& labels,
                      const Boundary_partition_3& summary)
      : m_surface(surface), m_labels(labels), m_summary(summary) {}

  Status validate() const {
    Status status = m_surface.status();
    if (status.ok()) status = check_connected();
    if (status.ok()) status = check_labels();
    if (status.ok()) status = check_patches_connected();
    if (status.ok()) status = check_no_pinch();
    if (status.ok()) status = check_contacts();
    if (status.ok()) status = check_topology();
    if (status.ok()) status = check_wall_rims();
    return status;
  }

private:
  using Side = Facet_adjacency::Side;

  static std::string at(Vertex_index v) { return " at vertex " + std::to_string(v); }

  Status check_connected() const {
    if (m_summary.genus >= 0) return {};
    return {ERROR_SEVERAL_COMPONENTS, "the boundary is not connected"};
  }

  Status check_labels() const {
    const int last = FIRST_WALL + m_summary.genus;
    for (Facet_index f : m_surface.facets())
      if (m_labels[f] == INTERIOR) return {ERROR_UNLABELLED_FACET, "facet " + std::to_string(f)};
    for (Facet_index f : m_surface.facets())
      if (m_labels[f] < FLOOR || m_labels[f] > last)
        return {ERROR_NUMBER_OF_PATCHES, "facet " + std::to_string(f) + " has label " +
                                             std::to_string(m_labels[f]) + ", but the boundary has genus " +
                                             std::to_string(m_summary.genus)};
    for (int label = FLOOR; label <= last; ++label)
      if (!m_summary.find(label)) return {ERROR_NUMBER_OF_PATCHES, "there is no " + patch_name(label)};
    return {};
  }

  Status check_patches_connected() const {
    const Facet_components parts(m_surface,
                                 [&](Facet_index f, Facet_index g) { return m_labels[f] == m_labels[g]; });
    std::vector<std::size_t> part_of(m_summary.patches.back().label + 1, std::size_t(-1));
    for (Facet_index f : m_surface.facets()) {
      std::size_t& part = part_of[m_labels[f]];
      if (part == std::size_t(-1)) part = parts[f];
      if (part != parts[f])
        return {ERROR_PATCH_NOT_CONNECTED,
                patch_name(m_labels[f]) + ", of which facet " + std::to_string(f) + " is apart"};
    }
    return {};
  }

  // On a closed surface the labels change as often around a vertex as there are fans of one label.
  Status check_no_pinch() const {
    std::vector<int> fans;
    for (std::size_t v = 0; v < m_surface.number_of_vertices(); ++v) {
      fans.clear();
      for (Facet_index f : m_surface.star(Vertex_index(v))) {
        if (m_labels[f] == m_labels[next_around(f, Vertex_index(v))]) continue;
        if (std::find(fans.begin(), fans.end(), m_labels[f]) != fans.end())
          return {ERROR_PATCH_NOT_A_SURFACE, patch_name(m_labels[f]) + at(Vertex_index(v))};
        fans.push_back(m_labels[f]);
      }
    }
    return {};
  }

  Facet_index next_around(Facet_index f, Vertex_index v) const {
    const auto& t = m_surface.triangle(f);
    const int i = int(std::find(t.begin(), t.end(), v) - t.begin());
    return m_surface.neighbor(f, (i + 1) % 3);
  }

  Status check_contacts() const {
    Status walls;
    for (std::size_t v = 0; v < m_surface.number_of_vertices(); ++v) {
      int wall = INTERIOR;
      bool floor = false, ceiling = false;
      for (Facet_index f : m_surface.star(Vertex_index(v))) {
        const int label = m_labels[f];
        floor |= label == FLOOR;
        ceiling |= label == CEILING;
        if (label < FIRST_WALL) continue;
        if (wall != INTERIOR && wall != label && walls.ok())
          walls = {ERROR_WALLS_MEET, patch_name(wall) + " and " + patch_name(label) + at(Vertex_index(v))};
        wall = label;
      }
      if (floor && ceiling) return {ERROR_FLOOR_MEETS_CEILING, "vertex " + std::to_string(v)};
    }
    return walls;
  }

  Status check_topology() const {
    for (const Boundary_patch_3& patch : m_summary.patches) {
      const bool is_wall = patch.label >= FIRST_WALL;
      const long euler_number = is_wall ? 0 : 1 - m_summary.genus;
      const std::size_t loops = is_wall ? 2 : m_summary.genus + 1;
      if (patch.euler_number != euler_number || patch.number_of_border_loops != loops)
        return {ERROR_PATCH_TOPOLOGY,
                patch.name() + " has Euler number " + std::to_string(patch.euler_number) + " and " +
                    std::to_string(patch.number_of_border_loops) + " border loops, not " +
                    std::to_string(euler_number) + " and " + std::to_string(loops)};
    }
    return {};
  }

  // A wall has two border loops by now, and a loop meets one patch only, for floor and ceiling share no vertex.
  Status check_wall_rims() const {
    std::vector<std::array<bool, 2>> meets(m_summary.genus + 1, {false, false});
    for (Facet_index f : m_surface.facets())
      for (int i = 0; i < 3; ++i) {
        const int base = m_labels[m_surface.neighbor(f, i)];
        if (m_labels[f] >= FIRST_WALL && base < FIRST_WALL)
          meets[m_labels[f] - FIRST_WALL][base - FLOOR] = true;
      }
    for (std::size_t k = 0; k < meets.size(); ++k)
      for (int base : {FLOOR, CEILING})
        if (!meets[k][base - FLOOR])
          return {ERROR_WALL_RIMS,
                  patch_name(FIRST_WALL + int(k)) + " does not meet the " + patch_name(base)};
    return {};
  }

  const Facet_adjacency& m_surface;
  const std::vector<int>& m_labels;
  const Boundary_partition_3& m_summary;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationPartition

checks whether the labels of `mesh` can be those of a product of a disk with holes and an interval.

These conditions are checked, in this order, in \f$ O(n \log n) \f$:
- there is a boundary (`ERROR_EMPTY_MESH`), closed, oriented and manifold (`ERROR_OPEN_SURFACE`, `ERROR_NON_MANIFOLD`)
  and connected (`ERROR_SEVERAL_COMPONENTS`); let `n` be its genus;
- every facet is labelled (`ERROR_UNLABELLED_FACET`), and the labels are 1, ..., 3 + n (`ERROR_NUMBER_OF_PATCHES`);
- every patch is connected through edges (`ERROR_PATCH_NOT_CONNECTED`) and does not touch itself at a vertex
  (`ERROR_PATCH_NOT_A_SURFACE`);
- floor and ceiling share no vertex (`ERROR_FLOOR_MEETS_CEILING`), nor do two walls (`ERROR_WALLS_MEET`);
- floor and ceiling have Euler number 1 - n and n + 1 border loops, a wall has 0 and 2 (`ERROR_PATCH_TOPOLOGY`);
- each wall meets the floor in one loop and the ceiling in one (`ERROR_WALL_RIMS`).

For `n > 0` they are necessary, not sufficient: see `validate_fundamental_group()`.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param mesh the mesh with its labels
\param summary gets the counts that were checked, as far as they make sense

\returns the error of the first condition that does not hold, with the patch or the vertex at fault
*/
template <typename GeomTraits>
Status validate_partition(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh, Boundary_partition_3& summary) {
  const internal::Facet_adjacency surface = internal::boundary_adjacency(mesh);
  const std::vector<int> labels = internal::boundary_labels(mesh);
  summary = internal::summarize(surface, labels, internal::facet_areas(surface, mesh.points()));
  return internal::Partition_validator(surface, labels, summary).validate();
}

namespace internal {

// Edges of a patch, given by its vertices; an edge inside the patch may come twice.
using Patch_edges = std::vector<std::array<Vertex_index, 2>>;

/*
Whether the loops of a patch generate the fundamental group of the solid. Vertices of the patch that are none of the solid
are `moved_to` one, along a homotopy that maps edges to edges or vertices. Edges that are trivial in the group are
contracted, the others folded.
*/
inline bool carries_fundamental_group(const Handlebody_certificate& certificate, const Patch_edges& edges,
                                      const std::vector<Vertex_index>& moved_to) {
  Disjoint_sets sets(moved_to.size());
  Patch_edges nontrivial;
  const auto word = [&](Vertex_index v, Vertex_index w) {
    return certificate.word(certificate.edges().find(moved_to[v], moved_to[w]));
  };
  for (auto [v, w] : edges) {
    if (moved_to[w] < moved_to[v]) std::swap(v, w);
    if (moved_to[v] == moved_to[w] || word(v, w).empty())
      sets.join(v, w);
    else
      nontrivial.push_back({v, w});
  }
  std::sort(nontrivial.begin(), nontrivial.end());
  nontrivial.erase(std::unique(nontrivial.begin(), nontrivial.end()), nontrivial.end());
  Stallings_graph graph(certificate.genus());
  std::vector<Stallings_graph::Node> node_of(moved_to.size(), Stallings_graph::none);
  const auto node = [&](Vertex_index v) -> Stallings_graph::Node {
    Stallings_graph::Node& result = node_of[sets.representative(v)];
    if (result == Stallings_graph::none) result = graph.add_node();
    return result;
  };
  for (const auto& [v, w] : nontrivial) graph.add_path(node(v), word(v, w), node(w));
  return graph.is_whole_group();
}

// triangle(f) are the vertices of the facet with the label labels[f].
template <typename Triangle>
Status check_bases_carry_group(const Handlebody_certificate& certificate, const std::vector<int>& labels,
                               const Triangle& triangle, const std::vector<Vertex_index>& moved_to) {
  for (int label : {FLOOR, CEILING}) {
    Patch_edges edges;
    for (std::size_t f = 0; f < labels.size(); ++f) {
      if (labels[f] != label) continue;
      const auto t = triangle(f);
      for (int i = 0; i < 3; ++i) edges.push_back({Vertex_index(t[i]), Vertex_index(t[(i + 1) % 3])});
    }
    if (!carries_fundamental_group(certificate, edges, moved_to))
      return {ERROR_FLOOR_NOT_ONTO, "some loop of the solid cannot be pushed into the " + patch_name(label)};
  }
  return {};
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationPartition

checks whether every loop of the solid can be pushed into the floor, and into the ceiling: whether the fundamental
groups of both map onto that of the solid. With the conditions of `validate_partition()` the solid is then the product
of its floor and an interval: the floor's group is free of the same rank, so that a map onto is one to one (finitely
generated free groups are Hopfian), and a theorem of E. M. Brown applies (J. Hempel, 3-Manifolds, theorem 10.2).

The generators are folded as in J. R. Stallings, Topology of finite graphs, Invent. Math. 71 (1983).

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param mesh a mesh whose partition passed `validate_partition()`
\param certificate of the same mesh
\returns `ERROR_FLOOR_NOT_ONTO`; the detail names floor or ceiling
*/
template <typename GeomTraits>
Status validate_fundamental_group(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                                  const Handlebody_certificate& certificate) {
  const std::vector<Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end());
  const auto triangle = [&](std::size_t f) { return mesh.vertices(Facet_index(f)); };
  return internal::check_bases_carry_group(certificate, internal::boundary_labels(mesh), triangle, vertices);
}

/*!
\ingroup PkgVolumeMeshParameterizationPartition

checks all conditions on a partition at once: those of `validate_partition()`, `certify_handlebody()` and
`validate_fundamental_group()`, which fill `summary` and `certificate`.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\returns the errors of these functions
*/
template <typename GeomTraits>
Status validate_solid(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh, Boundary_partition_3& summary,
                      Handlebody_certificate& certificate) {
  Status status = validate_partition(mesh, summary);
  if (status.ok()) status = certify_handlebody(mesh, certificate);
  return status.ok() ? validate_fundamental_group(mesh, certificate) : status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_VALIDATE_PARTITION_H
