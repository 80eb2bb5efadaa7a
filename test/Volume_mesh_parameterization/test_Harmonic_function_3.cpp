#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>

#include "test_util.h"

#include <Eigen/SparseLU>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <type_traits>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Function = VMP::Harmonic_function_3<Mesh>;

Mesh mesh_of(const Soup& soup) {
  Mesh mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  return mesh;
}

template <typename Solver = VMP::Default_solver_traits_3>
std::vector<double> values(const Soup& soup) {
  const Mesh mesh = mesh_of(soup);
  VMP::Harmonic_function_3<Mesh, Solver> f(mesh);
  const VMP::Status status = f.solve();
  assert(status.ok() && f.residual() < 1e-12);
  return f.values();
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  assert(a.size() == b.size());
  double d = 0;
  for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, std::abs(a[i] - b[i]));
  return d;
}

// a block in which no linear function is the solution
Soup wedge(int holes) {
  return transformed(
      jitter_interior(Block_with_holes<Point>(holes, 3, 4).soup(), 0.05, 3), [](const Point& p) {
        return Point(p.x() + 0.3 * p.z() * p.z(), p.y(), p.z() * (1 + 0.4 * p.x() + 0.1 * p.y() * p.y()));
      });
}

void test_gradients_reproduce_linear_functions() {
  const Mesh mesh = mesh_of(jitter_interior(Block_with_holes<Point>(1, 3, 3).soup(), 0.08, 1));
  const CGAL::Simple_cartesian<double>::Vector_3 slope(3, -2, 0.5);
  double total = 0;
  for (VMP::Cell_index c : mesh.cells()) {
    const VMP::internal::Cell_gradients cell(mesh, c);
    std::array<double, 4> values;
    for (int i = 0; i < 4; ++i)
      values[i] = slope * (VMP::internal::approximate(mesh.point(mesh.vertex(c, i))) - CGAL::ORIGIN);
    assert((cell.interpolate(values) - slope).squared_length() < 1e-24);
    assert(cell.interpolate({0.1, 0.1, 0.1, 0.1}) == CGAL::NULL_VECTOR);
    total += cell.volume;
  }
  assert(std::abs(total - 8) < 1e-12);
}

void test_block(int holes) {
  const double height = 1.7;
  const Mesh mesh = mesh_of(jitter_interior(Block_with_holes<Point>(holes, 4, 5, height).soup(), 0.06, 7));
  Function f(mesh);
  const VMP::Status status = f.solve();
  assert(status.ok());
  double error = 0;
  for (VMP::Vertex_index v : mesh.vertices())
    error = std::max(error, std::abs(f(v) - mesh.point(v).z() / height));
  std::cout << "block with " << holes << " holes: error " << error << ", residual " << f.residual() << '\n';
  assert(error < 1e-12);
  for (VMP::Cell_index c : mesh.cells())
    assert((f.gradient(c) - CGAL::Simple_cartesian<double>::Vector_3(0, 0, 1 / height)).squared_length() <
           1e-20);
  assert(f.maximum_principle_violations().empty());
}

// Kuhn tetrahedra have no obtuse dihedral angle.
void test_negative_weights() {
  assert(Function(mesh_of(Block_with_holes<Point>(0, 2, 2).soup())).share_of_negative_weights() == 0);
  const double share = Function(mesh_of(wedge(0))).share_of_negative_weights();
  assert(share > 0 && share < 1);
}

// Shearing makes weights so negative that values leave [0, 1]: exactly those vertices are found.
void test_maximum_principle() {
  Soup soup = jitter_interior(Block_with_holes<Point>(0, 2, 2).soup(), 0.15, 2);
  for (auto& p : soup.points) p = Point(p.x(), p.y() + 6 * p.x(), p.z() + 9 * p.x());
  const Mesh mesh = mesh_of(soup);
  Function f(mesh);
  const VMP::Status status = f.solve();
  assert(status.ok());
  const auto violations = f.maximum_principle_violations();
  std::size_t outside = 0;
  for (double x : f.values()) outside += x < -Function::solver_noise || x > 1 + Function::solver_noise;
  std::cout << violations.size() << " violations in a sheared block\n";
  assert(outside == violations.size() && outside > 0);
  for (VMP::Vertex_index v : violations) assert(f(v) < 0 || f(v) > 1);
}

