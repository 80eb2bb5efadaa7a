#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/Flux_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>
#include <CGAL/Volume_mesh_parameterization/Petsc_solver_traits_3.h>

#include "test_util.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <thread>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Solver = VMP::Petsc_solver_traits_3;

Mesh mesh_of(const Soup& soup) {
  Mesh mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  return mesh;
}

// a block in which no linear function is the solution
Mesh wedge(int holes) {
  return mesh_of(
      transformed(jitter_interior(Block_with_holes<Point>(holes, 3, 6).soup(), 0.05, 3), [](const Point& p) {
        return Point(p.x() + 0.3 * p.z() * p.z(), p.y(), p.z() * (1 + 0.4 * p.x() + 0.1 * p.y() * p.y()));
      }));
}

template <template <typename, typename> class Field, typename Solver_ = Solver>
Field<Mesh, Solver_> solved(const Mesh& mesh) {
  Field<Mesh, Solver_> field(mesh);
  const VMP::Status status = field.solve();
  assert(status.ok() && field.residual() < 1e-12);
  return field;
}

template <template <typename, typename> class Field>
Field<Mesh, VMP::Default_solver_traits_3> expected(const Mesh& mesh) {
  return solved<Field, VMP::Default_solver_traits_3>(mesh);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  assert(a.size() == b.size());
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference = std::max(difference, std::abs(a[i] - b[i]));
  return difference;
}

template <typename Field>
std::vector<double> fluxes(const Mesh& mesh, const Field& field) {
  std::vector<double> result;
  for (VMP::Facet_index f : mesh.facets()) result.push_back(field.flux(f));
  return result;
}

void test_linear_solution() {
  const double height = 1.7;
  const Mesh mesh = mesh_of(jitter_interior(Block_with_holes<Point>(2, 4, 5, height).soup(), 0.06, 7));
  const auto f = solved<VMP::Harmonic_function_3>(mesh);
  double error = 0;
  for (VMP::Vertex_index v : mesh.vertices())
    error = std::max(error, std::abs(f(v) - mesh.point(v).z() / height));
  std::cout << "error of a linear function: " << error << '\n';
  assert(error < 1e-12);
}

void test_agrees_with_default(int holes) {
  const Mesh mesh = wedge(holes);
  const auto f = solved<VMP::Harmonic_function_3>(mesh);
  assert(largest_difference(f.values(), expected<VMP::Harmonic_function_3>(mesh).values()) < 1e-12);
  const auto potential = solved<VMP::Dual_potential_3>(mesh);
  assert(largest_difference(potential.values(), expected<VMP::Dual_potential_3>(mesh).values()) < 1e-12);
  const std::vector<double> flux = fluxes(mesh, solved<VMP::Flux_field_3>(mesh));
  const double largest = *std::max_element(flux.begin(), flux.end());
  assert(largest_difference(flux, fluxes(mesh, expected<VMP::Flux_field_3>(mesh))) < 1e-11 * largest);
  assert(f.values() == solved<VMP::Harmonic_function_3>(mesh).values()); // to the bit
}

// Multigrid needs the same few steps for any size.
void test_number_of_iterations() {
  const auto steps_for = [](int n) { // a chain of n unknowns, both ends held
    Solver::Matrix matrix(n);
    for (int i = 0; i < n; ++i) {
      matrix.set_coef(i, i, 2);
      if (i > 0) matrix.set_coef(i, i - 1, -1);
    }
    Solver::Vector right(n), solution(n);
    for (int i = 0; i < n; ++i) right[i] = i + 1 == n;
    Solver solver;
    double denominator = 0;
    const bool is_solved = solver.linear_solver(matrix, right, solution, denominator);
    assert(is_solved && denominator == 1);
    for (int i = 0; i < n; ++i) assert(std::abs(solution[i] - (i + 1.) / (n + 1)) < 1e-9);
    return solver.number_of_iterations();
  };
  const int few = steps_for(1000), many = steps_for(16000);
  std::cout << "steps for 1,000 unknowns: " << few << ", for 16,000: " << many << '\n';
  assert(many < 2 * few && many < 100);
}

void test_solves_again() {
  Solver::Matrix matrix(2);
  matrix.set_coef(0, 0, 2);
  matrix.set_coef(1, 0, -1);
  matrix.set_coef(1, 1, 2);
  Solver solver;
  double denominator = 0;
  assert(solver.factor(matrix, denominator));
  for (double scale : {1., 5.}) {
    Solver::Vector right(2), solution(2);
    right[0] = 0, right[1] = 3 * scale;
    const bool is_solved = solver.linear_solver(right, solution);
    assert(is_solved && std::abs(solution[0] - scale) < 1e-12 && std::abs(solution[1] - 2 * scale) < 1e-12);
  }
}

// Failure is a value: nothing is printed, nothing ends the program.
void test_failure() {
  Solver::Matrix matrix(2);
  matrix.set_coef(0, 0, 1);
  matrix.set_coef(1, 0, 2);
  matrix.set_coef(1, 1, -3);
  Solver::Vector right(2), solution(2);
  right[0] = right[1] = 1;
  double denominator = 0;
  assert(!Solver("jacobi").linear_solver(matrix, right, solution, denominator)); // not positive definite
  assert(!Solver("no such name").linear_solver(matrix, right, solution, denominator));
}

void test_threads() {
  const Mesh mesh = wedge(1);
  const std::vector<double> alone = solved<VMP::Harmonic_function_3>(mesh).values();
  std::vector<std::vector<double>> values(2);
  std::vector<std::thread> threads;
  for (auto& v : values) threads.emplace_back([&] { v = solved<VMP::Harmonic_function_3>(mesh).values(); });
  for (std::thread& t : threads) t.join();
  assert(values[0] == alone && values[1] == alone);
}

int main() {
  test_linear_solution();
  test_agrees_with_default(0);
  test_agrees_with_default(2);
  test_number_of_iterations();
  test_solves_again();
  test_failure();
  test_threads();
  return EXIT_SUCCESS;
}
