// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CIRCULATION_RELAXATION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CIRCULATION_RELAXATION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Lessens the energy of a flux without sources edge by edge: a flux that turns around an edge changes no sum of a cell, and the
// one of least energy there has no circulation along the link of the edge. These turning fluxes are the curls of the edge
// elements of Nédélec, so in the end the flux would be that of least energy, which `Flux_field_3::solve()` computes; what
// is rough on the scale of the cells is gone after few rounds (Hiptmair 1998). Around edges of floor and ceiling the flux
// turns out of one facet into the other; walls, through which nothing passes, are left alone.
template <typename Mesh>
class Circulation_relaxation {
public:
  // Finds the links of the edges. Blocks are large, so that few links leave them if cells that are near each other have numbers
  // near each other.
  template <typename ConcurrencyTag>
  Circulation_relaxation(const Mesh& mesh, ConcurrencyTag, std::size_t cells_per_block = 1 << 16)
      : m_mesh(&mesh), m_cell_blocks(mesh.number_of_cells(), cells_per_block), m_blocks(m_cell_blocks.size()) {
    for_each_index<ConcurrencyTag>(m_blocks.size(), [this](std::size_t b) { find_links(b); }, 1);
  }

  // Relaxes fluxes, given out of the cell of half_facet(f) for each facet f; may be called once. The result does not depend on the
  // number of threads.
  template <typename ConcurrencyTag>
  void run(int rounds, std::vector<double>& fluxes) {
    m_points.reserve(m_mesh->number_of_vertices());
    for (const auto& p : m_mesh->points()) m_points.push_back(approximate(p));
    m_cells.resize(m_mesh->number_of_cells());
    constexpr std::size_t cells_per_task = 4096;
    const auto set_cell = [&](std::size_t c) { m_cells[c] = cell(Cell_index(c), fluxes); };
    for_each_index<ConcurrencyTag>(m_cells.size(), set_cell, cells_per_task);
    for (int round = 0; round < rounds; ++round)
      for_each_link<ConcurrencyTag>([&](const Link& link) { *link.turning_flux += relax(link); });
    for_each_link<ConcurrencyTag>([&](const Link& link) { add_to_fluxes(link, fluxes); });
  }

private:
  using Vector = Double_kernel::Vector_3;
  using Point = Double_kernel::Point_3;

  struct Cell {
    Vector vector; // the flux in the cell
    double weight; // the inverse of three times the volume: a flux of a around an edge is weight * a * d where the link goes by d
  };

  // A cell at an edge, with the part of the link of the edge that lies in it: from one vertex to another.
  struct Link_edge {
    Cell_index cell;
    std::uint8_t from, to;
  };

  // The links that were found from cells with numbers in a row.
  struct Block {
    std::vector<Link_edge> edges;       // one link after the other
    std::vector<std::uint32_t> ends;    // where they end
    std::vector<char> stay;             // whether they go through no cells of other blocks
    std::vector<double> turning_fluxes; // around the edges of the mesh whose links they are
  };

  struct Link {
    const Link_edge *begin, *end;
    double* turning_flux;
  };

  Cell cell(Cell_index c, const std::vector<double>& fluxes) const {
    const double weight = 1 / (3 * Cell_gradients(*m_mesh, c).volume);
    Vector sum = NULL_VECTOR;
    for (int i = 0; i < 4; ++i) {
      const Facet_index f = m_mesh->facet(c, i);
      const double outflow = is_first(f, c) ? fluxes[f] : -fluxes[f];
      sum -= outflow * (m_points[m_mesh->vertex(c, i)] - CGAL::ORIGIN);
    }
    return {weight * sum, weight};
  }

  bool is_first(Facet_index f, Cell_index c) const { return m_mesh->half_facet(f).cell == c; }

  void find_links(std::size_t b) {
    const auto cells = m_cell_blocks[b];
    std::vector<std::uint8_t> found(cells.size(), 0); // a bit for each edge of the cell
    m_blocks[b].edges.reserve(6 * found.size());
    for (std::size_t c : cells)
      for (std::uint8_t i = 0; i < 4; ++i)
        for (std::uint8_t j = i + 1; j < 4; ++j)
          if (const Link_edge e{Cell_index(c), i, j}; !(found[c - *cells.begin()] & bit(e))) add_link(e, b, found);
    m_blocks[b].edges.shrink_to_fit();
    m_blocks[b].turning_fluxes.assign(m_blocks[b].ends.size(), 0);
  }

  static unsigned bit(const Link_edge& e) {
    const int i = (std::min)(e.from, e.to), j = (std::max)(e.from, e.to);
    return 1u << (i == 0 ? j - 1 : i + j);
  }

