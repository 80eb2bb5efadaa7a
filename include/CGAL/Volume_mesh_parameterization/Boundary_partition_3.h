// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_PARTITION_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_PARTITION_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Facet_adjacency.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationPartition

returns how people call the patch with this label: "floor", "ceiling", "wall 2".
*/
inline std::string patch_name(int label) {
  if (label == FLOOR) return "floor";
  if (label == CEILING) return "ceiling";
  if (label >= FIRST_WALL) return "wall " + std::to_string(label - FIRST_WALL);
  return label == INTERIOR ? "no label" : "label " + std::to_string(label);
}

/*!
\ingroup PkgVolumeMeshParameterizationPartition

counts what belongs to one label.
*/
struct Boundary_patch_3 {
  int label = INTERIOR;                   ///< 1 floor, 2 ceiling, 3 + k wall k
  std::size_t number_of_facets = 0;       ///< how many triangles it has
  double area = 0;                        ///< its area
  long euler_number = 0;                  ///< vertices - edges + facets
  std::size_t number_of_border_loops = 0; ///< connected parts of the border
  std::size_t number_of_components = 0;   ///< parts that are connected through edges

  /// returns its name, see `patch_name()`.
  std::string name() const { return patch_name(label); }
};

/*!
\ingroup PkgVolumeMeshParameterizationPartition

summarizes the labels of the boundary of a solid, legal or not.
*/
struct Boundary_partition_3 {
  int genus = -1;                        ///< of the boundary; -1 if it is not closed and connected
  std::vector<Boundary_patch_3> patches; ///< in the order of their labels, those without facets left out

  /// returns the patch with this label, `nullptr` if there is none.
  const Boundary_patch_3* find(int label) const {
    for (const Boundary_patch_3& patch : patches)
      if (patch.label == label) return &patch;
    return nullptr;
  }
};

namespace internal {

// A border side of a facet separates it from another label.
inline bool is_border(const Facet_adjacency& surface, const std::vector<int>& labels,
                      Facet_adjacency::Side s) {
  return labels[s.facet] != labels[surface.opposite(s).facet];
}

// Counts of each patch of a closed surface. Vertices are counted as often as patches meet there.
class Patch_counter {
public:
  Patch_counter(const Facet_adjacency& surface, const std::vector<int>& labels,
                const std::vector<double>& areas)
      : m_surface(surface), m_labels(labels), m_distinct(labels) {
    std::sort(m_distinct.begin(), m_distinct.end());
    m_distinct.erase(std::unique(m_distinct.begin(), m_distinct.end()), m_distinct.end());
    for (int label : m_distinct) {
      m_patches.emplace_back();
      m_patches.back().label = label;
    }
    for (Facet_index f : surface.facets()) {
      ++patch(f).number_of_facets;
      patch(f).area += areas[f];
    }
    count_components();
    count_simplices();
    count_loops();
  }

  const std::vector<Boundary_patch_3>& patches() const { return m_patches; }

private:
  Boundary_patch_3& patch(Facet_index f) {
    return m_patches[std::lower_bound(m_distinct.begin(), m_distinct.end(), m_labels[f]) -
                     m_distinct.begin()];
  }

  void count_components() {
    const Facet_components parts(m_surface,
                                 [&](Facet_index f, Facet_index g) { return m_labels[f] == m_labels[g]; });
    std::vector<char> counted(parts.size(), 0);
    for (Facet_index f : m_surface.facets()) {
      if (!counted[parts[f]]) ++patch(f).number_of_components;
      counted[parts[f]] = 1;
    }
  }

  void count_simplices() {
    std::vector<int> here;
    for (std::size_t v = 0; v < m_surface.number_of_vertices(); ++v) {
      here.clear();
      for (Facet_index f : m_surface.star(Vertex_index(v))) {
        if (std::find(here.begin(), here.end(), m_labels[f]) != here.end()) continue;
        here.push_back(m_labels[f]);
        ++patch(f).euler_number;
      }
    }
    for (Facet_index f : m_surface.facets()) {
      ++patch(f).euler_number;
      for (int i = 0; i < 3; ++i)
        if (is_border(m_surface, m_labels, {f, i}) || f < m_surface.neighbor(f, i)) --patch(f).euler_number;
    }
  }

  // Border sides of one patch that share a vertex belong together.
  void count_loops() {
    std::vector<std::vector<Facet_adjacency::Side>> borders(m_patches.size());
    for (Facet_index f : m_surface.facets())
      for (int i = 0; i < 3; ++i)
        if (is_border(m_surface, m_labels, {f, i})) borders[&patch(f) - m_patches.data()].push_back({f, i});
    std::vector<std::uint32_t> first_at(m_surface.number_of_vertices(), none);
    for (std::size_t p = 0; p < m_patches.size(); ++p)
      m_patches[p].number_of_border_loops = number_of_loops(borders[p], first_at);
  }

  // `first_at` is `none` everywhere, before and after.
  std::size_t number_of_loops(const std::vector<Facet_adjacency::Side>& border,
                              std::vector<std::uint32_t>& first_at) const {
    Disjoint_sets loops(border.size());
    for (std::uint32_t k = 0; k < border.size(); ++k)
      for (Vertex_index v : {m_surface.source(border[k]), m_surface.target(border[k])}) {
        if (first_at[v] == none) first_at[v] = k;
        loops.join(k, first_at[v]);
      }
    for (const Facet_adjacency::Side& s : border)
      first_at[m_surface.source(s)] = first_at[m_surface.target(s)] = none;
    return loops.number_of_sets();
  }

  static constexpr std::uint32_t none = std::uint32_t(-1);
  const Facet_adjacency& m_surface;
  const std::vector<int>& m_labels;
  std::vector<int> m_distinct;
  std::vector<Boundary_patch_3> m_patches;
};

// The number of handles of a closed surface, -1 if it is not connected.
inline int genus_of(const Facet_adjacency& surface) {
  const Facet_components parts(surface, [](Facet_index, Facet_index) { return true; });
  return parts.size() == 1 ? int((2 - surface.euler_number()) / 2) : -1;
}

inline Boundary_partition_3 summarize(const Facet_adjacency& surface, const std::vector<int>& labels,
                                      const std::vector<double>& areas) {
  if (!surface.status().ok()) return {};
  return {genus_of(surface), Patch_counter(surface, labels, areas).patches()};
}

template <typename Points>
std::vector<double> facet_areas(const Facet_adjacency& surface, const Points& points) {
  std::vector<double> areas;
  areas.reserve(surface.number_of_facets());
  for (Facet_index f : surface.facets()) {
    const auto& t = surface.triangle(f);
    const auto p = approximate(points[t[0]]), q = approximate(points[t[1]]), r = approximate(points[t[2]]);
    areas.push_back(std::sqrt(CGAL::squared_area(p, q, r)));
  }
  return areas;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationPartition

summarizes the labels that are stored in `mesh`, in \f$ O(n \log n) \f$.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
Boundary_partition_3 summarize_partition(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  const internal::Facet_adjacency surface = internal::boundary_adjacency(mesh);
  return internal::summarize(surface, internal::boundary_labels(mesh),
                             internal::facet_areas(surface, mesh.points()));
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_PARTITION_3_H
