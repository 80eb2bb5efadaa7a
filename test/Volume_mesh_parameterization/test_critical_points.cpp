#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/critical_points.h>

#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;

Mesh make_block(int holes, int m, int layers, double height) {
  Mesh mesh;
  const VMP::Status status = mesh.assign(Block_with_holes<Point>(holes, m, layers, height).soup());
  assert(status.ok());
  return mesh;
}

template <typename Function>
std::vector<VMP::Critical_vertex> critical_points(const Mesh& mesh, const Function& f) {
  std::vector<double> values;
  for (const Point& p : mesh.points()) values.push_back(f(p));
  std::vector<VMP::Critical_vertex> result;
  const VMP::Status status = VMP::find_critical_points(mesh, values, result);
  assert(status.ok());
  return result;
}

// f must have exactly one critical vertex, at `where`.
template <typename Function>
void test_single(const Mesh& mesh, const Function& f, int index, bool on_wall, const Point& where) {
  const auto found = critical_points(mesh, f);
  assert(found.size() == 1);
  assert(found[0].index == index && found[0].multiplicity == 1 && found[0].on_wall == on_wall);
  assert(CGAL::squared_distance(mesh.point(found[0].vertex), where) < 1e-12);
}

// The height of a block is critical nowhere, with and without ties, holes or not.
void test_regular() {
  for (int holes = 0; holes <= 2; ++holes) {
    const Mesh mesh = make_block(holes, 2, 3, 1);
    assert(critical_points(mesh, [](const Point& p) { return p.z(); }).empty());
    assert(critical_points(mesh, [](const Point& p) { return std::sinh(p.z()); }).empty());
  }
}

// Quadratic forms around the middle of the block [0, 1] x [0, 3] x [0, 3]. The terms in x and y bring in critical
// points on the walls, so these have labels as bases.
void test_interior() {
  Mesh mesh = make_block(0, 6, 18, 3);
  for (VMP::Facet_index f : mesh.boundary_facets()) mesh.set_label(f, VMP::FLOOR);
  const Point middle(.5, 1.5, 1.5);
  const auto form = [&](double a, double b, double c) {
    return [=](const Point& p) {
      return a * std::pow(p.x() - .5, 2) + b * std::pow(p.y() - 1.5, 2) + c * std::pow(p.z() - 1.5, 2);
    };
  };
  test_single(mesh, form(1, 1, 1), 0, false, middle);
  test_single(mesh, form(2, 2, -1), 1, false, middle);
  test_single(mesh, form(-1, 2, 2), 1, false, middle);
  test_single(mesh, form(1, -2, -2), 2, false, middle);
  test_single(mesh, form(-1, -1, -1), 3, false, middle);
}

// Functions that are even across the wall x = 0, and regular away from it.
void test_wall() {
  Mesh mesh = make_block(0, 6, 18, 3);
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    const bool left = mesh.point(v[0]).x() == 0 && mesh.point(v[1]).x() == 0 && mesh.point(v[2]).x() == 0;
    mesh.set_label(f, left ? VMP::FIRST_WALL : VMP::FLOOR);
  }
  const Point on_wall(0, 1.5, 1.5);
  const auto form = [&](double a, double b, double c) {
    return [=](const Point& p) {
      return a * std::pow(p.x(), 2) + b * std::pow(p.y() - 1.5, 2) + c * std::pow(p.z() - 1.5, 2);
    };
  };
  test_single(mesh, form(1, 1, 1), 0, true, on_wall);
  test_single(mesh, form(2, 2, -1), 1, true, on_wall);
  test_single(mesh, form(-1, 2, 2), 1, true, on_wall);
  test_single(mesh, form(1, -2, -2), 2, true, on_wall);
  test_single(mesh, form(-1, -1, -1), 3, true, on_wall);
}

// Re (y + i z)^3 has a saddle of multiplicity 2 around the axis; x makes it regular, x^2 does not.
void test_monkey_saddle() {
  Mesh mesh = make_block(0, 6, 18, 3);
  for (VMP::Facet_index f : mesh.boundary_facets()) mesh.set_label(f, VMP::FLOOR);
  const auto cubic = [](const Point& p) {
    const double y = p.y() - 1.5, z = p.z() - 1.5;
    return y * y * y - 3 * y * z * z;
  };
  assert(critical_points(mesh, [&](const Point& p) { return cubic(p) + p.x(); }).empty());
  const auto found =
      critical_points(mesh, [&](const Point& p) { return cubic(p) + 3 * std::pow(p.x() - .5, 2); });
  int at_1 = 0;
  for (const VMP::Critical_vertex& c : found) at_1 += (c.index == 1 ? 1 : -1) * c.multiplicity;
  assert(at_1 == 2); // the sum of the indices, whatever the mesh makes of the saddle
}

void test_refusals() {
  const Mesh mesh = make_block(0, 1, 1, 1);
  std::vector<VMP::Critical_vertex> result;
  std::vector<double> values(mesh.number_of_vertices(), 0.);
  values[3] = std::numeric_limits<double>::quiet_NaN();
  assert(VMP::find_critical_points(mesh, values, result).code() == VMP::ERROR_WRONG_PARAMETER);
  values.pop_back();
  assert(VMP::find_critical_points(mesh, values, result).code() == VMP::ERROR_WRONG_PARAMETER);
}

int main() {
  test_regular();
  test_interior();
  test_wall();
  test_monkey_saddle();
  test_refusals();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
