// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CURVE_SPACES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CURVE_SPACES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>
#include <CGAL/Volume_mesh_parameterization/internal/Facet_adjacency.h>
#include <CGAL/Volume_mesh_parameterization/internal/Vertex_stars.h>

#include <boost/range/adaptor/filtered.hpp>

#include <array>
#include <cmath>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// What an integral curve runs through, seen alike for cells and for wall facets: simplices with corners, sides
// opposite to them, and gradients of the barycentric coordinates. Here the cells of the solid.
template <typename Mesh>
class Volume_space {
public:
  static constexpr int corners = 4;
  using Simplex = Cell_index;
  using Vector_3 = Double_kernel::Vector_3;

  explicit Volume_space(const Mesh& mesh) : m_mesh(&mesh), m_stars(mesh) {}

  const Mesh& mesh() const { return *m_mesh; }
  auto simplices() const { return m_mesh->cells(); }
  auto star(Vertex_index v) const { return m_stars.cells(v); }
  std::array<Vertex_index, 4> vertices(Cell_index c) const { return m_mesh->cell(c); }
  Cell_index neighbor(Cell_index c, int side) const { return m_mesh->neighbor(c, side); }
  Facet_index border(Cell_index c, int side) const { return m_mesh->facet(c, side); }
  std::array<Vector_3, 4> gradients(Cell_index c) const { return Cell_gradients(*m_mesh, c).gradients; }

  // the edge length of the regular tetrahedron of the same volume
  double size(Cell_index c) const { return std::cbrt(std::sqrt(72.) * Cell_gradients(*m_mesh, c).volume); }

private:
  const Mesh* m_mesh;
  Vertex_stars m_stars;
};

// The wall facets; a curve leaves them into facets of other patches.
template <typename Mesh>
class Wall_space {
public:
  static constexpr int corners = 3;
  using Simplex = Facet_index;
  using Vector_3 = Double_kernel::Vector_3;

  explicit Wall_space(const Mesh& mesh) : m_mesh(&mesh), m_surface(boundary_adjacency(mesh)) {}

  const Mesh& mesh() const { return *m_mesh; }
  auto simplices() const { return walls(m_mesh->boundary_facets()); }
  auto star(Vertex_index v) const { return walls(m_surface.star(v)); }
  std::array<Vertex_index, 3> vertices(Facet_index f) const { return m_mesh->vertices(f); }
  Facet_index neighbor(Facet_index f, int side) const {
    const Facet_index g = m_surface.neighbor(f, side);
    return is_wall(g) ? g : Facet_index();
  }
  // Where the boundary is no manifold there may be no neighbor: then the curve ends on the wall.
  Facet_index border(Facet_index f, int side) const {
    const Facet_index g = m_surface.neighbor(f, side);
    return m_mesh->is_boundary(g) ? g : f;
  }

  // in the plane of the facet: 1 / 2A times the opposite edge, turned by a right angle (step 5 of Xia et al. 2010)
  std::array<Vector_3, 3> gradients(Facet_index f) const {
    const auto p = points(f);
    const Vector_3 normal = CGAL::cross_product(p[1] - p[0], p[2] - p[0]);
    std::array<Vector_3, 3> result;
    for (int i = 0; i < 3; ++i)
      result[i] = CGAL::cross_product(normal, p[(i + 2) % 3] - p[(i + 1) % 3]) / normal.squared_length();
    return result;
  }

  // the edge length of the regular triangle of the same area
  double size(Facet_index f) const {
    return std::sqrt(4 / std::sqrt(3.) * std::sqrt(squared_area(*m_mesh, f)));
  }

private:
  bool is_wall(Facet_index f) const { return m_mesh->label(f) >= FIRST_WALL; }

  template <typename Range>
  auto walls(const Range& facets) const {
    return facets | boost::adaptors::filtered([this](Facet_index f) { return is_wall(f); });
  }

  std::array<Double_kernel::Point_3, 3> points(Facet_index f) const {
    const auto v = m_mesh->vertices(f);
    return {approximate(m_mesh->point(v[0])), approximate(m_mesh->point(v[1])),
            approximate(m_mesh->point(v[2]))};
  }

  const Mesh* m_mesh;
  Facet_adjacency m_surface;
};

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CURVE_SPACES_H
