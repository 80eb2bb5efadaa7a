// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MODEL_TETRAHEDRA_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MODEL_TETRAHEDRA_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// What the images of tetrahedra are to resemble: the tetrahedra at rest, or these deformed as their surroundings are now.
enum class Model_shape { AT_REST, AS_AROUND };

using Vertex_quadruple = std::array<std::uint32_t, 4>;

// The edges from the first vertex, as columns.
inline Eigen::Matrix3d edges_from_first(const Vertex_quadruple& cell, const std::vector<Eigen::Vector3d>& p) {
  Eigen::Matrix3d e;
  for (int k = 0; k < 3; ++k) e.col(k) = p[cell[k + 1]] - p[cell[0]];
  return e;
}

// A sliver would weigh more than all others together: a regular tetrahedron of the same size is its model.
inline Eigen::Matrix3d edges_at_rest(const Vertex_quadruple& cell, const std::vector<Eigen::Vector3d>& rest) {
  constexpr double least_volume = 1e-6; // of the cube of the longest edge; 0.71 for a regular one
  const Eigen::Matrix3d e = edges_from_first(cell, rest);
  const double longest = std::sqrt(e.colwise().squaredNorm().maxCoeff());
  if (e.determinant() > least_volume * longest * longest * longest) return e;
  Eigen::Matrix3d regular;
  regular << 1, .5, .5, 0, std::sqrt(.75), std::sqrt(1. / 12), 0, 0, std::sqrt(2. / 3);
  return longest * regular;
}

// Makes the volume at rest that of the images; 1 where these are turned over.
inline double scale_to_images(const std::vector<Vertex_quadruple>& cells,
                              const std::vector<Eigen::Vector3d>& rest,
                              const std::vector<Eigen::Vector3d>& images) {
  double image_volume = 0, rest_volume = 0;
  for (const Vertex_quadruple& c : cells) {
    image_volume += edges_from_first(c, images).determinant();
    rest_volume += edges_from_first(c, rest).determinant();
  }
  return image_volume > 0 ? std::cbrt(image_volume / rest_volume) : 1;
}

/*
The mean of the Jacobians around each tetrahedron, weighted with volumes at rest. Summed over a region, a Jacobian depends on the
image of the region's boundary only, thus little on what is flipped inside.
*/
inline std::vector<Eigen::Matrix3d> mean_jacobians(const std::vector<Vertex_quadruple>& cells,
                                                   const std::vector<Eigen::Vector3d>& rest,
                                                   const std::vector<Eigen::Vector3d>& images) {
  constexpr int sweeps = 100; // about ten rings
  const std::size_t n = cells.size();
  std::vector<double> volumes(n), weights(rest.size(), 0);
  std::vector<Eigen::Matrix3d> means(n, Eigen::Matrix3d::Zero()), at_vertices(rest.size());
  for (std::size_t c = 0; c < n; ++c) {
    const Eigen::Matrix3d e = edges_from_first(cells[c], rest);
    volumes[c] = (std::max)(e.determinant(), 0.);
    if (volumes[c] > 0) means[c] = edges_from_first(cells[c], images) * e.inverse();
    for (std::uint32_t v : cells[c]) weights[v] += volumes[c];
  }
  for (int k = 0; k < sweeps; ++k) {
    std::fill(at_vertices.begin(), at_vertices.end(), Eigen::Matrix3d::Zero());
    for (std::size_t c = 0; c < n; ++c)
      for (std::uint32_t v : cells[c])
        if (weights[v] > 0) at_vertices[v] += volumes[c] / weights[v] * means[c];
    for (std::size_t c = 0; c < n; ++c) {
      means[c].setZero();
      for (std::uint32_t v : cells[c]) means[c] += at_vertices[v] / 4;
    }
  }
  return means;
}

// The positive matrix closest to a Jacobian, no flatter than 0.3; none if the Jacobian is zero.
inline Eigen::Matrix3d positive_deformation(const Eigen::Matrix3d& jacobian, double scale) {
  constexpr double flattest = 0.3;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d stretches = svd.singularValues();
  if (!(stretches[0] > 0)) return scale * Eigen::Matrix3d::Identity();
  Eigen::Matrix3d u = svd.matrixU();
  if (u.determinant() * svd.matrixV().determinant() < 0) {
    u.col(2) *= -1;
    stretches[2] = 0;
  }
  stretches = stretches.cwiseMax(flattest * stretches[0]);
  return u * stretches.asDiagonal() * svd.matrixV().transpose();
}

// The edges from the first vertex of the model of each tetrahedron, as columns. `rest`, `images`: of all vertices
inline std::vector<Eigen::Matrix3d> model_tetrahedra(const std::vector<Vertex_quadruple>& cells,
                                                     const std::vector<Eigen::Vector3d>& rest,
                                                     const std::vector<Eigen::Vector3d>& images,
                                                     Model_shape shape) {
  const double scale = scale_to_images(cells, rest, images);
  std::vector<Eigen::Matrix3d> deformations(cells.size(), scale * Eigen::Matrix3d::Identity());
  if (shape == Model_shape::AS_AROUND) {
    deformations = mean_jacobians(cells, rest, images);
    for (Eigen::Matrix3d& d : deformations) d = positive_deformation(d, scale);
  }
  for (std::size_t c = 0; c < cells.size(); ++c) deformations[c] *= edges_at_rest(cells[c], rest);
  return deformations;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MODEL_TETRAHEDRA_H
