// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_images_3.h>
#include <CGAL/Volume_mesh_parameterization/Polycube_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Axis_aligned_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Facet_adjacency.h>
#include <CGAL/Volume_mesh_parameterization/internal/Splittable_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/boundary_triangles.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_boundary_images.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

is a piecewise linear map of the boundary of a solid onto that of a given polycube, and the floor map that it contains:
the image of each boundary vertex is given, facets are mapped linearly.

It is checked exactly that the image of each facet lies in a plane orthogonal to an axis without being degenerate, and that
the images cover each plane as often as the facets of the polycube do: once. To compare these areas it is enough to
compare their borders. So the map is one to one.

\cgalModels{VolumeFloorMap_3}

\tparam Polycube `Polycube_3`
*/
template <typename Polycube>
class Boundary_map_3 {
public:
  using Geom_traits = typename Polycube::Geom_traits;   ///< a model of `VolumeParameterizationTraits_3`
  using FT = typename Geom_traits::FT;                  ///< the number type
  using Point_3 = typename Geom_traits::Point_3;        ///< the point type
  using Mesh = Compact_tetrahedral_mesh_3<Geom_traits>; ///< the type of the solid
  using Domain = Polycube;                              ///< the polycube
  using Base_point = Base_point_3<Geom_traits>;         ///< a point of the floor of the solid

  /// \param domain has been built; a reference to it is kept
  /// \param images the images of the first vertices of the solid, of all on its boundary at least; those of inner vertices are
  /// not used
  Boundary_map_3(const Polycube& domain, std::vector<Point_3> images)
      : m_domain(&domain), m_images(std::move(images)) {}

  /// returns the polycube.
  const Polycube& domain() const { return *m_domain; }

  /*!
  gives each boundary facet of `mesh` the label of the part of the polycube that it is mapped to, and checks that the map
  is one to one, and no facet is mapped across a border between labels.

  \returns `ERROR_BOUNDARY_MAP`, also if `domain()` is not valid; `ERROR_COORDINATE_NOT_FINITE`

  Complexity: \f$ O(n \log n) \f$.
  */
  Status label_boundary(Mesh& mesh) const {
    Status status = check_input(mesh);
    if (!status.ok()) return status;
    const Mesh& polycube = m_domain->mesh();
    std::vector<int> labels(mesh.number_of_boundary_facets(), INTERIOR);
    const std::vector<int> same(polycube.number_of_boundary_facets(), INTERIOR);
    const std::vector<int> domain_labels = internal::boundary_labels(polycube);
    status = check_cover(mesh, labels, same);
    if (status.ok()) status = find_labels(mesh, domain_labels, labels);
    if (status.ok()) status = check_cover(mesh, labels, domain_labels);
    for (Facet_index f : mesh.boundary_facets())
      if (status.ok()) mesh.set_label(f, labels[f]);
    return status;
  }

  /// \name Floor Map
  /// @{

  /*!
  prepares the map of the floor of `mesh`: the solid that `label_boundary()` was called for, refined or not.

  \returns `ERROR_BOUNDARY_MAP`, `ERROR_COORDINATE_NOT_FINITE`

  Complexity: \f$ O(n \log n) \f$.
  */
  Status build(const Mesh& mesh) {
    Status status = check_input(mesh);
    if (!status.ok()) return status;
    const std::vector<int> labels = floor_or_not(mesh), domain_labels = floor_or_not(m_domain->mesh());
    status = check_cover(mesh, labels, domain_labels);
    if (status.ok())
      status = make_surface<Geom_traits>(mesh, refined<Point_3>(mesh, m_images), labels, m_source);
    if (status.ok())
      status =
          make_surface<Geom_traits>(m_domain->mesh(), m_domain->mesh().points(), domain_labels, m_target);
    return status;
  }

  /*!
  hands out the images of the boundary vertices of `mesh`: those given, and those of barycentres of split simplices.

  \param mesh the solid that `build()` has succeeded for
  \param boundary receives the result
  */
  Status map_boundary(const Mesh& mesh, const std::vector<Point_3>& /*images*/,
                      Boundary_images_3<Geom_traits>& boundary) const {
    boundary = {};
    boundary.images = refined<Point_3>(mesh, m_images);
    return {};
  }

  /// returns the floor point of the polycube that `p`, on the floor of the solid, is mapped to.
  /// \pre `build()` has succeeded
  Base_point image(const Base_point& p) const { return transfer(p, *m_source, *m_target); }

  /// finds the floor point of the solid that is mapped to `q`.
  /// \pre `build()` has succeeded
  Status preimage(const Base_point& q, Base_point& result) const {
    result = transfer(q, *m_target, *m_source);
    return {};
  }

