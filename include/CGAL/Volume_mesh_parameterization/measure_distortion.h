// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_DISTORTION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_DISTORTION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Weighted_statistics.h>

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationVerification

is how a piecewise linear map distorts one tetrahedron.
*/
struct Cell_distortion {
  std::array<double, 3> singular_values = {}; ///< of the Jacobian, in decreasing order
  double volume_ratio = 0; ///< determinant of the Jacobian, negative if the tetrahedron is flipped
  /// \f$ \sum_i \sigma_i^2 + \sigma_i^{-2} \f$, 6 for an isometry, infinite if the tetrahedron is flipped or flat
  double symmetric_dirichlet_energy = 0;
};

/*!
\ingroup PkgVolumeMeshParameterizationVerification

sums up the distortion of a map, weighted by volume. All images are scaled by one factor first, so that the total
volume is kept.
*/
struct Distortion_report {
  double scale = 1; ///< that factor
  Weighted_statistics greatest_singular_value;    ///< of the Jacobian
  Weighted_statistics least_singular_value;       ///< of the Jacobian
  Weighted_statistics volume_ratio;               ///< of the image and the tetrahedron
  Weighted_statistics symmetric_dirichlet_energy; ///< 6 for an isometry, infinite for an inverted tetrahedron
};

namespace internal {

// Columns: the edges from vertex 0 to the others.
template <typename Point>
Eigen::Matrix3d edge_matrix(const std::vector<Point>& points, const std::array<Vertex_index, 4>& v) {
  const Double_kernel::Point_3 origin = approximate(points[v[0]]);
  Eigen::Matrix3d edges;
  for (int i = 0; i < 3; ++i) {
    const Double_kernel::Vector_3 e = approximate(points[v[i + 1]]) - origin;
    edges.col(i) << e.x(), e.y(), e.z();
  }
  return edges;
}

// Of the map that is linear on the cell and takes its vertices to their images; not finite if the cell is flat.
template <typename GeomTraits>
Eigen::Matrix3d jacobian(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                         const std::vector<typename GeomTraits::Point_3>& images, Cell_index c) {
  return edge_matrix(images, mesh.cell(c)) * edge_matrix(mesh.points(), mesh.cell(c)).inverse();
}

inline Cell_distortion distortion_of(const Eigen::Matrix3d& jacobian) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!jacobian.allFinite()) return {{infinity, infinity, infinity}, infinity, infinity};
  const Eigen::Vector3d s = jacobian.jacobiSvd().singularValues();
  const double determinant = jacobian.determinant();
  const double energy = s.squaredNorm() + s.cwiseInverse().squaredNorm();
  return {{s[0], s[1], s[2]}, determinant, determinant > 0 ? energy : infinity};
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationVerification

returns the signed volume of each tetrahedron of `mesh` when its vertices are moved to `points`.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\pre there is one point for each vertex
*/
template <typename GeomTraits>
std::vector<double> measure_volumes(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                                    const std::vector<typename GeomTraits::Point_3>& points) {
  std::vector<double> volumes;
  volumes.reserve(mesh.number_of_cells());
  for (Cell_index c : mesh.cells())
    volumes.push_back(internal::edge_matrix(points, mesh.cell(c)).determinant() / 6);
  return volumes;
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

returns the distortion of each tetrahedron under the piecewise linear map that takes vertex \f$ v \f$ to
`scale` times `images[v]`.
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\pre there is one image for each vertex
*/
template <typename GeomTraits>
std::vector<Cell_distortion> measure_cell_distortions(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                                                      const std::vector<typename GeomTraits::Point_3>& images,
                                                      double scale = 1) {
  std::vector<Cell_distortion> distortions;
  distortions.reserve(mesh.number_of_cells());
  for (Cell_index c : mesh.cells())
    distortions.push_back(internal::distortion_of(scale * internal::jacobian(mesh, images, c)));
  return distortions;
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

measures the distortion of the piecewise linear map that takes vertex \f$ v \f$ of `mesh` to `images[v]`, in
\f$ O(n \log n) \f$.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\pre there is one image for each vertex
*/
template <typename GeomTraits>
Distortion_report measure_distortion(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                                     const std::vector<typename GeomTraits::Point_3>& images) {
  const auto total = [](const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.); };
  const std::vector<double> volumes = measure_volumes(mesh, mesh.points());
  const double image_volume = total(measure_volumes(mesh, images));

  Distortion_report report;
  if (image_volume > 0) report.scale = std::cbrt(total(volumes) / image_volume);
  const std::vector<Cell_distortion> cells = measure_cell_distortions(mesh, images, report.scale);
  const auto statistics = [&](auto measure) {
    std::vector<double> values;
    values.reserve(cells.size());
    for (const Cell_distortion& d : cells) values.push_back(measure(d));
    return Weighted_statistics(values, volumes);
  };
  report.greatest_singular_value = statistics([](const Cell_distortion& d) { return d.singular_values[0]; });
  report.least_singular_value = statistics([](const Cell_distortion& d) { return d.singular_values[2]; });
  report.volume_ratio = statistics([](const Cell_distortion& d) { return d.volume_ratio; });
  report.symmetric_dirichlet_energy =
      statistics([](const Cell_distortion& d) { return d.symmetric_dirichlet_energy; });
  return report;
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

returns the angle in degrees between `first[c]` and `second[c]` for each \f$ c \f$. A vector that vanishes has no
direction: its angle is 180, so that no statistics hide it.

\tparam VectorRange1, VectorRange2 random access ranges of vectors with `operator[]` for the three coordinates
\pre the ranges have the same size
*/
template <typename VectorRange1, typename VectorRange2>
std::vector<double> measure_angles(const VectorRange1& first, const VectorRange2& second) {
  constexpr double degrees = 57.295779513082320877; // in a radian
  std::vector<double> angles;
  angles.reserve(first.size());
  for (std::size_t c = 0; c < first.size(); ++c) {
    Eigen::Vector3d a(first[c][0], first[c][1], first[c][2]), b(second[c][0], second[c][1], second[c][2]);
    a.stableNormalize(); // fluxes decay exponentially in dead ends
    b.stableNormalize();
    const bool both = !a.isZero(0) && !b.isZero(0);
    angles.push_back(both ? degrees * std::atan2(a.cross(b).norm(), a.dot(b)) : 180);
  }
  return angles;
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

returns for each tetrahedron the angle in degrees between two directions, under the linear map \f$ (u, v, w) \f$ that takes
vertex \f$ i \f$ of `mesh` to `images[i]`: that of the line along which \f$ u \f$ and \f$ v \f$ are constant, and that of the
gradient of \f$ w \f$. It is 0 where lines are orthogonal to iso-surfaces of \f$ w \f$, above 90 if the tetrahedron is flipped,
180 if it is flat.
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\pre there is one image for each vertex
*/
template <typename GeomTraits>
std::vector<double> measure_line_angles(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                                        const std::vector<typename GeomTraits::Point_3>& images) {
  std::vector<Eigen::Vector3d> lines, gradients;
  for (Cell_index c : mesh.cells()) {
    const Eigen::Matrix3d gradients_of_uvw = internal::jacobian(mesh, images, c).transpose();
    lines.push_back(gradients_of_uvw.col(0).cross(gradients_of_uvw.col(1)));
    gradients.push_back(gradients_of_uvw.col(2));
  }
  return measure_angles(lines, gradients);
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_DISTORTION_H
