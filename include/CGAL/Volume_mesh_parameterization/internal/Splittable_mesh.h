// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SPLITTABLE_MESH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SPLITTABLE_MESH_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/point_between.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The barycentre of the points of a simplex, given by the numbers of its vertices.
template <typename Point, typename Simplex>
Point barycentre(const std::vector<Point>& points, const Simplex& simplex) {
  using FT = typename Kernel_traits<Point>::Kernel::FT;
  FT x(0), y(0), z(0);
  int n = 0;
  for (Vertex_index v : simplex) {
    if (!v.is_valid()) break;
    x += points[v].x();
    y += points[v].y();
    z += points[v].z();
    ++n;
  }
  return Point(x / FT(n), y / FT(n), z / FT(n));
}

/*
A tetrahedral mesh that can be refined by splitting edges, facets and cells. Each facet of each
cell carries its label, so that labels need no search. Cells around a vertex are kept as lists.
*/
template <typename GeomTraits>
class Splittable_mesh {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Point_3 = typename GeomTraits::Point_3;
  using Cell_vertices = typename Mesh::Cell_vertices;
  using Cell_labels = typename Mesh::Cell_labels;

  explicit Splittable_mesh(const Mesh& mesh)
      : m_points(mesh.points()),
        m_split_simplices(mesh.split_simplices()),
        m_stars(mesh.number_of_vertices()) {
    m_cells.reserve(mesh.number_of_cells());
    m_labels.reserve(mesh.number_of_cells());
    for (Cell_index c : mesh.cells()) {
      m_cells.push_back(mesh.cell(c));
      m_labels.push_back({mesh.label(c, 0), mesh.label(c, 1), mesh.label(c, 2), mesh.label(c, 3)});
      for (Vertex_index v : mesh.cell(c)) m_stars[v].push_back(c);
    }
  }

  template <typename ConcurrencyTag = Sequential_tag>
  Status write_to(Mesh& mesh) && {
    return mesh.template assign<ConcurrencyTag>(std::move(m_points), std::move(m_cells), m_labels, std::move(m_split_simplices));
  }

  const Point_3& point(Vertex_index v) const { return m_points[v]; }
  std::size_t number_of_cells() const { return m_cells.size(); }
  const Cell_vertices& cell(Cell_index c) const { return m_cells[c]; }
  const Cell_labels& labels(Cell_index c) const { return m_labels[c]; }
  // The cells around a vertex.
  const std::vector<Cell_index>& star(Vertex_index v) const { return m_stars[v]; }

  // Where a vertex is among those of a cell; 4 if it is none of them.
  static int slot(const Cell_vertices& cell, Vertex_index v) {
    return int(std::find(cell.begin(), cell.end(), v) - cell.begin());
  }

  // The cells that have all vertices of a simplex.
  std::vector<Cell_index> cells_around(const std::vector<Vertex_index>& simplex) const {
    std::vector<Cell_index> result;
    for (Cell_index c : m_stars[simplex[0]])
      if (std::all_of(simplex.begin(), simplex.end(),
                      [&](Vertex_index v) { return slot(m_cells[c], v) < 4; }))
        result.push_back(c);
    return result;
  }

  // The cell on the other side of the facet opposite to vertex i; invalid on the boundary.
  Cell_index neighbor(Cell_index c, int i) const {
    if (m_labels[c][i] != INTERIOR) return {};
    const Cell_vertices& v = m_cells[c];
    const std::vector<Cell_index> cells = cells_around({v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4]});
    return cells[0] == c ? cells[1] : cells[0];
  }

  /*
  Inserts the barycentre of the simplex with the given 2, 3 or 4 vertices. Every cell around it is replaced by one
  cell for each vertex v of the simplex, with v moved to the barycentre; `on_child(parent, child, v)` tells of it,
  the first child taking the parent's number. If a child would not be positive, nothing is changed.
  */
  template <typename OnChild>
  Status insert_barycentre(const std::vector<Vertex_index>& simplex, OnChild on_child) {
    const Status status = insert(simplex, internal::barycentre(m_points, simplex), on_child);
    if (!status.ok()) return status;
    m_split_simplices.emplace_back();
    std::copy(simplex.begin(), simplex.end(), m_split_simplices.back().begin());
    return status;
  }

  Status insert_barycentre(const std::vector<Vertex_index>& simplex) {
    return insert_barycentre(simplex, [](Cell_index, Cell_index, Vertex_index) {});
  }

  // Splits an edge at this part of the way, or in the middle if some child would not be positive otherwise. From then on all
  // points count as given.
  Status split_edge(Vertex_index v, Vertex_index w, double part) {
    const auto no_one_cares = [](Cell_index, Cell_index, Vertex_index) {};
    Status status = insert({v, w}, point_between(m_points[v], m_points[w], part), no_one_cares);
    if (!status.ok()) status = insert({v, w}, point_between(m_points[v], m_points[w], .5), no_one_cares);
    m_split_simplices.clear();
    return status;
  }

private:
  template <typename OnChild>
  Status insert(const std::vector<Vertex_index>& simplex, const Point_3& point, OnChild& on_child) {
    const std::vector<Cell_index> star = cells_around(simplex);
    for (Cell_index c : star)
      for (Vertex_index v : simplex)
        if (!is_positive_with(c, v, point))
          return {ERROR_CANNOT_SPLIT, "tetrahedron " + std::to_string(c) + " at vertex " + std::to_string(v)};
    const Vertex_index m(m_points.size());
    m_points.push_back(point);
    m_stars.emplace_back();
    for (Cell_index c : star) split(c, simplex, m, on_child);
    return {};
  }

  bool is_positive_with(Cell_index c, Vertex_index moved, const Point_3& p) const {
    const auto at = [&](int i) -> const Point_3& {
      return m_cells[c][i] == moved ? p : m_points[m_cells[c][i]];
    };
    return typename GeomTraits::Orientation_3()(at(0), at(1), at(2), at(3)) == POSITIVE;
  }

  template <typename OnChild>
  void split(Cell_index parent, const std::vector<Vertex_index>& simplex, Vertex_index m, OnChild& on_child) {
    const Cell_vertices vertices = m_cells[parent];
    const Cell_labels labels = m_labels[parent];
    for (Vertex_index v : vertices) erase_from_star(v, parent);
    for (std::size_t k = 0; k < simplex.size(); ++k) {
      const Cell_index child(k == 0 ? std::size_t(parent) : m_cells.size());
      if (k > 0) {
        m_cells.emplace_back();
        m_labels.emplace_back();
      }
      m_cells[child] = vertices;
      m_labels[child] = labels;
      for (Vertex_index u : simplex)
        if (u != simplex[k])
          m_labels[child][slot(vertices, u)] = INTERIOR; // the facet shared with the child of u
      m_cells[child][slot(vertices, simplex[k])] = m;
      for (Vertex_index v : m_cells[child]) m_stars[v].push_back(child);
      on_child(parent, child, simplex[k]);
    }
  }

  void erase_from_star(Vertex_index v, Cell_index c) {
    std::vector<Cell_index>& star = m_stars[v];
    star.erase(std::find(star.begin(), star.end(), c));
  }

  std::vector<Point_3> m_points;
  std::vector<typename Mesh::Simplex> m_split_simplices; // whose barycentres the last points are
  std::vector<Cell_vertices> m_cells;
  std::vector<Cell_labels> m_labels;
  std::vector<std::vector<Cell_index>> m_stars;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SPLITTABLE_MESH_H
