// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_HEXAHEDRAL_FIT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_HEXAHEDRAL_FIT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/AABB_types.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_facets.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

tells how well hexahedra fill a solid.
*/
struct Hexahedral_fit {
  double edge = 0;                     ///< mean length of the edges of boundary quadrilaterals
  double distance_to_solid = 0;        ///< greatest from the boundary of the hexahedra to that of the solid
  double distance_from_solid = 0;      ///< greatest from the boundary of the solid to that of the hexahedra
  double volume = 0;                   ///< of the hexahedra
  double solid_volume = 0;             ///< of the solid
};

namespace internal {

// A surface that points have a distance to, as triangles.
class Distant_surface {
public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point_3 = Kernel::Point_3;

  void add(const Point_3& p, const Point_3& q, const Point_3& r) { m_triangles.emplace_back(p, q, r); }

  void build() {
    m_tree.rebuild(m_triangles.cbegin(), m_triangles.cend());
    m_tree.accelerate_distance_queries();
  }

  double greatest_distance(const std::vector<Point_3>& points) const {
    double greatest = 0;
    for (const Point_3& p : points) greatest = (std::max)(greatest, m_tree.squared_distance(p));
    return std::sqrt(greatest);
  }

  // Of what the surface is around, if its triangles are seen counterclockwise from outside.
  double volume() const {
    double sum = 0;
    for (const auto& t : m_triangles) sum += CGAL::volume(m_triangles[0][0], t[0], t[1], t[2]);
    return sum;
  }

private:
  using Types = AABB_types<Kernel>;
  Types::Triangles m_triangles;
  Types::Tree<Types::Triangle_primitive> m_tree;
};

// Both boundaries, with points on each.
class Fit_measurement {
  using Point_3 = Distant_surface::Point_3;

public:
  template <typename GeomTraits>
  void add_solid(const Compact_tetrahedral_mesh_3<GeomTraits>& solid) {
    for (Facet_index f : solid.boundary_facets()) {
      const auto v = solid.vertices(f);
      const std::array<Point_3, 3> p{to_point(solid.point(v[0])), to_point(solid.point(v[1])),
                                     to_point(solid.point(v[2]))};
      m_solid.add(p[0], p[1], p[2]);
      m_on_solid.insert(m_on_solid.end(), p.begin(), p.end());
      m_on_solid.push_back(CGAL::centroid(p[0], p[1], p[2]));
    }
    m_solid.build();
  }

  // Four triangles around the middle of each quadrilateral have the volume of the bilinear surface.
  template <typename Point>
  void add_hexahedra(const Hexahedron_soup_3<Point>& hexahedra) {
    for (const auto& q : Hexahedron_facets(hexahedra.hexahedra).boundary) {
      std::array<Point_3, 4> p;
      for (int i = 0; i < 4; ++i) p[i] = to_point(hexahedra.points[q[i]]);
      const Point_3 middle = CGAL::midpoint(CGAL::midpoint(p[0], p[2]), CGAL::midpoint(p[1], p[3]));
      m_on_hexahedra.push_back(middle);
      for (int i = 0; i < 4; ++i) add_side(p[i], p[(i + 1) % 4], middle);
    }
    m_hexahedra.build();
  }

  Hexahedral_fit result() const {
    return {m_length / double(m_number_of_sides), m_solid.greatest_distance(m_on_hexahedra),
            m_hexahedra.greatest_distance(m_on_solid), m_hexahedra.volume(), m_solid.volume()};
  }

private:
  template <typename Point>
  static Point_3 to_point(const Point& p) {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  void add_side(const Point_3& p, const Point_3& q, const Point_3& middle) {
    m_hexahedra.add(p, q, middle);
    m_on_hexahedra.push_back(p);
    m_on_hexahedra.push_back(CGAL::midpoint(p, q));
    m_length += std::sqrt(CGAL::squared_distance(p, q));
    ++m_number_of_sides;
  }

  Distant_surface m_solid, m_hexahedra;
  std::vector<Point_3> m_on_solid, m_on_hexahedra;
  double m_length = 0; // of all sides
  std::size_t m_number_of_sides = 0;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

measures how well hexahedra fill a solid. Distances to the solid are those of the nodes, of the middles of edges and of the
middles of quadrilaterals; distances from it those of its boundary vertices and of the barycentres of its boundary triangles.

Takes \f$ O((n + m) \log (n + m)) \f$ time for \f$ n \f$ hexahedra and \f$ m \f$ tetrahedra, if the surfaces are near to each
other.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Point a point type of a \cgal kernel
\pre neither mesh is empty, and the vertices of the hexahedra exist: see `verify_hexahedra()`
*/
template <typename GeomTraits, typename Point>
Hexahedral_fit measure_hexahedral_fit(const Compact_tetrahedral_mesh_3<GeomTraits>& solid,
                                      const Hexahedron_soup_3<Point>& hexahedra) {
  internal::Fit_measurement measurement;
  measurement.add_solid(solid);
  measurement.add_hexahedra(hexahedra);
  return measurement.result();
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_HEXAHEDRAL_FIT_H
