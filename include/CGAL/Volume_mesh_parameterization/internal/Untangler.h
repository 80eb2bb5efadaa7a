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
#include <CGAL/Volume_mesh_parameterization/internal/Ball_refiller.h>
#include <CGAL/Volume_mesh_parameterization/internal/Interior_mapper.h>
#include <CGAL/Volume_mesh_parameterization/internal/Star_shaped_ball.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {

/*
Untangles cluster by cluster: only the vertices in some rings of cells around flipped ones move. Where that does not help, a ball
around the cluster is filled anew; where there is none whose image is star-shaped, the edges of the flipped cells are bisected,
which gives new freedom.
*/
template <typename GeomTraits, typename Visitor>
class Untangler {
public:
  using Mapper = Interior_mapper<GeomTraits>;
  using Cells = std::vector<Cell_index>;
  using Edge = std::array<Vertex_index, 2>;

  Untangler(Mapper& mapper, Visitor& visitor, Untangling_report& report)
      : m_mapper(mapper), m_visitor(visitor), m_report(report) {}

  // Ends when nothing is flipped, or when all kinds of refinement have not lessened the number of flips, or when the mesh has
  // grown too much, or when the work is too much.
  Status run() {
    const std::size_t cells = m_mapper.mesh().number_of_cells(), vertices = m_mapper.images().size();
    set_bounds(double(cells));
    Cells flipped = m_mapper.find_flipped();
    m_report.flipped_at_start = flipped.size();
    m_report.rounds = 1;
    Status status = untangle(flipped);
    if (status.ok()) status = refine_and_untangle(flipped);
    m_report.flipped_at_end = flipped.size();
    m_report.split_simplices = m_mapper.images().size() - vertices;
    m_report.work = work() / double(cells);
    if (!status.ok() || flipped.empty()) return status;
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
  // Which edges of flipped cells are bisected: that of each that is longest, all, or those of the cells around as well.
  enum Refinement { LONGEST, ALL, AROUND };

  static constexpr std::size_t most_sliding = 8000; // cells of a part where sliding converges

  // Bounds on the number of Newton steps of cells: for each cell of a small mesh, for one of some size, for each cell of a
  // big one.
  static constexpr double most_steps_per_cell = 20000, enough = 5e7, enough_per_cell = 100;

  void set_bounds(double cells) {
    constexpr double most_growth = 1.5, most_added_anyway = 20000; // cells
    m_most_cells = (std::max)(most_growth * cells, cells + most_added_anyway);
    m_most_work = (std::min)(most_steps_per_cell * cells, (std::max)(enough, enough_per_cell * cells));
  }

  double work() const { return m_work_undone + m_mapper.work(); }
  bool is_too_much() const {
    return double(m_mapper.mesh().number_of_cells()) > m_most_cells || work() > m_most_work;
  }

  Status untangle(Cells& flipped) {
    Status status;
    for (int rings : {2, 4}) {
      if (status.ok()) status = untangle_clusters(flipped, rings);
      if (status.ok()) status = refill(m_mapper.find_flipped());
      flipped = m_mapper.find_flipped();
    }
    return status;
  }

  Status refill(const Cells& flipped) {
    constexpr std::size_t most_cells = 1000, least_bound = 200;
    Star_shaped_ball<GeomTraits> ball(m_mapper);
    const std::vector<Cells> parts = clusters(flipped);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (!m_visitor.advance(k, parts.size())) return {ERROR_CANCELLED, "untangling"};
      if (m_mapper.count_flipped(parts[k]) == 0) continue; // with a neighbour
      if (!ball.grow_around(parts[k], m_mapper.neighborhood(parts[k], 1), most_cells)) continue;
      const std::size_t most_added = least_bound + 2 * ball.cells().size();
      m_report.refilled_balls += Ball_refiller<GeomTraits>(m_mapper, ball, most_added).run();
    }
    return {};
  }

