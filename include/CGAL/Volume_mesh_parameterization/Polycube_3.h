// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_POLYCUBE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_POLYCUBE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Base_point_3.h>
#include <CGAL/Volume_mesh_parameterization/Cell_locator_3.h>
#include <CGAL/Volume_mesh_parameterization/Direct_product_3.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/boundary_triangles.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>

#include <array>
#include <optional>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

is a polycube given by the user, with its own product structure: a point is given by the point of the floor that its curve
comes from, and its share of the level that the curve gains.

\cgalModels{ParameterDomain_3}

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Solver a model of `SparseLinearAlgebraWithFactorTraits_d`
*/
template <typename GeomTraits, typename Solver = Default_solver_traits_3>
class Polycube_3 {
public:
  using Geom_traits = GeomTraits;               ///< a model of `VolumeParameterizationTraits_3`
  using FT = typename GeomTraits::FT;           ///< the number type
  using Point_3 = typename GeomTraits::Point_3; ///< the point type
  using Floor_point = Base_point_3<GeomTraits>; ///< a point of the floor of the domain
  using Direct_product = Direct_product_3<GeomTraits, Solver>; ///< the type of the swept polycube

  /*!
  builds the product structure. The object may be used once.

  \tparam TetrahedralMesh a model of `TetrahedralMesh_3`
  \param mesh a handlebody whose boundary facets are orthogonal to the axes and labelled, and meet each other in common
  vertices and edges only
  \param np an optional sequence of named parameters, `visitor` and `level_function` of `parameterize()`

  \returns `ERROR_NOT_A_POLYCUBE`, or the errors of `Direct_product_3::build()`
  */
  template <typename TetrahedralMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Status build(const TetrahedralMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values()) {
    Status status = check_shape(mesh);
    if (status.ok()) status = m_product.build(mesh, np);
    if (status.ok()) m_locator.emplace(m_product.mesh());
    return status;
  }

  /// returns whether `build()` has succeeded.
  bool is_valid() const { return m_locator.has_value(); }

  /// returns the swept polycube.
  const Direct_product& product() const { return m_product; }
  /// returns the polycube with the splits that the sweep needed.
  const Compact_tetrahedral_mesh_3<GeomTraits>& mesh() const { return m_product.mesh(); }

  /// computes the curve that starts at `foot`.
  Status curve_over(const Floor_point& foot, Integral_curve_3<GeomTraits>& curve) const {
    return m_product.curves().trace_curve(foot, curve);
  }

  /// computes the point of the curve from `foot` at which the share `w` of the level is gained.
  Status point(const Floor_point& foot, const FT& w, Point_3& result) const {
    Integral_curve_3<GeomTraits> curve;
    const Status status = curve_over(foot, curve);
    if (status.ok()) result = curve.at(w * curve.total_level()).point(mesh());
    return status;
  }

  /// computes the foot of the curve through `p`, and the share of the level that the curve has gained there.
  /// \returns `ERROR_OUTSIDE`
  Status locate(const Point_3& p, Floor_point& foot, FT& w) const {
    Location_3<GeomTraits> at;
    Floor_point top;
    FT below, above;
    Status status = m_locator->locate(p, at);
    if (status.ok()) status = m_product.curves().trace_to_base(at, DOWN, foot, below);
    if (status.ok()) status = m_product.curves().trace_to_base(at, UP, top, above);
    if (status.ok()) w = below / (below + above);
    return status;
  }

private:
  template <typename TetrahedralMesh>
  static Status check_shape(const TetrahedralMesh& mesh) {
    Compact_tetrahedral_mesh_3<GeomTraits> copy;
    std::vector<std::array<Point_3, 3>> boundary;
    Status status = copy.assign(mesh);
    if (status.ok()) status = check_tetrahedral_mesh(copy);
    if (status.ok())
      status = internal::boundary_triangles<GeomTraits>(copy, copy.points(), ERROR_NOT_A_POLYCUBE, boundary);
    return status.ok() ? check_embedding(copy) : status;
  }

  // Else a point of space would have several places in the polycube.
  static Status check_embedding(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
    const Status status = verify_map(mesh, mesh.points()).status;
    const bool meets_itself = status.code() == ERROR_MAP_NOT_BIJECTIVE;
    return meets_itself ? Status(ERROR_NOT_A_POLYCUBE, "it meets itself: " + status.detail()) : status;
  }

  Direct_product m_product;
  std::optional<Cell_locator_3<GeomTraits>> m_locator;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_POLYCUBE_3_H
