// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TRIANGULATION_CELLS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TRIANGULATION_CELLS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <CGAL/Unique_hash_map.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMesh

is the tetrahedral mesh of some cells of a triangulation, for example of those inside a domain. The cells of a solid
with handles are no valid triangulation by themselves, but they can be chosen cells of one of its convex hull.

Cells and vertices are numbered in the order of the triangulation's containers; vertices of no chosen cell have no
number.

\cgalModels{TetrahedralMesh_3}

\tparam Triangulation a `CGAL::Triangulation_3` or a class derived from it, with weights or without
*/
template <typename Triangulation>
class Triangulation_cells_3 {
public:
  using Vertex_handle = typename Triangulation::Vertex_handle;  ///< of the triangulation
  using Cell_handle = typename Triangulation::Cell_handle;      ///< of the triangulation
  using Facet = typename Triangulation::Facet;                  ///< of the triangulation
  using Point_3 = typename Triangulation::Geom_traits::Point_3; ///< the point type, without weight
  using Cell_vertices = std::array<std::size_t, 4>;             ///< the vertices of a cell

  /// chooses cells in linear time. `triangulation` is kept by reference and must not change.
  /// \tparam IsChosen a functor `bool operator()(Cell_handle)`, called for finite cells
  /// \tparam LabelOf a functor `int operator()(Facet)`, called for the facets between a cell that is chosen, that of the
  /// facet, and one that is not; 0 for no label
  template <typename IsChosen, typename LabelOf>
  Triangulation_cells_3(const Triangulation& triangulation, const IsChosen& is_chosen,
                        const LabelOf& label_of)
      : m_triangulation(&triangulation) {
    for (auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c)
      if (is_chosen(Cell_handle(c))) m_cell_handles.push_back(c);
    const Numbers numbers = number_vertices();
    for (Cell_handle c : m_cell_handles) {
      m_cells.push_back(
          {numbers[c->vertex(0)], numbers[c->vertex(1)], numbers[c->vertex(2)], numbers[c->vertex(3)]});
      for (int i = 0; i < 4; ++i)
        if (triangulation.is_infinite(c->neighbor(i)) || !is_chosen(c->neighbor(i)))
          add_facet(m_cells.back(), i, label_of(Facet(c, i)));
    }
  }

  /// \name Operations of the Concept
  /// @{

  /// returns the number of vertices of chosen cells.
  std::size_t number_of_vertices() const { return m_vertex_handles.size(); }
  /// returns the number of chosen cells.
  std::size_t number_of_cells() const { return m_cells.size(); }
  /// returns the position of a vertex.
  Point_3 point(std::size_t vertex) const {
    return m_triangulation->geom_traits().construct_point_3_object()(
        m_triangulation->point(m_vertex_handles[vertex]));
  }
  /// returns the vertices of a cell.
  const Cell_vertices& cell(std::size_t c) const { return m_cells[c]; }
  /// returns the facets that have a label.
  const std::vector<Labelled_facet>& labelled_facets() const { return m_facets; }
  /// @}
  /// \name The Way Back
  /// @{

  /// returns the vertex of the triangulation with this number.
  Vertex_handle vertex_handle(std::size_t vertex) const { return m_vertex_handles[vertex]; }
  /// returns the cell of the triangulation with this number.
  Cell_handle cell_handle(std::size_t c) const { return m_cell_handles[c]; }
  /// @}

private:
  using Numbers = Unique_hash_map<Vertex_handle, std::size_t>;

  Numbers number_vertices() {
    Numbers numbers;
    for (Cell_handle c : m_cell_handles)
      for (int i = 0; i < 4; ++i) numbers[c->vertex(i)] = 0;
    for (auto v = m_triangulation->finite_vertices_begin(); v != m_triangulation->finite_vertices_end(); ++v)
      if (numbers.is_defined(v)) {
        numbers[v] = m_vertex_handles.size();
        m_vertex_handles.push_back(v);
      }
    return numbers;
  }

  void add_facet(const Cell_vertices& v, int i, int label) {
    if (label != INTERIOR) m_facets.push_back({{v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4]}, label});
  }

  const Triangulation* m_triangulation;
  std::vector<Vertex_handle> m_vertex_handles;
  std::vector<Cell_handle> m_cell_handles;
  std::vector<Cell_vertices> m_cells;
  std::vector<Labelled_facet> m_facets;
};

/*!
\ingroup PkgVolumeMeshParameterizationMesh

returns the chosen cells of `triangulation`: see the constructor of `Triangulation_cells_3`.

\tparam Triangulation a `CGAL::Triangulation_3` or a class derived from it
\tparam IsChosen a functor `bool operator()(Cell_handle)`
\tparam LabelOf a functor `int operator()(Facet)`
*/
template <typename Triangulation, typename IsChosen, typename LabelOf>
Triangulation_cells_3<Triangulation> make_triangulation_cells(const Triangulation& triangulation,
                                                              const IsChosen& is_chosen,
                                                              const LabelOf& label_of) {
  return {triangulation, is_chosen, label_of};
}

/*!
\ingroup PkgVolumeMeshParameterizationMesh

returns the cells in the complex `c3t3`. The complex is kept by reference and must not change.

\tparam MeshComplex a model of `MeshComplex_3InTriangulation_3`
\tparam LabelOfPatch a functor `int operator()(Surface_patch_index)`, called for the boundary facets in the complex
*/
template <typename MeshComplex, typename LabelOfPatch>
Triangulation_cells_3<typename MeshComplex::Triangulation>
make_triangulation_cells(const MeshComplex& c3t3, const LabelOfPatch& label_of_patch) {
  using Triangulation = typename MeshComplex::Triangulation;
  return {c3t3.triangulation(), [&](typename Triangulation::Cell_handle c) { return c3t3.is_in_complex(c); },
          [&](const typename Triangulation::Facet& f) {
            return c3t3.is_in_complex(f) ? int(label_of_patch(c3t3.surface_patch_index(f))) : int(INTERIOR);
          }};
}

/*!
\ingroup PkgVolumeMeshParameterizationMesh

returns the cells in the complex `c3t3`, without labels.

\tparam MeshComplex a model of `MeshComplex_3InTriangulation_3`
*/
template <typename MeshComplex>
Triangulation_cells_3<typename MeshComplex::Triangulation> make_triangulation_cells(const MeshComplex& c3t3) {
  return make_triangulation_cells(c3t3, [](const auto&) { return int(INTERIOR); });
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TRIANGULATION_CELLS_3_H
