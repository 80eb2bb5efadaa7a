#undef NDEBUG
#include <CGAL/Volume_mesh_parameterization/Default_solver_traits_3.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Matrix = VMP::Multigrid_solver_traits_3::Matrix;
using Vector = VMP::Multigrid_solver_traits_3::Vector;

// The Laplacian of a grid of n^3 points, `ratios` times stronger along each axis, with zeros beyond two opposite sides.
Matrix grid_laplacian(int n, const std::array<double, 3>& ratios) {
  Matrix matrix(n * n * n);
  const int steps[3] = {1, n, n * n};
  for (int i = 0; i < n * n * n; ++i)
    for (int axis = 0; axis < 3; ++axis)
      for (int side : {-1, 1}) {
        const int place = i / steps[axis] % n + side;
        const bool is_inside = 0 <= place && place < n;
        if (is_inside) matrix.add_coef(i, i + side * steps[axis], -ratios[axis]);
        if (is_inside || axis == 2) matrix.add_coef(i, i, ratios[axis]);
      }
  return matrix;
}

Vector wavy(int n) {
  Vector result(n);
  for (int i = 0; i < n; ++i) result[i] = std::sin(0.7 * i) + 0.1;
  return result;
}

template <typename Solver>
Vector solved(const Matrix& matrix, const Vector& right) {
  Solver solver;
  Vector solution(int(right.dimension()));
  double denominator = 0;
  const bool success = solver.factor(matrix, denominator) && solver.linear_solver(right, solution);
  assert(success && denominator == 1);
  return solution;
}

double difference(const Vector& a, const Vector& b) { return (a - b).norm() / b.norm(); }

// Several levels, one level, equal and unequal weights: all solvers give the same.
void test_solvers_agree(int n, const std::array<double, 3>& ratios) {
  const Matrix matrix = grid_laplacian(n, ratios);
  const Vector right = wavy(n * n * n);
  const Vector expected = solved<VMP::Simplicial_solver_traits_3>(matrix, right);
  const Vector x = solved<VMP::Multigrid_solver_traits_3>(matrix, right);
  std::cout << n << "^3 unknowns: " << difference(x, expected) << std::endl;
  assert(difference(x, expected) < 1e-10);
  assert(x == solved<VMP::Multigrid_solver_traits_3>(matrix, right)); // to the bit
}

// The cycle is symmetric and positive definite, else it would not do for conjugate gradients; and it contracts the error.
void test_cycle() {
  const int n = 10;
  const Matrix matrix = grid_laplacian(n, {1, 2, 3});
  const auto& m = matrix.eigen_object();
  VMP::internal::Smoothed_aggregation cycle({m.outerIndexPtr(), m.innerIndexPtr(), m.valuePtr(), int(m.rows())});
  const Eigen::VectorXd a = wavy(n * n * n), b = a.array().square() - 0.3;
  const Eigen::VectorXd image_of_a = cycle(a), image_of_b = cycle(b);
  assert(std::abs(a.dot(image_of_b) / b.dot(image_of_a) - 1) < 1e-12);
  assert(a.dot(image_of_a) > 0 && b.dot(image_of_b) > 0);
  Eigen::VectorXd error = a;
  for (int k = 0; k < 5; ++k) {
    const double before = error.dot(m * error);
    error -= cycle(m * error);
    assert(error.dot(m * error) < 0.25 * before);
  }
}

// Nothing to put together, weak and positive couplings, one unknown: no aggregates, or odd ones.
void test_odd_matrices() {
  Matrix diagonal(1000), positive(1000), single(1);
  single.add_coef(0, 0, 4);
  for (int i = 0; i < 1000; ++i) {
    diagonal.add_coef(i, i, i + 1);
    positive.add_coef(i, i, 3);
    if (i > 0) positive.add_coef(i, i - 1, i % 3 == 0 ? -1e-3 : 1.4);
    if (i < 999) positive.add_coef(i, i + 1, i % 3 == 2 ? -1e-3 : 1.4);
  }
  for (const Matrix* matrix : {&diagonal, &positive, &single}) {
    const Vector right = wavy(int(matrix->row_dimension()));
    const Vector x = solved<VMP::Multigrid_solver_traits_3>(*matrix, right);
    assert((matrix->eigen_object() * x - right).norm() < 1e-12 * right.norm());
  }
  Vector zero(1000);
  zero.setZero();
  assert(solved<VMP::Multigrid_solver_traits_3>(diagonal, zero).norm() == 0);
}

// What is not positive definite ends, without success.
void test_refusals() {
  VMP::Multigrid_solver_traits_3 solver;
  for (double bad : {-1., 0., std::numeric_limits<double>::quiet_NaN()}) {
    Matrix matrix(300);
    for (int i = 0; i < 300; ++i) matrix.add_coef(i, i, i == 150 ? bad : 1);
    Vector solution(300);
    double denominator;
    const bool success = solver.linear_solver(matrix, wavy(300), solution, denominator);
    assert(bad < 0 || !success); // a diagonal matrix with both signs is solved in spite of them
  }
}

int main() {
  test_solvers_agree(4, {1, 1, 1});
  test_solvers_agree(16, {1, 1, 1});
  test_solvers_agree(16, {1, 10, 0.01});
  test_solvers_agree(14, {1e12, 1e12, 1e12});
  test_cycle();
  test_odd_matrices();
  test_refusals();
  std::cout << "done\n";
  return EXIT_SUCCESS;
}
