// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_MAP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_MAP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Surface_topology.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationVerification

is what `verify_map()` found out about a piecewise linear map.
*/
struct Map_report {
  std::size_t flipped = 0;  ///< tetrahedra whose image is negatively oriented
  std::size_t flat = 0;     ///< tetrahedra whose image has no volume
  std::size_t off_axis = 0; ///< boundary triangles whose image lies in no plane orthogonal to an axis
  std::size_t overlaps = 0; ///< pairs of images of boundary triangles that share more than a common face
  Status status;            ///< the first reason why the map is no bijection

  /// returns whether no fault was found.
  bool is_bijective() const { return status.ok(); }
  /// returns whether the boundary goes to the boundary of a polycube.
  bool is_polycube_map() const { return is_bijective() && off_axis == 0; }
};

namespace internal {

// Finds pairs of triangles that meet in more than a common vertex or edge. No triangle may be degenerate.
template <typename GeomTraits>
class Triangle_overlaps {
  using Point_3 = typename GeomTraits::Point_3;
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

public:
  using Triangle = std::array<std::size_t, 3>;
  using Pair = std::pair<std::size_t, std::size_t>;

  Triangle_overlaps(const std::vector<Point_3>& points, const std::vector<Triangle>& triangles)
      : m_points(points), m_triangles(triangles) {}

  /// returns the pairs in increasing order.
  std::vector<Pair> find() const {
    std::vector<Box> boxes;
    boxes.reserve(m_triangles.size());
    for (std::size_t i = 0; i < m_triangles.size(); ++i) boxes.emplace_back(triangle(i).bbox(), i);
    std::vector<Pair> pairs;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      if (overlap(a.info(), b.info())) pairs.push_back(std::minmax({a.info(), b.info()}));
    });
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

private:
  typename GeomTraits::Triangle_3 triangle(std::size_t i) const {
    const Triangle& t = m_triangles[i];
    return {m_points[t[0]], m_points[t[1]], m_points[t[2]]};
  }

  // Orders the vertices of a triangle so that those shared with `other` come first; returns how many these are.
  static int shared_first(Triangle& t, const Triangle& other) {
    return int(std::stable_partition(
                   t.begin(), t.end(),
                   [&](std::size_t v) { return std::find(other.begin(), other.end(), v) != other.end(); }) -
               t.begin());
  }

  bool overlap(std::size_t i, std::size_t j) const {
    Triangle a = m_triangles[i], b = m_triangles[j];
    shared_first(b, m_triangles[i]);
    switch (shared_first(a, m_triangles[j])) {
    case 0:
      return typename GeomTraits::Do_intersect_3()(triangle(i), triangle(j));
    // the intersection is convex: more of it than the common vertex reaches the edge opposite to that in a or in b
    case 1:
      return meets(j, a[1], a[2]) || meets(i, b[1], b[2]);
    case 2:
      return same_side(m_points[a[0]], m_points[a[1]], m_points[a[2]], m_points[b[2]]);
    default:
      return true;
    }
  }

  bool meets(std::size_t i, std::size_t v, std::size_t w) const {
    const typename GeomTraits::Segment_3 segment(m_points[v], m_points[w]);
    return typename GeomTraits::Do_intersect_3()(triangle(i), segment);
  }

  static bool same_side(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) {
    return typename GeomTraits::Orientation_3()(p, q, r, s) == COPLANAR &&
           typename GeomTraits::Coplanar_orientation_3()(p, q, r, s) == POSITIVE;
  }

  const std::vector<Point_3>& m_points;
  const std::vector<Triangle>& m_triangles;
};

template <typename GeomTraits>
class Map_verifier {
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Point_3 = typename GeomTraits::Point_3;
  using Triangle = typename Triangle_overlaps<GeomTraits>::Triangle;

public:
  Map_verifier(const Mesh& mesh, const std::vector<Point_3>& images) : m_mesh(mesh), m_images(images) {}

  Map_report report() && {
    if (!check_input()) return m_report;
    check_gluing();
    check_signs();
    const std::vector<Triangle> boundary = boundary_triangles();
    check_axes(boundary);
    check_topology(boundary);
    if (m_report.flipped + m_report.flat == 0) check_overlaps(boundary);
    return m_report;
  }

private:
  void refuse(Error_code code, const std::string& detail) {
    if (m_report.status.ok()) m_report.status = {code, detail};
  }

  bool check_input() {
    if (m_images.size() != m_mesh.number_of_vertices())
      refuse(ERROR_WRONG_PARAMETER, std::to_string(m_images.size()) + " images for " +
                                        std::to_string(m_mesh.number_of_vertices()) + " vertices");
    if (m_report.status.ok())
      m_report.status = check_coordinates(
          m_images.size(), [this](std::size_t v) -> const auto& { return m_images[v]; });
    return m_report.status.ok();
  }

