// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_UNTANGLER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_UNTANGLER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Untangling_report.h>
#include <CGAL/Volume_mesh_parameterization/internal/Interior_mapper.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

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
  using Edge = std::array<Vertex_index, 2>;

  Untangler(Mapper& mapper, Visitor& visitor, Untangling_report& report)
      : m_mapper(mapper), m_visitor(visitor), m_report(report) {}

  // Ends when nothing is flipped, or when some rounds in a row have not lessened the number of flips, or when the mesh has
  // grown too much, or when the work is too much.
  Status run() {
    constexpr std::size_t most_idle_rounds = 4;
    constexpr double most_growth = 1.2, most_added_anyway = 10000; // cells
    const double cells = double(m_mapper.mesh().number_of_cells());
    const double most_cells = (std::max)(most_growth * cells, cells + most_added_anyway);
    const double most_work =
        (std::min)(most_steps_per_cell * cells, (std::max)(enough, enough_per_cell * cells));
    Cells flipped = m_mapper.find_flipped();
    m_report.flipped_at_start = m_report.flipped_at_end = flipped.size();
    for (std::size_t idle = 0; !flipped.empty() && idle < most_idle_rounds;) {
      const std::size_t before = m_report.flipped_at_end;
      ++m_report.rounds;
      for (int rings : {2, 4}) {
        const Status status = untangle_clusters(flipped, rings, most_work);
        if (!status.ok()) return status;
        flipped = m_mapper.find_flipped();
      }
      m_report.flipped_at_end = (std::min)(before, flipped.size());
      idle = flipped.size() < before ? 0 : idle + 1;
      if (flipped.empty() || double(m_mapper.mesh().number_of_cells()) > most_cells ||
          m_mapper.work() > most_work)
        break;
      refine(flipped);
      flipped = m_mapper.find_flipped();
    }
    m_report.flipped_at_end = flipped.size();
    m_report.work = m_mapper.work() / cells;
    if (flipped.empty()) return {};
    return {ERROR_MAP_NOT_BIJECTIVE,
            std::to_string(flipped.size()) + " tetrahedra resist, among them " + std::to_string(flipped[0])};
  }

  // Relaxes where the distortion is bad, a few times.
  Status polish() {
    constexpr int most_rounds = 4;
    Status status;
    for (int round = 0; round < most_rounds && status.ok(); ++round) status = polish(worst_cells());
    return status;
  }

private:
  // Bounds on the number of Newton steps of cells: for each cell of a small mesh, for one of some size, for each cell of a big one.
  static constexpr double most_steps_per_cell = 5000, enough = 4e7, enough_per_cell = 100;

  Cells worst_cells() const {
    constexpr double bad = 20; // energy of a cell; 3.2 without distortion
    const std::vector<double> energies = m_mapper.energies();
    Cells worst;
    for (std::size_t c = 0; c < energies.size(); ++c)
      if (energies[c] > bad) worst.emplace_back(c);
    return worst;
  }

  Status polish(const Cells& worst) {
    constexpr int rings = 2, most_steps = 10;
    const std::vector<Cells> parts = clusters(worst);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (!m_visitor.advance(k, parts.size())) return {ERROR_CANCELLED, "relaxing"};
      m_mapper.polish(m_mapper.neighborhood(parts[k], rings), most_steps);
      ++m_report.relaxed_clusters;
    }
    return {};
  }

  Status untangle_clusters(const Cells& flipped, int rings, double most) {
    const std::vector<Cells> parts = clusters(flipped);
    for (std::size_t k = 0; k < parts.size() && m_mapper.work() <= most; ++k) {
      if (!m_visitor.advance(k, parts.size())) return {ERROR_CANCELLED, "untangling"};
      if (m_mapper.count_flipped(parts[k]) == 0) continue; // with a neighbour
      untangle(m_mapper.neighborhood(parts[k], rings));
    }
    return {};
  }

  // The boundary slides if need be only, as that may squeeze it.
  void untangle(const Cells& cells) {
    using Part = typename Mapper::Part;
    if (m_mapper.untangle(cells, Mapper::AS_IT_IS, Part::HELD) == 0) return;
    if (m_mapper.untangle(cells, Mapper::SMOOTHED, Part::HELD) == 0) return;
    if (m_mapper.may_slide()) m_mapper.untangle(cells, Mapper::AS_IT_IS, Part::SLIDING);
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

  // Bisects edges inside that join boundary vertices around the flipped cells, or if there are none, all edges inside of the
  // flipped ones: those are what leaves no room.
  void refine(const Cells& flipped) {
    constexpr int rings = 2;
    const auto is_inside = [this](Vertex_index a, Vertex_index b) {
      return !m_mapper.is_boundary_edge(a, b);
    };
    const auto is_chord = [&](Vertex_index a, Vertex_index b) {
      return !m_mapper.is_inside(a) && !m_mapper.is_inside(b) && is_inside(a, b);
    };
    if (bisect(edges_of(m_mapper.neighborhood(flipped, rings), is_chord)) == 0)
      bisect(edges_of(flipped, is_inside));
  }

  // Returns how many could be bisected.
  std::size_t bisect(const std::vector<Edge>& edges) {
    std::size_t bisected = 0;
    for (const auto& [a, b] : edges) bisected += m_mapper.bisect(a, b).ok();
    m_report.bisected_edges += bisected;
    return bisected;
  }

  // The longest first.
  template <typename Predicate>
  std::vector<Edge> edges_of(const Cells& cells, const Predicate& is_wanted) const {
    std::vector<Edge> edges;
    for (Cell_index c : cells)
      for (const auto& e : Compact_tetrahedral_mesh_3<GeomTraits>::edge_vertices) {
        const auto& cell = m_mapper.mesh().cell(c);
        const Vertex_index a = (std::min)(cell[e[0]], cell[e[1]]), b = (std::max)(cell[e[0]], cell[e[1]]);
        if (is_wanted(a, b)) edges.push_back({a, b});
      }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    sort_longest_first(edges, [this](Vertex_index v) { return approximate(m_mapper.mesh().point(v)); });
    return edges;
  }

  Mapper& m_mapper;
  Visitor& m_visitor;
  Untangling_report& m_report;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_UNTANGLER_H
