// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DEFAULT_SOLVER_TRAITS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DEFAULT_SOLVER_TRAITS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Smoothed_aggregation.h>
#include <CGAL/Volume_mesh_parameterization/internal/Sparse_rows.h>
#include <CGAL/Volume_mesh_parameterization/internal/solve_by_conjugate_gradients.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/tags.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <memory>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationFields

solves the linear systems of the fields by Eigen's method of conjugate gradients, which is faster and smaller than a
factorization from some ten thousand unknowns on; the number of iterations grows with that of the cells.

\cgalModels{SparseLinearAlgebraWithFactorTraits_d}

\tparam Preconditioner a preconditioner of Eigen
*/
template <typename Preconditioner = Eigen::DiagonalPreconditioner<double>>
class Conjugate_gradient_traits_3
    : public CGAL::Eigen_solver_traits<Eigen::ConjugateGradient<CGAL::Eigen_sparse_matrix<double>::EigenType,
                                                                Eigen::Lower, Preconditioner>> {
public:
  /// is the relative residual to reach. The recurrence of the method goes on below the rounding errors of the
  /// solution itself, so this asks for all digits that there are.
  static constexpr double tolerance = 1e-15;
  /// is a bound against systems that are not positive definite: a million cells need about two thousand.
  static constexpr int maximal_number_of_iterations = 20000;

  /// sets the tolerance, a relative residual.
  Conjugate_gradient_traits_3() {
    this->solver().setTolerance(tolerance);
    this->solver().setMaxIterations(maximal_number_of_iterations);
  }
};

/*!
\ingroup PkgVolumeMeshParameterizationFields

solves the linear systems of the fields by the method of conjugate gradients, preconditioned by algebraic multigrid (smoothed
aggregation; Vanek, Mandel and Brezina 1996): the number of iterations hardly grows with that of the unknowns.

\cgalModels{SparseLinearAlgebraWithFactorTraits_d}

Matrices must be symmetric and positive definite, with both halves stored.
*/
class Multigrid_solver_traits_3 {
public:
  using NT = double;                                ///< the number type
  using Matrix = CGAL::Eigen_sparse_matrix<double>; ///< by rows, both halves stored
  using Vector = CGAL::Eigen_vector<double>;        ///< a dense vector

  /// is the relative residual to reach: all digits that there are, as for `Conjugate_gradient_traits_3`.
  static constexpr double tolerance = 1e-15;
  /// is a bound against systems that are not positive definite: millions of cells need about thirty.
  static constexpr int maximal_number_of_iterations = 1000;

  /// prepares to solve systems with this matrix, which must live as long as they are solved.
  bool factor(const Matrix& matrix, NT& denominator) {
    denominator = 1;
    const auto& m = matrix.eigen_object();
    m_matrix = {m.outerIndexPtr(), m.innerIndexPtr(), m.valuePtr(), int(m.rows())};
    m_preconditioner = std::make_shared<internal::Smoothed_aggregation>(m_matrix);
    return true;
  }

  /// solves for one right-hand side.
  /// \pre `factor()` has been called
  bool linear_solver(const Vector& right, Vector& solution) {
    bool is_solved = iterate(right, solution);
    for (int k = 0; k < most_refinements; ++k) {
      const Vector rest = residual(right, solution);
      if (rest.norm() <= refined_residual * right.norm()) break;
      Vector correction(int(right.size()));
      is_solved = iterate(rest, correction);
      solution += correction;
    }
    return is_solved;
  }

  /// prepares and solves.
  bool linear_solver(const Matrix& matrix, const Vector& right, Vector& solution, NT& denominator) {
    return factor(matrix, denominator) && linear_solver(right, solution);
  }

private:
  // Where cells are thin, entries of very different sizes let the residual of the method drift away from the true one. If it
  // has drifted farther than this, what is left is solved for in turn.
  static constexpr double refined_residual = 1e-10;
  static constexpr int most_refinements = 3;

  bool iterate(const Vector& right, Vector& solution) {
    return internal::solve_by_conjugate_gradients<Sequential_tag>(m_matrix, *m_preconditioner, right, tolerance,
                                                                  maximal_number_of_iterations, solution);
  }

  Vector residual(const Vector& right, const Vector& solution) const {
    Vector result(right);
    for (int i = 0; i < m_matrix.size; ++i) result[i] -= m_matrix.times(i, solution);
    return result;
  }

  internal::Sparse_rows_view m_matrix;
  std::shared_ptr<internal::Smoothed_aggregation> m_preconditioner;
};

/// \ingroup PkgVolumeMeshParameterizationFields
/// is what the fields are solved with unless told otherwise.
using Default_solver_traits_3 = Multigrid_solver_traits_3;

/// \ingroup PkgVolumeMeshParameterizationFields
/// factorizes by Eigen's \f$ LDL^T \f$: nothing to install, best for small meshes.
using Simplicial_solver_traits_3 =
    CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType>>;

#if defined(CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD) || defined(DOXYGEN_RUNNING)
/// \ingroup PkgVolumeMeshParameterizationFields
/// factorizes by CHOLMOD; exists if `CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD` is defined.
using Cholmod_solver_traits_3 =
    CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<CGAL::Eigen_sparse_matrix<double>::EigenType>>;
#endif

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DEFAULT_SOLVER_TRAITS_3_H
