// Solves the linear systems with the user's own model of SparseLinearAlgebraWithFactorTraits_d.

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_vector.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>

#include <Eigen/IterativeLinearSolvers>

#include <cstdlib>
#include <iostream>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Biconjugate gradients with an incomplete LU factorization, and a word about each system. The matrices of the package are
// symmetric and positive definite.
class Talkative_solver_traits {
public:
  // 1. Name the types of matrices and vectors: here CGAL's wrappers of those of Eigen.
  using NT = double;
  using Matrix = CGAL::Eigen_sparse_matrix<double>;
  using Vector = CGAL::Eigen_vector<double>;

  // 2. Prepare for a matrix. Solutions are to be divided by `denominator`.
  bool factor(const Matrix& matrix, NT& denominator) {
    denominator = 1;
    m_solver.setTolerance(1e-14);
    m_solver.compute(matrix.eigen_object());
    return m_solver.info() == Eigen::Success;
  }

  // 3. Solve for a right-hand side.
  bool linear_solver(const Vector& right, Vector& solution) {
    solution = m_solver.solve(right);
    std::cout << right.dimension() << " unknowns, " << m_solver.iterations() << " iterations\n";
    return m_solver.info() == Eigen::Success;
  }

  // 4. Do both.
  bool linear_solver(const Matrix& matrix, const Vector& right, Vector& solution, NT& denominator) {
    return factor(matrix, denominator) && linear_solver(right, solution);
  }

private:
  Eigen::BiCGSTAB<Matrix::EigenType, Eigen::IncompleteLUT<double>> m_solver;
};

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/block_with_hole.mesh";
  VMP::Tetrahedron_soup_3<Kernel::Point_3> soup;
  VMP::Status status = VMP::IO::read_MEDIT(filename, soup);
  if (!status.ok()) return fail(status);

  // 5. Name the solver where the parameterizer is declared. A solution that is too bad would be refused:
  // ERROR_CANNOT_SOLVE.
  VMP::Direct_product_parameterizer_3<Kernel, Talkative_solver_traits> result;
  status = VMP::parameterize(soup, result);
  if (!status.ok()) return fail(status);
  std::cout << "relative residual of the harmonic function: " << result.harmonic_function()->residual()
            << std::endl;
  return EXIT_SUCCESS;
}
