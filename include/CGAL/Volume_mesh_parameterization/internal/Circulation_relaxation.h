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
  // `volumes` are those of the cells, `fluxes` those out of the cell of half_facet(f), for each facet f.
  Circulation_relaxation(const Mesh& mesh, const std::vector<double>& volumes, std::vector<double>& fluxes)
      : m_mesh(&mesh), m_volumes(&volumes), m_fluxes(&fluxes) {
    m_points.reserve(mesh.number_of_vertices());
    m_vectors.reserve(mesh.number_of_cells());
    for (const auto& p : mesh.points()) m_points.push_back(approximate(p));
    for (Cell_index c : mesh.cells()) m_vectors.push_back(vector(c));
    find_links();
  }

  void run(int rounds) {
    for (int round = 0; round < rounds; ++round)
      for (std::size_t k = 0; k + 1 < m_first.size(); ++k) relax(k);
  }

private:
  using Vector = Double_kernel::Vector_3;
  using Point = Double_kernel::Point_3;

  // A cell at an edge, with the part of the link of the edge that lies in it: from one vertex to another.
  struct Link_edge {
    Cell_index cell;
    std::uint8_t from, to;
  };

  Vector vector(Cell_index c) const {
    Vector sum = NULL_VECTOR;
    for (int i = 0; i < 4; ++i) {
      const Facet_index f = m_mesh->facet(c, i);
      const double outflow = is_first(f, c) ? (*m_fluxes)[f] : -(*m_fluxes)[f];
      sum -= outflow * (m_points[m_mesh->vertex(c, i)] - CGAL::ORIGIN);
    }
    return sum / (3 * (*m_volumes)[c]);
  }

  bool is_first(Facet_index f, Cell_index c) const { return m_mesh->half_facet(f).cell == c; }

  void find_links() {
    m_links.reserve(6 * m_mesh->number_of_cells());
    std::vector<std::uint8_t> found(m_mesh->number_of_cells(), 0); // a bit for each edge of the cell
    for (Cell_index c : m_mesh->cells())
      for (std::uint8_t i = 0; i < 4; ++i)
        for (std::uint8_t j = i + 1; j < 4; ++j)
          if (!(found[c] & bit({c, i, j}))) add_link({c, i, j}, found);
    m_links.shrink_to_fit();
  }

  static unsigned bit(const Link_edge& e) {
    const int i = (std::min)(e.from, e.to), j = (std::max)(e.from, e.to);
    return 1u << (i == 0 ? j - 1 : i + j);
  }

  // Adds the link that `e` is a part of: a loop, or a path with both ends on floor or ceiling.
  void add_link(Link_edge e, std::vector<std::uint8_t>& found) {
    const Cell_index start = e.cell;
    while (go_back(e) && e.cell != start) continue;
    const Cell_index first = e.cell;
    const bool is_relaxed = is_passed(e.cell, e.to);
    do {
      found[e.cell] |= std::uint8_t(bit(e));
      m_links.push_back(e);
    } while (go_on(e) && e.cell != first);
    if (is_relaxed && is_passed(e.cell, e.from))
      m_first.push_back(m_links.size());
    else
      m_links.resize(m_first.back());
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

  // A flux of a around the edge is a d / (3 V) in a cell of volume V where the link goes by d.
  void relax(std::size_t link) {
    double circulation = 0, energy = 0;
    for (std::size_t k = m_first[link]; k < m_first[link + 1]; ++k) {
      const Link_edge& e = m_links[k];
      const Vector d = along(e);
      circulation += m_vectors[e.cell] * d;
      energy += d.squared_length() / (*m_volumes)[e.cell];
    }
    const double flux = -3 * circulation / energy;
    const Link_edge& first = m_links[m_first[link]];
    if (m_mesh->is_boundary(m_mesh->facet(first.cell, first.to))) add_outflow(first.cell, first.to, -flux);
    for (std::size_t k = m_first[link]; k < m_first[link + 1]; ++k) {
      const Link_edge& e = m_links[k];
      m_vectors[e.cell] += flux / (3 * (*m_volumes)[e.cell]) * along(e);
      add_outflow(e.cell, e.from, flux);
    }
  }

  Vector along(const Link_edge& e) const {
    return m_points[m_mesh->vertex(e.cell, e.to)] - m_points[m_mesh->vertex(e.cell, e.from)];
  }

  void add_outflow(Cell_index c, int facet, double flux) {
    const Facet_index f = m_mesh->facet(c, facet);
    (*m_fluxes)[f] += is_first(f, c) ? flux : -flux;
  }

  const Mesh* m_mesh;
  const std::vector<double>* m_volumes;
  std::vector<double>* m_fluxes;
  std::vector<Point> m_points;            // of the vertices
  std::vector<Vector> m_vectors;          // of the cells
  std::vector<Link_edge> m_links;         // of the edges, one after the other
  std::vector<std::size_t> m_first = {0}; // where each link starts, and where the last one ends
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CIRCULATION_RELAXATION_H