  /// @}

private:
  template <typename Traits>
  using Surface_of = internal::Axis_aligned_surface<Traits>;
  using Surface = Surface_of<Geom_traits>;
  // In plain numbers barycentres are rounded, so that borders askew bend where they are split.
  using Exact = std::conditional_t<std::is_floating_point<FT>::value,
                                   Exact_predicates_exact_constructions_kernel, Geom_traits>;

  Status check_input(const Mesh& mesh) const {
    return m_domain->is_valid() ? internal::check_boundary_images(mesh, m_images)
                                : Status(ERROR_BOUNDARY_MAP, "the polycube has not been built");
  }

  // The points of all vertices, of which those of the given ones on the boundary are known.
  template <typename Point>
  static std::vector<Point> refined(const Mesh& mesh, const std::vector<Point_3>& known) {
    std::vector<Point> points(internal::number_of_given_vertices(mesh), Point(0, 0, 0));
    for (std::size_t v = 0; v < (std::min)(points.size(), known.size()); ++v)
      if (internal::has_finite_coordinates(known[v]))
        points[v] = Point(known[v].x(), known[v].y(), known[v].z());
    for (const auto& simplex : mesh.split_simplices())
      points.push_back(internal::barycentre(points, simplex));
    return points;
  }

  static std::vector<int> floor_or_not(const Mesh& mesh) {
    std::vector<int> labels;
    for (Facet_index f : mesh.boundary_facets()) labels.push_back(mesh.label(f) == FLOOR);
    return labels;
  }

  // Takes the boundary facets with the vertices at `points`.
  template <typename Traits>
  static Status make_surface(const Mesh& mesh, const std::vector<typename Traits::Point_3>& points,
                             std::vector<int> labels, std::optional<Surface_of<Traits>>& surface) {
    std::vector<typename Surface_of<Traits>::Triangle> triangles;
    const Status status = internal::boundary_triangles<Traits>(mesh, points, ERROR_BOUNDARY_MAP, triangles);
    if (status.ok()) surface.emplace(std::move(triangles), std::move(labels));
    return status;
  }

  // Gives each boundary facet of `mesh` the label of the facet of the polycube that its image's barycentre lies in.
  Status find_labels(const Mesh& mesh, const std::vector<int>& domain_labels,
                     std::vector<int>& labels) const {
    std::optional<Surface> source, target;
    const std::vector<int> same(domain_labels.size(), INTERIOR);
    Status status = make_surface<Geom_traits>(mesh, refined<Point_3>(mesh, m_images), labels, source);
    if (status.ok())
      status = make_surface<Geom_traits>(m_domain->mesh(), m_domain->mesh().points(), same, target);
    if (!status.ok()) return status;
    const FT third = FT(1) / FT(3);
    for (std::size_t t = 0; t < labels.size(); ++t)
      labels[t] =
          domain_labels[target->find(source->point(t, {third, third, third}), source->normal(t), INTERIOR)];
    return {};
  }

  // Checks that the images of the facets cover those of the polycube with the same label once.
  Status check_cover(const Mesh& mesh, const std::vector<int>& labels,
                     const std::vector<int>& domain_labels) const {
    using Point = typename Exact::Point_3;
    const Mesh& polycube = m_domain->mesh();
    std::optional<Surface_of<Exact>> source, target;
    Status status = make_surface<Exact>(mesh, refined<Point>(mesh, m_images), labels, source);
    if (status.ok())
      status =
          make_surface<Exact>(polycube, refined<Point>(polycube, polycube.points()), domain_labels, target);
    return status.ok() ? compare(*source, *target) : status;
  }

  static Status compare(const Surface_of<Exact>& source, const Surface_of<Exact>& target) {
    using Chain = internal::Border_chain<Exact>;
    const Chain a(source), b(target);
    const auto* difference = Chain::difference(a, b);
    if (!difference) return {};
    const auto p = internal::approximate(difference->from);
    std::ostringstream text;
    text << "the images of the facets do not cover each patch of the polycube once: look at the plane "
         << "xyz"[difference->normal.axis] << " = " << p[difference->normal.axis] << " near (" << p << ")";
    return {ERROR_BOUNDARY_MAP, text.str()};
  }

  static Base_point transfer(const Base_point& p, const Surface& from, const Surface& to) {
    const Point_3 q = from.point(p.facet, p.barycentric);
    const std::size_t at = to.find(q, from.normal(p.facet), from.label(p.facet));
    return {Facet_index(at), to.weights(at, q)};
  }

  const Polycube* m_domain;
  std::vector<Point_3> m_images;             // of the vertices of the solid
  std::optional<Surface> m_source, m_target; // triangle f is boundary facet f
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_MAP_3_H