  // Adds the link that `e` is a part of, a loop, or a path with both ends on floor or ceiling, if it goes through no cell of an
  // earlier block.
  void add_link(Link_edge e, std::size_t b, std::vector<std::uint8_t>& found) {
    Block& block = m_blocks[b];
    const Cell_index start = e.cell;
    while (go_back(e) && e.cell != start) continue;
    const Cell_index first = e.cell;
    const int first_facet = e.to;
    std::size_t first_block = b, last_block = b;
    do {
      const std::size_t here = m_cell_blocks.block_of(e.cell);
      if (here == b) found[e.cell - *m_cell_blocks[b].begin()] |= std::uint8_t(bit(e));
      first_block = (std::min)(first_block, here);
      last_block = (std::max)(last_block, here);
      block.edges.push_back(e);
    } while (go_on(e) && e.cell != first);
    if (first_block == b && is_passed(first, first_facet) && is_passed(e.cell, e.from)) {
      block.ends.push_back(std::uint32_t(block.edges.size()));
      block.stay.push_back(last_block == b);
    } else
      block.edges.resize(block.ends.empty() ? 0 : block.ends.back());
  }

  bool is_passed(Cell_index c, int facet) const {
    const int label = m_mesh->label(c, facet);
    return m_mesh->neighbor(c, facet).is_valid() || label == FLOOR || label == CEILING;
  }

  bool go_on(Link_edge& e) const {
    const Half_facet h = m_mesh->opposite({e.cell, e.from});
    if (!h.cell.is_valid()) return false;
    e = {h.cell, std::uint8_t(m_mesh->index(h.cell, m_mesh->vertex(e.cell, e.to))), std::uint8_t(h.index)};
    return true;
  }

  bool go_back(Link_edge& e) const {
    const Half_facet h = m_mesh->opposite({e.cell, e.to});
    if (!h.cell.is_valid()) return false;
    e = {h.cell, std::uint8_t(h.index), std::uint8_t(m_mesh->index(h.cell, m_mesh->vertex(e.cell, e.from)))};
    return true;
  }

  Link link(std::size_t b, std::size_t k) {
    Block& block = m_blocks[b];
    return {block.edges.data() + (k == 0 ? 0 : block.ends[k - 1]), block.edges.data() + block.ends[k], &block.turning_fluxes[k]};
  }

  // Calls f(link) for all links: in parallel for those that stay in their blocks, since these share no cell with those of another
  // block, then for the others. At each cell the order is the same for any number of threads.
  template <typename ConcurrencyTag, typename Function>
  void for_each_link(const Function& f) {
    const auto run_block = [&](std::size_t b, bool stays) {
      for (std::size_t k = 0; k < m_blocks[b].ends.size(); ++k)
        if (bool(m_blocks[b].stay[k]) == stays) f(link(b, k));
    };
    for_each_index<ConcurrencyTag>(m_blocks.size(), [&](std::size_t b) { run_block(b, true); }, 1);
    for (std::size_t b = 0; b < m_blocks.size(); ++b) run_block(b, false);
  }

  // Takes the circulation away, and returns the flux around the edge that does so.
  double relax(const Link& link) {
    double circulation = 0, energy = 0;
    for (const Link_edge* e = link.begin; e != link.end; ++e) {
      const Cell& cell = m_cells[e->cell];
      const Vector d = along(*e);
      circulation += cell.vector * d;
      energy += cell.weight * d.squared_length();
    }
    const double flux = -circulation / energy;
    for (const Link_edge* e = link.begin; e != link.end; ++e) {
      Cell& cell = m_cells[e->cell];
      cell.vector += flux * cell.weight * along(*e);
    }
    return flux;
  }

  void add_to_fluxes(const Link& link, std::vector<double>& fluxes) const {
    const double flux = *link.turning_flux;
    const auto add_outflow = [&](Cell_index c, int facet, double outflow) {
      const Facet_index f = m_mesh->facet(c, facet);
      fluxes[f] += is_first(f, c) ? outflow : -outflow;
    };
    const Link_edge& first = *link.begin;
    if (m_mesh->is_boundary(m_mesh->facet(first.cell, first.to))) add_outflow(first.cell, first.to, -flux);
    for (const Link_edge* e = link.begin; e != link.end; ++e) add_outflow(e->cell, e->from, flux);
  }

  Vector along(const Link_edge& e) const {
    return m_points[m_mesh->vertex(e.cell, e.to)] - m_points[m_mesh->vertex(e.cell, e.from)];
  }

  const Mesh* m_mesh;
  Index_blocks m_cell_blocks;
  std::vector<Point> m_points; // of the vertices
  std::vector<Cell> m_cells;
  std::vector<Block> m_blocks;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CIRCULATION_RELAXATION_H
