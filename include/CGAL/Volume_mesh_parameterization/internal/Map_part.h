// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PART_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PART_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Foldover_free_energy.h>
#include <CGAL/Volume_mesh_parameterization/internal/Splittable_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Some tetrahedra of a mesh and a map of their vertices, with their own numbers.

A boundary triangle whose vertices slide in its plane may turn over together with its tetrahedron, which then is positive. So it
has a guard: a tetrahedron on top of it, on the inner side, whose apex slides at a fixed distance from the plane.
*/
template <typename GeomTraits>
class Map_part {
public:
  using Mesh = Splittable_mesh<GeomTraits>;
  using Position = Eigen::Vector3d;
  using Cell = Foldover_free_energy::Cell;
  using Id = std::uint32_t;

  using Freedom = Foldover_free_energy::Freedom;

  // What becomes of vertices on the boundary of the mesh.
  enum Boundary { HELD, SLIDING };

  // points, images, freedoms: of the vertices of the mesh; those on the border of the part are fixed
  Map_part(const Mesh& mesh, const std::vector<Cell_index>& cells, const std::vector<Position>& points,
           const std::vector<Position>& images, const std::vector<Freedom>& freedoms, Boundary boundary) {
    for (Cell_index c : cells)
      for (Vertex_index v : mesh.cell(c)) m_vertices.push_back(v);
    std::sort(m_vertices.begin(), m_vertices.end());
    m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());
    std::vector<std::size_t> degree(m_vertices.size(), 0);
    for (Cell_index c : cells) {
      m_cells.emplace_back();
      for (int i = 0; i < 4; ++i) ++degree[m_cells.back()[i] = number(mesh.cell(c)[i])];
    }
    for (std::size_t i = 0; i < m_vertices.size(); ++i) {
      const Vertex_index v = m_vertices[i];
      m_rest.push_back(points[v]);
      m_positions.push_back(images[v]);
      const bool is_inside = degree[i] == mesh.star(v).size(),
                 may_move = boundary == SLIDING || freedoms[v] == Foldover_free_energy::free;
      m_freedoms.push_back(is_inside && may_move ? freedoms[v] : Foldover_free_energy::fixed);
    }
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (int k = 0; k < 4; ++k)
        if (mesh.labels(cells[c])[k] != INTERIOR) add_guard(m_cells[c], k);
  }

  const std::vector<Cell>& cells() const { return m_cells; }
  Foldover_free_energy energy(Model_shape shape) {
    return {m_cells, m_guards, m_rest, m_freedoms, m_positions, shape};
  }

  // Moves each vertex inside to the mean of its neighbors, again and again: far from where it was tangled.
  void smooth() {
    constexpr int sweeps = 50;
    std::vector<Position> sums(m_positions.size());
    std::vector<int> counts(m_positions.size());
    for (int k = 0; k < sweeps; ++k) {
      std::fill(sums.begin(), sums.end(), Position::Zero());
      std::fill(counts.begin(), counts.end(), 0);
      for (const Cell& cell : m_cells)
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j) {
            if (i == j) continue;
            sums[cell[i]] += m_positions[cell[j]];
            ++counts[cell[i]];
          }
      for (std::size_t v = 0; v < m_positions.size(); ++v)
        if (m_freedoms[v] == Foldover_free_energy::free) m_positions[v] = sums[v] / counts[v];
    }
  }

  // Exchanges the positions of the vertices of the part with those of the mesh.
  void swap(std::vector<Position>& images) {
    for (std::size_t i = 0; i < m_vertices.size(); ++i) std::swap(images[m_vertices[i]], m_positions[i]);
  }

private:
  // For the facet opposite to vertex i of a cell, if it may slide.
  void add_guard(const Cell& cell, int i) {
    const std::array<Id, 3> facet{cell[(i + 1) % 4], cell[(i + 2) % 4], cell[(i + 3) % 4]};
    if (std::all_of(facet.begin(), facet.end(),
                    [this](Id v) { return m_freedoms[v] == Foldover_free_energy::fixed; }))
      return;
    int axis = 0;
    normal(facet, m_positions).cwiseAbs().maxCoeff(&axis);
    m_guards.push_back(cell);
    m_guards.back()[i] = Id(m_positions.size());
    m_rest.push_back(apex(facet, i, m_rest));
    m_positions.push_back(apex(facet, i, m_positions));
    m_freedoms.push_back(Freedom(Foldover_free_energy::free & ~(1 << axis)));
  }

  static Position normal(const std::array<Id, 3>& facet, const std::vector<Position>& p) {
    return (p[facet[1]] - p[facet[0]]).cross(p[facet[2]] - p[facet[0]]).normalized();
  }

  // Above the barycentre of the facet opposite to vertex i of a positive cell, on the side of this vertex.
  static Position apex(const std::array<Id, 3>& facet, int i, const std::vector<Position>& p) {
    const Position middle = (p[facet[0]] + p[facet[1]] + p[facet[2]]) / 3;
    const double size = (p[facet[1]] - p[facet[0]]).norm();
    return middle + (i % 2 == 0 ? -size : size) * normal(facet, p);
  }

  Id number(Vertex_index v) const {
    return Id(std::lower_bound(m_vertices.begin(), m_vertices.end(), v) - m_vertices.begin());
  }

  std::vector<Vertex_index> m_vertices;
  std::vector<Position> m_rest, m_positions;
  std::vector<Cell> m_cells, m_guards;
  std::vector<Freedom> m_freedoms;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MAP_PART_H
