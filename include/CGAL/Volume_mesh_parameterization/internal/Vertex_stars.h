// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VERTEX_STARS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VERTEX_STARS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The cells around each vertex of a tetrahedral mesh.
class Vertex_stars {
public:
  Vertex_stars() = default;

  template <typename Mesh>
  explicit Vertex_stars(const Mesh& mesh)
      : m_cells(mesh.number_of_vertices(), mesh.number_of_cells(),
                [&](Cell_index c) { return mesh.cell(c); }) {}

  // returns an iterator range of `Cell_index` in increasing order.
  auto cells(Vertex_index v) const { return m_cells[v]; }

private:
  Incidence_lists<Vertex_index, Cell_index> m_cells;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VERTEX_STARS_H
