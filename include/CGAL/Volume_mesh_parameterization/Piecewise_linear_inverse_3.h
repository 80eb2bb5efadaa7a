// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PIECEWISE_LINEAR_INVERSE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PIECEWISE_LINEAR_INVERSE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Cell_locator_3.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_map_3.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

takes points of a domain back to the solid by a piecewise linear bijection.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Piecewise_linear_inverse_3 {
public:
  using Map = Piecewise_linear_map_3<GeomTraits>;      ///< the map that is inverted
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>; ///< the type of the refined solid
  using Location = Location_3<GeomTraits>;             ///< a point of the solid
  using Point_2 = typename GeomTraits::Point_2;        ///< the point type of the plane
  using Point_3 = typename GeomTraits::Point_3;        ///< the point type

  Piecewise_linear_inverse_3() = default;
  Piecewise_linear_inverse_3(const Piecewise_linear_inverse_3&) = delete;
  Piecewise_linear_inverse_3& operator=(const Piecewise_linear_inverse_3&) = delete;

  /// prepares the search for tetrahedra, and keeps a reference to the mesh of `map`. Complexity: \f$ O(n \log n) \f$.
  /// \pre `map.is_valid()`
  Status build(const Map& map) { return build(map.mesh(), map.images()); }

  /// prepares the search for tetrahedra of a map that is known by its images, and keeps a reference to `solid`. Complexity:
  /// \f$ O(n \log n) \f$.
  /// \pre `verify_map(solid, images).is_bijective()`
  Status build(const Mesh& solid, const std::vector<Point_3>& images) {
    Tetrahedron_soup_3<Point_3> soup = make_soup(solid);
    soup.points = images;
    m_solid = &solid;
    const Status status = m_domain.assign(soup);
    if (status.ok()) m_locator.emplace(m_domain);
    return status;
  }

  /// finds the place of the preimage of `q` in the mesh of the map.
  /// \pre `build()` has succeeded
  /// \returns `ERROR_OUTSIDE` if `q` is not in the domain. Complexity: \f$ O(\log n) \f$ in meshes of well shaped cells.
  Status preimage(const Point_3& q, Location& result) const { return m_locator->locate(q, result); }

  /// appends the preimages of the points over `foot` at these shares of `height`. With a prism's height, this is a column of
  /// `hexahedral_mesh()`.
  /// \pre `build()` has succeeded
  /// \returns `ERROR_OUTSIDE`; then points before the failure are appended
  Status column(const Point_2& foot, double height, const std::vector<double>& shares,
                std::vector<Point_3>& points) const {
    for (double share : shares) {
      Location place;
      const Status status = preimage(Point_3(foot.x(), foot.y(), share * height), place);
      if (!status.ok()) return status;
      points.push_back(place.point(*m_solid));
    }
    return {};
  }

private:
  const Mesh* m_solid = nullptr;
  Mesh m_domain;
  std::optional<Cell_locator_3<GeomTraits>> m_locator;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PIECEWISE_LINEAR_INVERSE_3_H
