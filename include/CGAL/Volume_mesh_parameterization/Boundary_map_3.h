// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Polycube_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Axis_aligned_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Splittable_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <CGAL/number_utils.h>

#include <optional>
#include <sstream>
#include <string>
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

\tparam Polycube `Polycube_3`
*/
template <typename Polycube>
class Boundary_map_3 {
public:
  using Geom_traits = typename Polycube::Geom_traits;
  using FT = typename Geom_traits::FT;
  using Point_3 = typename Geom_traits::Point_3;
  using Mesh = Compact_tetrahedral_mesh_3<Geom_traits>;
  using Domain = Polycube;
  using Base_point = Base_point_3<Geom_traits>;

  /// keeps a reference to `domain`, which has been built.
  /// \param images the images of the first vertices of the solid, of all on its boundary at least; those of inner vertices are not used
  Boundary_map_3(const Polycube& domain, std::vector<Point_3> images) : m_domain(&domain), m_images(std::move(images)) {}

  const Polycube& domain() const { return *m_domain; }

  /*!
  gives each boundary facet of `mesh` the label of the part of the polycube that it is mapped to, and checks that the map
  is one to one.

  \returns `ERROR_BOUNDARY_MAP`
  */
  Status label_boundary(Mesh& mesh) const {
    Part source, target;
    const Status status = collect(mesh, m_images, internal::Any_label(), source, target);
    if (!status.ok()) return status;
    const FT third = FT(1) / FT(3);
    for (std::size_t t = 0; t < source.facets.size(); ++t) {
      const Point_3 inside = source.surface->point(t, {third, third, third});
      const std::size_t at = target.surface->find(inside, source.surface->normal(t));
      mesh.set_label(source.facets[t], m_domain->mesh().label(target.facets[at]));
    }
    return {};
  }

  /// \name Floor Map
  /// @{

  /*!
  prepares the map of the floor of `mesh`: the solid that `label_boundary()` was called for, refined or not.

  \returns `ERROR_BOUNDARY_MAP`
  */
  Status build(const Mesh& mesh) {
    std::vector<Point_3> images = m_images;
    const std::size_t given = mesh.number_of_vertices() - mesh.split_simplices().size();
    images.resize(given, Point_3(0, 0, 0));
    for (const auto& simplex : mesh.split_simplices()) images.push_back(internal::barycentre(images, simplex));
    const Status status = collect(mesh, images, [](int label) { return label == FLOOR; }, m_source, m_target);
    if (!status.ok()) return status;
    m_source.index(mesh);
    m_target.index(m_domain->mesh());
    return {};
  }

  /// returns the floor point of the polycube that `p`, on the floor of the solid, is mapped to.
  Base_point image(const Base_point& p) const { return transfer(p, m_source, m_target); }

  /// finds the floor point of the solid that is mapped to `q`.
  Status preimage(const Base_point& q, Base_point& result) const {
    result = transfer(q, m_target, m_source);
    return {};
  }

  /// @}

private:
  using Surface = internal::Axis_aligned_surface<Geom_traits>;

  // Some boundary facets of a mesh as a surface in the polycube's space.
  struct Part {
    std::vector<Facet_index> facets;
    std::optional<Surface> surface;
    std::vector<std::uint32_t> triangles; // of the facets of the mesh

    void index(const Mesh& mesh) {
      triangles.assign(mesh.number_of_boundary_facets(), 0);
      for (std::size_t t = 0; t < facets.size(); ++t) triangles[facets[t]] = std::uint32_t(t);
    }
  };

  // Takes the wanted parts of the solid and of the polycube, and checks that one covers the other once.
  template <typename Predicate>
  Status collect(const Mesh& mesh, const std::vector<Point_3>& images, const Predicate& is_wanted, Part& source,
                 Part& target) const {
    Status status = check_images(mesh, images);
    if (status.ok()) status = collect(mesh, images, is_wanted, source);
    if (status.ok()) status = collect(m_domain->mesh(), m_domain->mesh().points(), is_wanted, target);
    return status.ok() ? check_cover(*source.surface, *target.surface) : status;
  }

  template <typename Predicate>
  static Status collect(const Mesh& mesh, const std::vector<Point_3>& points, const Predicate& is_wanted, Part& part) {
    internal::Boundary_triangles<Geom_traits> boundary;
    const Status status = boundary.collect(mesh, points, is_wanted, ERROR_BOUNDARY_MAP);
    if (!status.ok()) return status;
    part.facets = std::move(boundary.facets);
    part.surface.emplace(std::move(boundary.triangles));
    return {};
  }

  static Status check_images(const Mesh& mesh, const std::vector<Point_3>& images) {
    for (Facet_index f : mesh.boundary_facets())
      for (Vertex_index v : mesh.vertices(f)) {
        if (v >= images.size()) return {ERROR_BOUNDARY_MAP, "vertex " + std::to_string(v) + " has no image"};
        if (!internal::has_finite_coordinates(images[v])) return {ERROR_COORDINATE_NOT_FINITE, "the image of vertex " + std::to_string(v)};
      }
    return {};
  }

  static Status check_cover(const Surface& source, const Surface& target) {
    using Chain = internal::Border_chain<Geom_traits>;
    const Chain a(source), b(target);
    const auto* difference = Chain::difference(a, b);
    if (!difference) return {};
    const auto p = internal::approximate(difference->from);
    std::ostringstream text;
    text << "the images of the facets do not cover the facets of the polycube once: look at the plane " << "xyz"[difference->normal.axis]
         << " = " << p[difference->normal.axis] << " near (" << p << ")";
    return {ERROR_BOUNDARY_MAP, text.str()};
  }

  static Base_point transfer(const Base_point& p, const Part& from, const Part& to) {
    const std::size_t t = from.triangles[p.facet];
    const Point_3 q = from.surface->point(t, p.barycentric);
    const std::size_t at = to.surface->find(q, from.surface->normal(t));
    return {to.facets[at], to.surface->weights(at, q)};
  }

  const Polycube* m_domain;
  std::vector<Point_3> m_images; // of the vertices of the solid
  Part m_source, m_target;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_BOUNDARY_MAP_3_H
