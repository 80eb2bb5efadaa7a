// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVE_BY_CONJUGATE_GRADIENTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVE_BY_CONJUGATE_GRADIENTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// solves matrix * solution = right from 0 on (Hestenes and Stiefel 1952), until the norm of the residual that the method
// itself keeps has fallen to `tolerance` times that of `right`. Returns whether it has. A matrix has a size, and a function
// times(i, x) that returns the product of its row i with a vector.
template <typename ConcurrencyTag, typename Matrix, typename Preconditioner>
bool solve_by_conjugate_gradients(const Matrix& matrix, Preconditioner& precondition, const Eigen::VectorXd& right,
                                  double tolerance, int maximal_number_of_iterations, Eigen::VectorXd& solution) {
  solution.setZero(right.size());
  Eigen::VectorXd residual = right, direction = precondition(residual), image(right.size());
  constexpr std::size_t rows_per_block = 8192;
  const double goal = tolerance * right.norm();
  double energy = residual.dot(direction);
  for (int k = 0; k < maximal_number_of_iterations && !(residual.norm() <= goal); ++k) {
    for_each_index<ConcurrencyTag>(
        std::size_t(matrix.size), [&](std::size_t row) { image[int(row)] = matrix.times(int(row), direction); }, rows_per_block);
    const double step = energy / direction.dot(image);
    solution += step * direction;
    residual -= step * image;
    const auto& preconditioned = precondition(residual);
    const double next_energy = residual.dot(preconditioned);
    direction = preconditioned + next_energy / energy * direction;
    energy = next_energy;
  }
  return residual.norm() <= goal;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SOLVE_BY_CONJUGATE_GRADIENTS_H