void test_invariance() {
  const std::vector<double> expected = values(wedge(1));
  for (double s : {1e-6, 1e6})
    assert(largest_difference(expected, values(transformed(wedge(1), [s](const Point& p) {
                                return Point(s * p.x(), s * p.y(), s * p.z());
                              }))) < 1e-11);
  assert(largest_difference(expected, values(transformed(wedge(1), [](const Point& p) { // turned by (3, 4, 5)
                              return Point(7 + (3 * p.x() - 4 * p.y()) / 5, p.z() - 11,
                                           -(4 * p.x() + 3 * p.y()) / 5);
                            }))) < 1e-11);
}

void test_solvers_agree() {
  using Matrix = CGAL::Eigen_sparse_matrix<double>::EigenType;
  const std::vector<double> expected = values<VMP::Simplicial_solver_traits_3>(wedge(2));
  assert(largest_difference(expected, values(wedge(2))) < 1e-12);
  assert(largest_difference(
             expected,
             values<VMP::Conjugate_gradient_traits_3<Eigen::IncompleteCholesky<double>>>(wedge(2))) < 1e-12);
  using Symmetric =
      CGAL::Eigen_solver_traits<Eigen::SimplicialCholesky<Matrix>>; // with a symmetric matrix type
  static_assert(std::is_same<Symmetric::Matrix, CGAL::Eigen_sparse_symmetric_matrix<double>>::value, "");
  assert(largest_difference(expected, values<Symmetric>(wedge(2))) < 1e-12);
  using General = CGAL::Eigen_solver_traits<Eigen::SparseLU<Matrix>>; // reads both halves
  assert(largest_difference(expected, values<General>(wedge(2))) < 1e-12);
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
  assert(largest_difference(expected, values<VMP::Cholmod_solver_traits_3>(wedge(2))) < 1e-12);
#endif
  assert(values(wedge(2)) == values(wedge(2))); // to the bit
}

struct Failing_solver : VMP::Default_solver_traits_3 {
  bool linear_solver(const Vector&, Vector&) { return false; }
};

struct Lying_solver : VMP::Default_solver_traits_3 {
  bool linear_solver(const Vector&, Vector&) { return true; }
};

template <typename Solver = VMP::Default_solver_traits_3>
VMP::Error_code code_of(const Mesh& mesh) {
  return VMP::Harmonic_function_3<Mesh, Solver>(mesh).solve().code();
}

void test_refusals() {
  const Soup good = Block_with_holes<Point>(0, 2, 2).soup();
  const Mesh mesh = mesh_of(good);
  assert(code_of(mesh) == VMP::OK);
  assert(code_of<Failing_solver>(mesh) == VMP::ERROR_CANNOT_SOLVE);
  assert(code_of<Lying_solver>(mesh) == VMP::ERROR_CANNOT_SOLVE);

  assert(code_of(mesh_of(transformed(good, [](const Point& p) { return Point(p.x(), p.y(), 0); }))) ==
         VMP::ERROR_FLAT_TETRAHEDRON);
  Soup unused = good;
  unused.points.push_back(Point(9, 9, 9));
  assert(code_of(mesh_of(unused)) == VMP::ERROR_SEVERAL_COMPONENTS);

  for (int base : {VMP::FLOOR, VMP::CEILING}) {
    Soup without = good;
    for (VMP::Labelled_facet& f : without.facets)
      if (f.label == base) f.label = VMP::FIRST_WALL;
    assert(code_of(mesh_of(without)) == VMP::ERROR_NUMBER_OF_PATCHES);
  }
  Soup touching = good;
  for (VMP::Labelled_facet& f : touching.facets)
    if (f.label >= VMP::FIRST_WALL) f.label = VMP::FLOOR;
  assert(code_of(mesh_of(touching)) == VMP::ERROR_FLOOR_MEETS_CEILING);
}

void test_all_vertices_fixed() {
  const Mesh mesh = mesh_of(Block_with_holes<Point>(0, 1, 1).soup());
  Function f(mesh);
  const VMP::Status status = f.solve();
  assert(status.ok() && f.residual() == 0);
  for (VMP::Vertex_index v : mesh.vertices()) assert(f(v) == mesh.point(v).z());
}

int main() {
  test_gradients_reproduce_linear_functions();
  for (int holes : {0, 1, 2}) test_block(holes);
  test_negative_weights();
  test_maximum_principle();
  test_invariance();
  test_solvers_agree();
  test_refusals();
  test_all_vertices_fixed();
  std::cout << "done\n";
  return EXIT_SUCCESS;
}
