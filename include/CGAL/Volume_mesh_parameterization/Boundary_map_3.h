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
#include <CGAL/Volume_mesh_parameterization/internal/Boundary_triangles.h>
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

\cgalModels{VolumeFloorMap_3}

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

  /// \param domain has been built; a reference to it is kept
  /// \param images the images of the first vertices of the solid, of all on its boundary at least; those of inner vertices are not used
  Boundary_map_3(const Polycube& domain, std::vector<Point_3> images)
      : m_domain(&domain), m_images(std::move(images)) {}

  const Polycube& domain() const { return *m_domain; }

  /*!
  gives each boundary facet of `mesh` the label of the part of the polycube that it is mapped to, and checks that the map
  is one to one, and no facet is mapped across a border between labels.

  \returns `ERROR_BOUNDARY_MAP`, also if `domain()` is not valid; `ERROR_COORDINATE_NOT_FINITE`

  Complexity: \f$ O(n \log n) \f$.
  */
  Status label_boundary(Mesh& mesh) const {
    std::optional<Surface> source, target;
    Status status = cover(
        mesh, [](int) { return 0; }, source, target);
    if (!status.ok()) return status;
    const FT third = FT(1) / FT(3);
    std::vector<int> labels, domain_labels;
    for (Facet_index f : m_domain->mesh().boundary_facets())
      domain_labels.push_back(m_domain->mesh().label(f));
    for (std::size_t t = 0; t < source->number_of_triangles(); ++t)
      labels.push_back(
          domain_labels[target->find(source->point(t, {third, third, third}), source->normal(t), 0)]);
    source->set_labels(labels);
    target->set_labels(std::move(domain_labels));
    status = check_cover(*source, *target);
    for (std::size_t t = 0; status.ok() && t < labels.size(); ++t) mesh.set_label(Facet_index(t), labels[t]);
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
    return cover(
        mesh, [](int label) { return int(label == FLOOR); }, m_source, m_target);
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
  using Surface = internal::Axis_aligned_surface<Geom_traits>;

  // The vertices that are not barycentres of split simplices.
  static std::size_t number_of_given(const Mesh& mesh) {
    return mesh.number_of_vertices() - mesh.split_simplices().size();
  }

  std::vector<Point_3> images_of(const Mesh& mesh) const {
    std::vector<Point_3> images = m_images;
    images.resize(number_of_given(mesh), Point_3(0, 0, 0));
    for (const auto& simplex : mesh.split_simplices())
      images.push_back(internal::barycentre(images, simplex));
    return images;
  }

  // Takes the boundaries of the solid and of the polycube, facet by facet, labelled by the class of their labels, and
  // checks that one covers the other once.
  template <typename Class>
  Status cover(const Mesh& mesh, const Class& class_of, std::optional<Surface>& source,
               std::optional<Surface>& target) const {
    if (!m_domain->is_valid()) return {ERROR_BOUNDARY_MAP, "the polycube has not been built"};
    Status status = check_images(mesh);
    if (status.ok()) status = boundary(mesh, images_of(mesh), class_of, source);
    if (status.ok()) status = boundary(m_domain->mesh(), m_domain->mesh().points(), class_of, target);
    return status.ok() ? check_cover(*source, *target) : status;
  }

  template <typename Class>
  static Status boundary(const Mesh& mesh, const std::vector<Point_3>& points, const Class& class_of,
                         std::optional<Surface>& surface) {
    std::vector<typename Surface::Triangle> triangles;
    std::vector<int> labels;
    const Status status = internal::boundary_triangles(mesh, points, ERROR_BOUNDARY_MAP, triangles);
    if (!status.ok()) return status;
    for (Facet_index f : mesh.boundary_facets()) labels.push_back(class_of(mesh.label(f)));
    surface.emplace(std::move(triangles), std::move(labels));
    return {};
  }

  Status check_images(const Mesh& mesh) const {
    for (Facet_index f : mesh.boundary_facets())
      for (Vertex_index v : mesh.vertices(f)) {
        if (v >= number_of_given(mesh)) continue;
        if (v >= m_images.size())
          return {ERROR_BOUNDARY_MAP, "vertex " + std::to_string(v) + " has no image"};
        if (!internal::has_finite_coordinates(m_images[v]))
          return {ERROR_COORDINATE_NOT_FINITE, "the image of vertex " + std::to_string(v)};
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