  // The number of flips often grows before it falls: after a few rounds without gain only, another refinement is tried, from the
  // state with the fewest.
  Status refine_and_untangle(Cells& flipped) {
    constexpr int most_idle_rounds = 4;
    Status status;
    Mapper best = m_mapper;
    Cells fewest = flipped;
    for (Refinement refinement : {LONGEST, ALL, AROUND}) {
      for (int idle = 0; idle < most_idle_rounds; ++idle) {
        if (!status.ok() || fewest.empty() || is_too_much()) break;
        ++m_report.rounds;
        const std::vector<Cells> stuck = clusters(flipped);
        refine(flipped, idle == 0 ? refinement : LONGEST);
        if (idle > 0) relax(stuck);
        flipped = m_mapper.find_flipped();
        status = untangle(flipped);
        if (flipped.size() >= fewest.size()) continue;
        fewest = flipped;
        best = m_mapper;
        idle = -1; // what has helped is tried again
      }
      set_back(best);
      flipped = fewest;
    }
    return status;
  }

  // Away from where it is stuck: the boundary may have been squeezed as it slid, or cells around the flipped ones.
  void relax(const std::vector<Cells>& parts) {
    constexpr int rings = 4;
    for (const Cells& part : parts) {
      const Cells cells = m_mapper.neighborhood(part, rings);
      if (cells.size() <= most_sliding) m_mapper.relax(cells);
    }
  }

  void set_back(const Mapper& state) {
    m_work_undone += m_mapper.work() - state.work();
    m_mapper = state;
  }

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

  Status untangle_clusters(const Cells& flipped, int rings) {
    const std::vector<Cells> parts = clusters(flipped);
    for (std::size_t k = 0; k < parts.size() && work() <= m_most_work; ++k) {
      if (!m_visitor.advance(k, parts.size())) return {ERROR_CANCELLED, "untangling"};
      if (m_mapper.count_flipped(parts[k]) == 0) continue; // with a neighbour
      untangle_part(m_mapper.neighborhood(parts[k], rings));
    }
    return {};
  }

  // The boundary slides if need be only, as that may squeeze it, and in parts where that converges.
  void untangle_part(const Cells& cells) {
    using Part = typename Mapper::Part;
    if (m_mapper.untangle(cells, Mapper::AS_IT_IS, Part::HELD) == 0) return;
    if (m_mapper.untangle(cells, Mapper::SMOOTHED, Part::HELD) == 0) return;
    if (m_mapper.may_slide() && cells.size() <= most_sliding)
      m_mapper.untangle(cells, Mapper::AS_IT_IS, Part::SLIDING);
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

  // Bisects edges inside that join boundary vertices around the flipped cells, which leave no room; if there are none, edges of
  // the flipped cells.
  void refine(const Cells& flipped, Refinement refinement) {
    constexpr int rings = 2;
    const auto is_inside = [this](Vertex_index a, Vertex_index b) {
      return !m_mapper.is_boundary_edge(a, b);
    };
    const auto is_chord = [&](Vertex_index a, Vertex_index b) {
      return !m_mapper.is_inside(a) && !m_mapper.is_inside(b) && is_inside(a, b);
    };
    if (bisect(edges_of(m_mapper.neighborhood(flipped, rings), is_chord))) return;
    const Cells cells = refinement == AROUND ? m_mapper.neighborhood(flipped, 1) : flipped;
    bisect(refinement == LONGEST ? longest_edges_of(cells, is_inside) : edges_of(cells, is_inside));
  }

  // Returns whether any could be bisected.
  bool bisect(const std::vector<Edge>& edges) {
    bool has_bisected = false;
    for (const auto& [a, b] : edges) has_bisected |= m_mapper.bisect(a, b).ok();
    return has_bisected;
  }

  // One of each cell at most.
  template <typename Predicate>
  std::vector<Edge> longest_edges_of(const Cells& cells, const Predicate& is_wanted) const {
    std::vector<Edge> longest;
    for (Cell_index c : cells) {
      const std::vector<Edge> edges = edges_of(Cells(1, c), is_wanted);
      if (!edges.empty()) longest.push_back(edges[0]);
    }
    std::sort(longest.begin(), longest.end());
    longest.erase(std::unique(longest.begin(), longest.end()), longest.end());
    return longest;
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
  double m_most_cells = 0, m_most_work = 0, m_work_undone = 0;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_UNTANGLER_H
