#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>

#include "test_util.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Potential = VMP::Dual_potential_3<Mesh>;

Mesh mesh_of(const Soup& soup) {
  Mesh mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  return mesh;
}

template <typename Solver = VMP::Default_solver_traits_3>
std::vector<double> values(const Mesh& mesh) {
  VMP::Dual_potential_3<Mesh, Solver> potential(mesh);
  const VMP::Status status = potential.solve();
  assert(status.ok() && potential.residual() < 1e-12);
  return potential.values();
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  assert(a.size() == b.size());
  double d = 0;
  for (std::size_t i = 0; i < a.size(); ++i) d = std::max(d, std::abs(a[i] - b[i]));
  return d;
}

// Every cell has a lower neighbor (or the floor) and a higher one (or the ceiling): no local extremum.
void test_monotone(const Mesh& mesh) {
  const std::vector<double> u = values(mesh);
  const auto beyond = [&](VMP::Cell_index c, int i) {
    const int label = mesh.label(c, i);
    return label == VMP::FLOOR      ? 0
           : label == VMP::CEILING  ? 1
           : label == VMP::INTERIOR ? u[mesh.neighbor(c, i)]
                                    : u[c];
  };
  for (VMP::Cell_index c : mesh.cells()) {
    assert(0 < u[c] && u[c] < 1);
    double lowest = 1, highest = 0;
    for (int i = 0; i < 4; ++i) {
      lowest = std::min(lowest, beyond(c, i));
      highest = std::max(highest, beyond(c, i));
    }
    assert(lowest < u[c] && u[c] < highest);
  }
}

// The path of three cells of one Kuhn prism, solved by hand: floor, three cells in a row, ceiling.
void test_column() {
  Soup soup;
  soup.points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0),
                 Point(0, 0, 1), Point(1, 0, 1), Point(0, 1, 1)};
  soup.cells = {{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}};
  for (auto& c : soup.cells)
    if (CGAL::orientation(soup.points[c[0]], soup.points[c[1]], soup.points[c[2]], soup.points[c[3]]) < 0)
      std::swap(c[0], c[1]);
  soup.facets = {{{0, 1, 2}, VMP::FLOOR}, {{3, 4, 5}, VMP::CEILING}};
  const std::vector<double> u = values(mesh_of(soup));
  // all volumes V are 1/6, A^2 / (V 3/4) = 2 at a base, A^2 / (2 V 3/4) = 3 at 1-2-3 and 2 at 2-3-4
  const double current = 1 / (1 / 2. + 1 / 3. + 1 / 2. + 1 / 2.);
  assert(std::abs(u[0] - current / 2) < 1e-14);
  assert(std::abs(u[1] - u[0] - current / 3) < 1e-14);
  assert(std::abs(u[2] - u[1] - current / 2) < 1e-14);
}

void test_invariance() {
  const Soup soup = jitter_interior(Block_with_holes<Point>(1, 3, 3).soup(), 0.06, 3);
  const std::vector<double> expected = values(mesh_of(soup));
  for (double s : {1e-6, 1e6})
    assert(largest_difference(expected, values(mesh_of(transformed(soup, [s](const Point& p) {
                                return Point(s * p.x(), s * p.y(), s * p.z());
                              })))) < 1e-11);
  assert(largest_difference(
             expected, values(mesh_of(transformed(soup, [](const Point& p) { // turned by (3, 4, 5)
               return Point(7 + (3 * p.x() - 4 * p.y()) / 5, p.z() - 11, -(4 * p.x() + 3 * p.y()) / 5);
             })))) < 1e-11);
  assert(largest_difference(expected, values<VMP::Simplicial_solver_traits_3>(mesh_of(soup))) < 1e-12);
  assert(expected == values(mesh_of(soup))); // to the bit
}

// Neighbors are in the same order as along the solution, but for those that are nearly equal.
void test_approximation(const Mesh& mesh) {
  VMP::Harmonic_function_3<Mesh> f(mesh);
  Potential approximate(mesh);
  assert(f.solve().ok() && approximate.approximate(f.values()).ok());
  const std::vector<double> exact = values(mesh), &u = approximate.values();
  assert(u.size() == exact.size() && largest_difference(u, exact) < .01);
  assert(0 < approximate.residual() && approximate.residual() < .01);
  for (VMP::Facet_index facet : mesh.facets()) {
    if (mesh.is_boundary(facet)) continue;
    const VMP::Cell_index a = mesh.half_facet(facet).cell, b = mesh.half_facet(facet, 1).cell;
    assert(std::abs(exact[a] - exact[b]) < 1e-3 || (u[a] < u[b]) == (exact[a] < exact[b]));
  }
  const double residual = approximate.residual();
  assert(approximate.approximate(std::vector<double>(mesh.number_of_vertices(), .5)).ok());
  assert(approximate.residual() > 2 * residual); // it does not get there from afar
}

VMP::Error_code code_of(const Soup& soup) {
  const Mesh mesh = mesh_of(soup);
  return Potential(mesh).solve().code();
}

struct Failing_solver : VMP::Default_solver_traits_3 {
  bool linear_solver(const Vector&, Vector&) { return false; }
};

void test_refusals() {
  const Soup good = Block_with_holes<Point>(0, 1, 2).soup();
  assert(code_of(good) == VMP::OK);
  const Mesh mesh = mesh_of(good);
  assert((VMP::Dual_potential_3<Mesh, Failing_solver>(mesh).solve().code() == VMP::ERROR_CANNOT_SOLVE));

  const Mesh flat = mesh_of(transformed(good, [](const Point& p) { return Point(p.x(), p.y(), 0); }));
  assert(Potential(flat).solve().code() == VMP::ERROR_FLAT_TETRAHEDRON);
  assert(Potential(flat).approximate(std::vector<double>(flat.number_of_vertices(), 0)).code() == VMP::ERROR_FLAT_TETRAHEDRON);
  const Mesh huge = mesh_of(transformed(good, [](const Point& p) { return Point(1e100 * p.x(), 1e100 * p.y(), 1e100 * p.z()); }));
  assert(Potential(huge).approximate(std::vector<double>(huge.number_of_vertices(), .5)).code() == VMP::ERROR_CANNOT_SOLVE);
  for (int base : {VMP::FLOOR, VMP::CEILING}) {
    Soup without = good;
    for (VMP::Labelled_facet& f : without.facets)
      if (f.label == base) f.label = VMP::FIRST_WALL;
    assert(code_of(without) == VMP::ERROR_NUMBER_OF_PATCHES);
  }
  Soup island = good;
  const std::size_t n = island.points.size();
  for (const Point& p : {Point(9, 0, 0), Point(10, 0, 0), Point(9, 1, 0), Point(9, 0, 1)})
    island.points.push_back(p);
  island.cells.push_back({n, n + 1, n + 2, n + 3});
  assert(code_of(island) == VMP::ERROR_SEVERAL_COMPONENTS);
}

int main() {
  for (int holes : {0, 1, 2})
    test_monotone(mesh_of(jitter_interior(Block_with_holes<Point>(holes, 4, 4).soup(), 0.04, 7)));
  test_approximation(mesh_of(jitter_interior(Block_with_holes<Point>(2, 8, 8).soup(), 0.02, 7)));
  test_column();
  test_invariance();
  test_refusals();
  std::cout << "done\n";
  return EXIT_SUCCESS;
}