  // Positive cells on both sides of a facet are on different sides only if they see it with opposite orientations.
  void check_gluing() {
    for (Facet_index f : m_mesh.facets()) {
      if (m_mesh.is_boundary(f)) continue;
      const auto v = m_mesh.vertices(m_mesh.half_facet(f, 0)), w = m_mesh.vertices(m_mesh.half_facet(f, 1));
      const auto k = std::find(w.begin(), w.end(), v[0]) - w.begin();
      if (w[(k + 1) % 3] == v[1])
        refuse(ERROR_INVERTED_TETRAHEDRON, "tetrahedra " + std::to_string(m_mesh.half_facet(f, 0).cell) +
                                               " and " + std::to_string(m_mesh.half_facet(f, 1).cell) +
                                               " are oriented against each other");
    }
  }

  void check_signs() {
    const typename GeomTraits::Orientation_3 orientation;
    for (Cell_index c : m_mesh.cells()) {
      const auto& v = m_mesh.cell(c);
      const Orientation sign = orientation(m_images[v[0]], m_images[v[1]], m_images[v[2]], m_images[v[3]]);
      if (sign == POSITIVE) continue;
      ++(sign == NEGATIVE ? m_report.flipped : m_report.flat);
      refuse(ERROR_MAP_NOT_BIJECTIVE,
             "tetrahedron " + std::to_string(c) + (sign == NEGATIVE ? " is flipped" : " is flattened"));
    }
  }

  std::vector<Triangle> boundary_triangles() const {
    std::vector<Triangle> triangles;
    for (Facet_index f : m_mesh.boundary_facets()) {
      const auto v = m_mesh.vertices(f);
      triangles.push_back({v[0], v[1], v[2]});
    }
    return triangles;
  }

  void check_axes(const std::vector<Triangle>& boundary) {
    for (const auto& t : boundary) {
      const Point_3 &p = m_images[t[0]], &q = m_images[t[1]], &r = m_images[t[2]];
      m_report.off_axis += !((p.x() == q.x() && q.x() == r.x()) || (p.y() == q.y() && q.y() == r.y()) ||
                             (p.z() == q.z() && q.z() == r.z()));
    }
  }

  void check_topology(const std::vector<Triangle>& boundary) {
    const Surface_topology<3> surface(boundary);
    if (!surface.is_closed_manifold()) refuse(ERROR_NON_MANIFOLD, "the boundary is no closed surface");
    if (surface.number_of_components() != 1)
      refuse(ERROR_SEVERAL_COMPONENTS,
             "the boundary has " + std::to_string(surface.number_of_components()) + " components");
  }

  void check_overlaps(const std::vector<Triangle>& boundary) {
    const auto overlaps = Triangle_overlaps<GeomTraits>(m_images, boundary).find();
    m_report.overlaps = overlaps.size();
    if (overlaps.empty()) return;
    const auto name = [&](std::size_t i) {
      const auto& t = boundary[i];
      return std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]);
    };
    refuse(ERROR_MAP_NOT_BIJECTIVE, "the images of the boundary triangles " + name(overlaps[0].first) +
                                        " and " + name(overlaps[0].second) + " overlap");
  }

  const Mesh& m_mesh;
  const std::vector<Point_3>& m_images;
  Map_report m_report;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationVerification

verifies that the piecewise linear map that takes vertex \f$ v \f$ of `mesh` to `images[v]` is a bijection onto its
image.

All signs are exact when the predicates of `GeomTraits` are. That is the proof: if all images of tetrahedra are
positive, a generic point is covered as often as the image of the boundary winds around it. If the boundary is one
closed surface whose image does not meet itself, it winds around a point once or not at all.

Applied to the points of `mesh` itself, the function verifies that the mesh is embedded.

The function takes \f$ O(n + b \log^2 b) \f$ time for \f$ b \f$ boundary triangles whose boxes meet few others.
Overlaps are not looked for when a tetrahedron is not positive.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\param mesh a tetrahedral mesh
\param images the image of each vertex of `mesh`

\returns a report whose status is `ERROR_WRONG_PARAMETER` (not one image for each vertex),
`ERROR_COORDINATE_NOT_FINITE`, `ERROR_MAP_NOT_BIJECTIVE` (a tetrahedron is flipped or flat, or two boundary triangles
overlap), `ERROR_INVERTED_TETRAHEDRON` (the orders of vertices disagree), `ERROR_NON_MANIFOLD` or `ERROR_SEVERAL_COMPONENTS`
(the boundary is not one closed surface)
*/
template <typename GeomTraits>
Map_report verify_map(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                      const std::vector<typename GeomTraits::Point_3>& images) {
  return internal::Map_verifier<GeomTraits>(mesh, images).report();
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_MAP_H
