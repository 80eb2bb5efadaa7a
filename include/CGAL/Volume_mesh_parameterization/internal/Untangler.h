// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_UNTANGLER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_UNTANGLER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Interior_mapper.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

tells what it took to find a map of tetrahedra without flips.
*/
struct Untangling_report {
  std::size_t flipped_at_start = 0; ///< flipped or flat tetrahedra of the first map of the interior
  std::size_t flipped_at_end = 0;   ///< those that resisted
  std::size_t rounds = 0;           ///< passes over the clusters of flipped tetrahedra
  std::size_t bisected_edges = 0;   ///< edges inside that were bisected where tetrahedra resisted
  std::size_t relaxed_clusters = 0; ///< clusters of badly distorted tetrahedra that were relaxed
  bool starts_along_curves = false; ///< whether the first map of the interior was that along curves, else the harmonic one
};

namespace internal {

/*
Untangles cluster by cluster: only the vertices in some rings of cells around flipped ones move. Where that does not help,
the edges of the flipped cells are bisected, which gives new freedom.
*/
template <typename GeomTraits, typename Visitor>
class Untangler {
public:
  using Mapper = Interior_mapper<GeomTraits>;
  using Cells = std::vector<Cell_index>;

  Untangler(Mapper& mapper, Visitor& visitor, Untangling_report& report)
      : m_mapper(mapper), m_visitor(visitor), m_report(report) {}

  // Ends when nothing is flipped, or when some rounds in a row have not lessened the number of flips, or when the mesh has
  // grown too much.
  Status run() {
    constexpr std::size_t most_idle_rounds = 4;
    constexpr double most_growth = 1.2;
    const double most_cells = most_growth * double(m_mapper.mesh().number_of_cells());
    Cells flipped = m_mapper.find_flipped();
    m_report.flipped_at_start = m_report.flipped_at_end = flipped.size();
    for (std::size_t idle = 0; !flipped.empty() && idle < most_idle_rounds;) {
      const std::size_t before = m_report.flipped_at_end;
      ++m_report.rounds;
      for (int rings : {2, 4}) {
        if (!untangle_clusters(flipped, rings)) return {ERROR_CANCELLED, "untangling"};
        flipped = m_mapper.find_flipped();
      }
      m_report.flipped_at_end = (std::min)(before, flipped.size());
      idle = flipped.size() < before ? 0 : idle + 1;
      if (flipped.empty() || double(m_mapper.mesh().number_of_cells()) > most_cells) break;
      refine(flipped);
      flipped = m_mapper.find_flipped();
    }
    m_report.flipped_at_end = flipped.size();
    if (flipped.empty()) return {};
    return {ERROR_MAP_NOT_BIJECTIVE,
            std::to_string(flipped.size()) + " tetrahedra resist, among them " + std::to_string(flipped[0])};
  }

  // Relaxes where the distortion is bad.
  Status polish() {
    constexpr double bad = 20; // energy of a cell; 3.2 without distortion
    constexpr int rings = 2, most_steps = 10;
    const std::vector<double> energies = m_mapper.energies();
    Cells worst;
    for (std::size_t c = 0; c < energies.size(); ++c)
      if (energies[c] > bad) worst.emplace_back(c);
    const std::vector<Cells> parts = clusters(worst);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (!m_visitor.advance(k, parts.size())) return {ERROR_CANCELLED, "relaxing"};
      m_mapper.polish(m_mapper.neighborhood(parts[k], rings), most_steps);
      ++m_report.relaxed_clusters;
    }
    return {};
  }

private:
  bool untangle_clusters(const Cells& flipped, int rings) {
    constexpr double small = 0.3, large = 1; // first epsilons
    constexpr int most_rounds = 20;
    const std::vector<Cells> parts = clusters(flipped);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (!m_visitor.advance(k, parts.size())) return false;
      if (m_mapper.count_flipped(parts[k]) == 0) continue; // with a neighbour
      const Cells cells = m_mapper.neighborhood(parts[k], rings);
      if (m_mapper.untangle(cells, small, most_rounds) > 0) m_mapper.untangle(cells, large, most_rounds);
    }
    return true;
  }

  // Cells that share vertices are in one cluster.
  std::vector<Cells> clusters(const Cells& flipped) const {
    std::vector<char> is_left(m_mapper.mesh().number_of_cells(), 0);
    for (Cell_index c : flipped) is_left[c] = 1;
    std::vector<Cells> result;
    for (Cell_index first : flipped) {
      if (!is_left[first]) continue;
      is_left[first] = 0;
      Cells cluster(1, first);
      for (std::size_t i = 0; i < cluster.size(); ++i)
        for (Vertex_index v : m_mapper.mesh().cell(cluster[i]))
          for (Cell_index c : m_mapper.mesh().star(v))
            if (is_left[c]) {
              is_left[c] = 0;
              cluster.push_back(c);
            }
      result.push_back(std::move(cluster));
    }
    return result;
  }

  // Bisects the edges of the cells that are not on the boundary, the longest first.
  void refine(const Cells& cells) {
    std::vector<std::array<Vertex_index, 2>> edges;
    for (Cell_index c : cells)
      for (const auto& e : Compact_tetrahedral_mesh_3<GeomTraits>::edge_vertices) {
        const auto& cell = m_mapper.mesh().cell(c);
        const Vertex_index a = (std::min)(cell[e[0]], cell[e[1]]), b = (std::max)(cell[e[0]], cell[e[1]]);
        if (!m_mapper.is_boundary_edge(a, b)) edges.push_back({a, b});
      }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    sort_longest_first(edges, [this](Vertex_index v) { return approximate(m_mapper.mesh().point(v)); });
    for (const auto& [a, b] : edges) m_report.bisected_edges += m_mapper.bisect(a, b).ok();
  }

  Mapper& m_mapper;
  Visitor& m_visitor;
  Untangling_report& m_report;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_UNTANGLER_H
