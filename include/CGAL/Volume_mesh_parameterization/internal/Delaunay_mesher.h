// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DELAUNAY_MESHER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DELAUNAY_MESHER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CONSTRAINED_DELAUNAY

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Edge_numbering.h>
#include <CGAL/Volume_mesh_parameterization/internal/Splittable_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/make_conforming_constrained_Delaunay_triangulation_3.h>
#include <CGAL/squared_distance_3.h>

#include <array>
#include <cstddef>
#include <exception>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Meshes the inside of a surface by the constrained Delaunay triangulation of CGAL 6.1. Where edges of the surface are no
// edges of it, they get more points, and the triangles around them are cut; there are no points inside.
template <typename Point>
class Delaunay_mesher {
public:
  explicit Delaunay_mesher(const Triangle_soup_3<Point>& surface) : m_surface(surface) {}

  // The points of the surface come first.
  Status mesh(Tetrahedron_soup_3<Point>& soup) const {
    std::vector<Site> sites;
    for (const Point& point : m_surface.points) {
      const auto p = approximate(point);
      sites.emplace_back(p.x(), p.y(), p.z());
    }
    try {
      soup = cells_inside(make_conforming_constrained_Delaunay_triangulation_3(sites, m_surface.triangles),
                          sites);
    } catch (const std::exception& failure) {
      return {ERROR_TETRAHEDRALIZATION, failure.what()};
    }
    return {};
  }

private:
  using Site = Exact_predicates_inexact_constructions_kernel::Point_3;

  template <typename Delaunay>
  Tetrahedron_soup_3<Point> cells_inside(const Delaunay& delaunay, const std::vector<Site>& sites) const {
    Tetrahedron_soup_3<Point> soup;
    soup.points = m_surface.points;
    std::map<Site, std::size_t> numbers;
    for (std::size_t i = 0; i < sites.size(); ++i) numbers.emplace(sites[i], i);
    const auto number = [&](const Site& site) {
      const auto [position, is_new] = numbers.emplace(site, soup.points.size());
      if (is_new) soup.points.emplace_back(site.x(), site.y(), site.z());
      return position->second;
    };
    const auto is_outside = cells_outside(delaunay);
    const auto& triangulation = delaunay.triangulation();
    for (auto c : triangulation.finite_cell_handles()) {
      if (is_outside[c]) continue;
      std::array<std::size_t, 4> v;
      for (int i = 0; i < 4; ++i) v[i] = number(triangulation.point(c->vertex(i)));
      soup.cells.push_back(v);
      for (int i = 0; i < 4; ++i)
        if (delaunay.is_facet_constrained(c, i))
          soup.facets.push_back({{v[(i + 1) % 4], v[(i + 2) % 4], v[(i + 3) % 4]},
                                 label(std::size_t(delaunay.face_constraint_index(c, i)))});
    }
    return soup;
  }

  // Those that are joined to infinity by facets not on the surface.
  template <typename Delaunay>
  static auto cells_outside(const Delaunay& delaunay) {
    using Cell_handle = typename Delaunay::Triangulation::Cell_handle;
    Unique_hash_map<Cell_handle, bool> is_outside(false);
    std::vector<Cell_handle> to_visit(1, delaunay.triangulation().infinite_cell());
    is_outside[to_visit.back()] = true;
    while (!to_visit.empty()) {
      const Cell_handle c = to_visit.back();
      to_visit.pop_back();
      for (int i = 0; i < 4; ++i) {
        const Cell_handle next = c->neighbor(i);
        if (delaunay.is_facet_constrained(c, i) || is_outside[next]) continue;
        is_outside[next] = true;
        to_visit.push_back(next);
      }
    }
    return is_outside;
  }

  int label(std::size_t triangle) const {
    return m_surface.labels.empty() ? int(triangle) : m_surface.labels[triangle];
  }

  const Triangle_soup_3<Point>& m_surface;
};

// Bisects edges, longest first, until there are at least so many cells. In each round all edges are bisected that are more than
// half as long as the longest one.
template <typename Point>
Status bisect_longest_edges(std::size_t number_of_cells, Tetrahedron_soup_3<Point>& soup) {
  using Mesh = Compact_tetrahedral_mesh_3<typename Kernel_traits<Point>::Kernel>;
  Mesh mesh;
  Status status = mesh.assign(soup);
  while (status.ok() && mesh.number_of_cells() < number_of_cells) {
    const auto point = [&](Vertex_index v) { return approximate(mesh.point(v)); };
    const auto squared_length = [&](const Edge_numbering::Ends& e) {
      return CGAL::squared_distance(point(e[0]), point(e[1]));
    };
    const Edge_numbering numbering(mesh);
    std::vector<Edge_numbering::Ends> edges;
    for (std::size_t e = 0; e < numbering.number_of_edges(); ++e)
      edges.push_back(numbering.ends(Edge_index(e)));
    sort_longest_first(edges, point);
    Splittable_mesh<typename Mesh::Geom_traits> refined(mesh);
    for (const Edge_numbering::Ends& e : edges) {
      if (4 * squared_length(e) < squared_length(edges[0]) || refined.number_of_cells() >= number_of_cells)
        break;
      status = refined.insert_barycentre({e[0], e[1]});
      if (!status.ok()) return status;
    }
    status = std::move(refined).write_to(mesh);
  }
  if (status.ok()) soup = make_soup(mesh);
  return status;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CONSTRAINED_DELAUNAY

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DELAUNAY_MESHER_H
