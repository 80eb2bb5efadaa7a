// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLUX_EQUILIBRATION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLUX_EQUILIBRATION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>
#include <CGAL/Volume_mesh_parameterization/internal/Vertex_stars.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Makes a conservative flux of a discrete gradient without a global system (Braess and Schöberl 2008). The gradient of the
// solution u of the finite-element equations of degree one jumps across facets, but its residual is orthogonal to the basis
// function phi_v of each unknown vertex v: around v, what phi_v grad u leaves too much in one cell is missing in others.
// There fluxes through the facets at v carry it, along a tree of the cells: which tree is of no importance, since
// `Circulation_relaxation` takes the circulations away. Nothing passes through walls, anything through floor and ceiling.
template <typename Mesh>
class Flux_equilibration {
public:
  explicit Flux_equilibration(const Mesh& mesh)
      : m_mesh(&mesh), m_stars(mesh), m_excess(mesh.number_of_facets()), m_rest(mesh.number_of_cells()),
        m_is_left(mesh.number_of_cells(), 0) {}

  // returns the fluxes out of the cell of half_facet(f), for each facet; `values` are those of u at the vertices.
  template <typename ConcurrencyTag>
  std::vector<double> fluxes(const std::vector<double>& values) {
    std::vector<double> result(m_mesh->number_of_facets());
    set_means<ConcurrencyTag>(values, result);
    for (Vertex_index v : m_mesh->vertices()) equilibrate(v, result);
    return result;
  }

private:
  bool is_wall(Facet_index f) const {
    return m_mesh->is_boundary(f) && m_mesh->label(f) != FLOOR && m_mesh->label(f) != CEILING;
  }

  // The flux through a facet is the mean of both sides; at each of its corners a third of the difference is too much in one
  // cell and missing in the other, so both have half of the jump too much.
  template <typename ConcurrencyTag>
  void set_means(const std::vector<double>& values, std::vector<double>& fluxes) {
    constexpr std::size_t block = 4096;
    std::vector<std::array<double, 4>> outflows(m_mesh->number_of_cells());
    for_each_index<ConcurrencyTag>(
        outflows.size(), [&](std::size_t c) { outflows[c] = outflows_at_corners(Cell_index(c), values); }, block);
    const auto outflow = [&](Half_facet h) { return outflows[h.cell][h.index]; };
    const auto set_mean = [&](std::size_t i) {
      const Facet_index f(i);
      const double first = outflow(m_mesh->half_facet(f));
      const double second = m_mesh->is_boundary(f) ? 0 : outflow(m_mesh->half_facet(f, 1));
      m_excess[f] = m_mesh->is_boundary(f) ? (is_wall(f) ? first : 0) : (first + second) / 2;
      fluxes[f] = m_mesh->is_boundary(f) ? (is_wall(f) ? 0 : 3 * first) : 3 * (first - second) / 2;
    };
    for_each_index<ConcurrencyTag>(fluxes.size(), set_mean, block);
  }

  // A third of what the gradient brings out of the cell through each facet.
  std::array<double, 4> outflows_at_corners(Cell_index c, const std::vector<double>& values) const {
    const Cell_gradients cell(*m_mesh, c);
    const auto& v = m_mesh->cell(c);
    const auto gradient = cell.interpolate({values[v[0]], values[v[1]], values[v[2]], values[v[3]]});
    std::array<double, 4> result;
    for (int i = 0; i < 4; ++i) result[i] = -cell.volume * (cell.gradients[i] * gradient);
    return result;
  }

  // Cells far from the root of the tree give what is too much to their parents; the root gives it to floor or ceiling, if
  // v is there; else what arrives is the residual of the equation of v.
  void equilibrate(Vertex_index v, std::vector<double>& fluxes) {
    const Half_facet exit = grow_tree(v);
    for (std::size_t k = m_tree.size(); k-- > 0;) {
      const Half_facet h = k == 0 ? exit : m_tree[k];
      if (!h.cell.is_valid()) return;
      const Facet_index f = m_mesh->facet(h.cell, h.index);
      fluxes[f] += m_mesh->half_facet(f).cell == h.cell ? m_rest[h.cell] : -m_rest[h.cell];
      if (k > 0) m_rest[m_mesh->neighbor(h.cell, h.index)] += m_rest[h.cell];
    }
  }

  // The cells around v breadth first, each with its facet to its parent, and what is too much in each. Returns the facet of the
  // root on floor or ceiling, an invalid one if there is none.
  Half_facet grow_tree(Vertex_index v) {
    const auto star = m_stars.cells(v);
    Half_facet exit{Cell_index(), 0};
    for (Cell_index c : star) {
      m_rest[c] = 0;
      for_each_side(c, v, [&](int i, Facet_index f) {
        m_rest[c] += m_excess[f];
        if (m_mesh->is_boundary(f) && !is_wall(f)) exit = {c, i};
      });
      m_is_left[c] = 1;
    }
    m_tree.assign(1, {exit.cell.is_valid() ? exit.cell : *star.begin(), 0});
    m_is_left[m_tree[0].cell] = 0;
    for (std::size_t k = 0; k < m_tree.size(); ++k) {
      const Cell_index c = m_tree[k].cell;
      for_each_side(c, v, [&](int i, Facet_index) {
        const Half_facet h = m_mesh->opposite({c, i});
        if (h.cell.is_valid() && m_is_left[h.cell]) {
          m_is_left[h.cell] = 0;
          m_tree.push_back(h);
        }
      });
    }
    return exit;
  }

  // calls f(i, facet) for the three facets of c that contain v
  template <typename Function>
  void for_each_side(Cell_index c, Vertex_index v, const Function& f) const {
    for (int i = 0; i < 4; ++i)
      if (m_mesh->vertex(c, i) != v) f(i, m_mesh->facet(c, i));
  }

  const Mesh* m_mesh;
  Vertex_stars m_stars;
  std::vector<double> m_excess;   // at each corner of a facet, of each of its cells
  std::vector<double> m_rest;     // of cells: what is too much
  std::vector<char> m_is_left;    // of cells: whether it is still to join the tree
  std::vector<Half_facet> m_tree; // the first one is the root, whose facet does not count
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLUX_EQUILIBRATION_H
