// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PETSC_SOLVER_TRAITS_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PETSC_SOLVER_TRAITS_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#if defined(CGAL_VOLUME_MESH_PARAMETERIZATION_USE_PETSC) || defined(DOXYGEN_RUNNING)

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_vector.h>

#include <Eigen/SparseCore>

#include <petscksp.h>

#include <memory>
#include <mutex>
#include <type_traits>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {

// PETSc, and MPI below it, from the first use to the end of the program; left alone if the program itself started it.
class Petsc_session {
public:
  static bool is_running() {
    static const Petsc_session session;
    return session.m_is_running;
  }

  // PETSc keeps records that are not safe for threads.
  static std::mutex& mutex() {
    static std::mutex the_mutex;
    return the_mutex;
  }

private:
  Petsc_session() {
    PetscBool is_running = PETSC_FALSE;
    PetscInitialized(&is_running);
    m_is_running = is_running;
    if (m_is_running) return;
    PetscOptionsSetValue(nullptr, "-no_signal_handler", "true"); // signals belong to the program
    m_is_running = m_is_ours = PetscInitializeNoArguments() == 0;
    PetscPushErrorHandler(PetscReturnErrorHandler, nullptr); // failures are returned, not printed
  }
  ~Petsc_session() {
    if (m_is_ours) PetscFinalize();
  }

  bool m_is_running = false;
  bool m_is_ours = false;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationFields

solves the linear systems of the fields by PETSc's method of conjugate gradients, preconditioned by algebraic multigrid;
exists if `CGAL_VOLUME_MESH_PARAMETERIZATION_USE_PETSC` is defined.

The number of iterations hardly grows with the mesh. A solution takes \f$ O(n) \f$ time and memory. Options of PETSc, such
as `-pc_gamg_threshold`, are taken from its database, hence also from the environment variable `PETSC_OPTIONS`.

PETSc, and MPI with it, is started by the first system, unless the program has done so, and runs in one process. Several
threads may solve at a time, but wait for each other.

\cgalModels{SparseLinearAlgebraWithFactorTraits_d}
*/
class Petsc_solver_traits_3 {
public:
  using NT = double;                                ///< the number type
  using Matrix = CGAL::Eigen_sparse_matrix<double>; ///< of which the lower half counts
  using Vector = CGAL::Eigen_vector<double>;        ///< a dense vector

  /// is the relative residual to reach: all digits that there are.
  static constexpr double tolerance = 1e-15;
  /// is a bound against systems that are not positive definite.
  static constexpr int maximal_number_of_iterations = 1000;

  /// \param preconditioner a name of one of PETSc's preconditioners for symmetric matrices, such as `PCHYPRE`
  explicit Petsc_solver_traits_3(const char* preconditioner = PCGAMG) : m_preconditioner(preconditioner) {}

  /// sets up the preconditioner for a positive definite matrix, of which the lower half is copied. Solutions are to be
  /// divided by `denominator`, which becomes 1.
  /// \returns whether PETSc succeeded
  bool factor(const Matrix& matrix, NT& denominator) {
    denominator = 1;
    m_state.reset(); // which locks, too
    const std::lock_guard<std::mutex> lock(internal::Petsc_session::mutex());
    m_state.reset(new State);
    m_state->matrix = matrix.eigen_object().template selfadjointView<Eigen::Lower>();
    return internal::Petsc_session::is_running() && create_solver() && succeeds(KSPSetUp(m_state->solver));
  }

  /// solves for another right-hand side; `solution` is resized.
  /// \pre `factor()` has succeeded
  /// \returns whether the residual became small
  bool linear_solver(const Vector& right, Vector& solution) {
    const std::lock_guard<std::mutex> lock(internal::Petsc_session::mutex());
    solution.setZero(right.dimension());
    const PetscInt n = right.dimension();
    Vec b = nullptr, x = nullptr;
    const bool is_solved =
        succeeds(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, right.eigen_object().data(), &b)) &&
        succeeds(VecCreateSeqWithArray(PETSC_COMM_SELF, 1, n, solution.data(), &x)) &&
        succeeds(KSPSolve(m_state->solver, b, x)) && has_converged();
    VecDestroy(&b);
    VecDestroy(&x);
    return is_solved;
  }

  /// sets up and solves.
  bool linear_solver(const Matrix& matrix, const Vector& right, Vector& solution, NT& denominator) {
    return factor(matrix, denominator) && linear_solver(right, solution);
  }

  /// returns how many steps the last solution took.
  /// \pre `factor()` has succeeded
  int number_of_iterations() const {
    PetscInt number = 0;
    KSPGetIterationNumber(m_state->solver, &number);
    return number;
  }

private:
  // As the matrix is symmetric, its compressed columns are the compressed rows that PETSc wants: it works on these arrays.
  struct State {
    using Sparse_matrix = Matrix::EigenType;
    static_assert(std::is_same<PetscScalar, double>::value,
                  "PETSc must be one for real numbers in double precision");
    static_assert(std::is_same<PetscInt, Sparse_matrix::StorageIndex>::value,
                  "PETSc must be one with 32-bit indices");

    ~State() {
      const std::lock_guard<std::mutex> lock(internal::Petsc_session::mutex());
      KSPDestroy(&solver);
    }

    Sparse_matrix matrix;
    KSP solver = nullptr;
  };

  static bool succeeds(PetscErrorCode error) { return error == 0; }

  bool create_solver() {
    auto& sparse = m_state->matrix;
    const PetscInt n = PetscInt(sparse.rows());
    KSP& solver = m_state->solver;
    Mat matrix = nullptr;
    PC preconditioner = nullptr;
    const bool is_created =
        succeeds(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, sparse.outerIndexPtr(),
                                           sparse.innerIndexPtr(), sparse.valuePtr(), &matrix)) &&
        succeeds(MatSetOption(matrix, MAT_SPD, PETSC_TRUE)) &&
        succeeds(KSPCreate(PETSC_COMM_SELF, &solver)) && succeeds(KSPSetOperators(solver, matrix, matrix)) &&
        succeeds(KSPSetType(solver, KSPCG)) && succeeds(KSPSetNormType(solver, KSP_NORM_UNPRECONDITIONED)) &&
        succeeds(KSPGetPC(solver, &preconditioner)) &&
        succeeds(PCSetType(preconditioner, m_preconditioner)) &&
        succeeds(KSPSetTolerances(solver, tolerance, PETSC_DEFAULT, PETSC_DEFAULT,
                                  maximal_number_of_iterations)) &&
        succeeds(KSPSetFromOptions(solver));
    MatDestroy(&matrix); // the solver keeps a reference
    return is_created;
  }

  bool has_converged() const {
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    return succeeds(KSPGetConvergedReason(m_state->solver, &reason)) && reason > 0;
  }

  const char* m_preconditioner;
  std::unique_ptr<State> m_state;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_USE_PETSC

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PETSC_SOLVER_TRAITS_3_H
