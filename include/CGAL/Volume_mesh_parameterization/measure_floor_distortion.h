// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_FLOOR_DISTORTION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_FLOOR_DISTORTION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Floor_map_2.h>
#include <CGAL/Volume_mesh_parameterization/Weighted_statistics.h>

#include <CGAL/number_utils.h>

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationVerification

sums up the distortion of a map of the floor into the plane, weighted by area. All images are scaled by one factor first,
so that the total area is kept.
*/
struct Floor_distortion_report {
  double scale = 1; ///< that factor
  Weighted_statistics greatest_singular_value; ///< of the Jacobian
  Weighted_statistics least_singular_value;    ///< of the Jacobian
  /// \f$ \sum_i \sigma_i^2 + \sigma_i^{-2} \f$, 4 for an isometry
  Weighted_statistics symmetric_dirichlet_energy;
};

namespace internal {

// Columns: the edges from corner 0 of a triangle of the refined floor to the others, in an orthonormal frame of its plane;
// 0 for a flat triangle.
template <typename GeomTraits>
Eigen::Matrix2d edges_on_floor(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                               const Floor_map_2<GeomTraits>& map, std::size_t t) {
  Eigen::Matrix3d corners = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Base_point_3<GeomTraits> corner = map.corner(t, i);
    const auto v = mesh.vertices(corner.facet);
    for (int k = 0; k < 3; ++k) {
      const auto p = approximate(mesh.point(v[k]));
      corners.col(i) += CGAL::to_double(corner.barycentric[k]) * Eigen::Vector3d(p.x(), p.y(), p.z());
    }
  }
  const Eigen::Vector3d a = corners.col(1) - corners.col(0), b = corners.col(2) - corners.col(0);
  const double length = a.norm();
  if (length == 0) return Eigen::Matrix2d::Zero();
  Eigen::Matrix2d edges;
  edges << length, a.dot(b) / length, 0, a.cross(b).norm() / length;
  return edges;
}

template <typename GeomTraits>
Eigen::Matrix2d edges_in_plane(const Floor_map_2<GeomTraits>& map, std::size_t t) {
  const auto& v = map.triangle(t);
  Eigen::Matrix2d edges;
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 2; ++k)
      edges(k, i) = CGAL::to_double(map.image(v[i + 1])[k]) - CGAL::to_double(map.image(v[0])[k]);
  return edges;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationVerification

measures the distortion of the map of the floor of `mesh`, in \f$ O(n \log n) \f$. Flat triangles of the floor do not count.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\pre `map` has been built for `mesh`
*/
template <typename GeomTraits>
Floor_distortion_report measure_floor_distortion(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                                                 const Floor_map_2<GeomTraits>& map) {
  std::vector<Eigen::Matrix2d> edges, images;
  std::vector<double> areas, greatest, least, energies;
  double area = 0, image_area = 0;
  for (std::size_t t = 0; t < map.number_of_triangles(); ++t) {
    const Eigen::Matrix2d on_floor = internal::edges_on_floor(mesh, map, t);
    if (!(on_floor.determinant() > 0)) continue;
    edges.push_back(on_floor);
    images.push_back(internal::edges_in_plane(map, t));
    areas.push_back(on_floor.determinant() / 2);
    area += areas.back();
    image_area += images.back().determinant() / 2;
  }
  Floor_distortion_report report;
  report.scale = std::sqrt(area / image_area);
  for (std::size_t t = 0; t < edges.size(); ++t) {
    const Eigen::Matrix2d jacobian = report.scale * images[t] * edges[t].inverse();
    const Eigen::Vector2d s = jacobian.jacobiSvd().singularValues();
    greatest.push_back(s[0]);
    least.push_back(s[1]);
    energies.push_back(s.squaredNorm() + s.cwiseInverse().squaredNorm());
  }
  report.greatest_singular_value = Weighted_statistics(greatest, areas);
  report.least_singular_value = Weighted_statistics(least, areas);
  report.symmetric_dirichlet_energy = Weighted_statistics(energies, areas);
  return report;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_FLOOR_DISTORTION_H
