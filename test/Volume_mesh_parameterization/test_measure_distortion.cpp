#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>

#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool near(double a, double b) { return std::abs(a - b) < 1e-11 * (1 + std::abs(b)); }

void test_statistics() {
  const VMP::Weighted_statistics even({3, 1, 2, 4}, {1, 1, 1, 1});
  assert(even.minimum() == 1 && even.maximum() == 4 && even.mean() == 2.5 && even.median() == 2);
  assert(even.quantile(0) == 1 && even.quantile(0.51) == 3 && even.quantile(1) == 4);
  const VMP::Weighted_statistics uneven({10, 1, 2}, {6, 1, 3});
  assert(uneven.mean() == 6.7 && uneven.median() == 10 && uneven.quantile(0.4) == 2 &&
         uneven.quantile(0.1) == 1);
  const VMP::Weighted_statistics ignoring({infinity, 5}, {0, 2});
  assert(ignoring.maximum() == 5 && ignoring.mean() == 5);
  const VMP::Weighted_statistics empty({}, {});
  assert(empty.minimum() == 0 && empty.maximum() == 0 && empty.mean() == 0 && empty.median() == 0);
  std::vector<double> values, weights; // quantiles do not depend on how a weight is divided
  for (int i = 0; i < 100; ++i)
    values.insert(values.end(), 1 + i % 3, i), weights.insert(weights.end(), 1 + i % 3, 1);
  std::vector<double> once, multiplicity;
  for (int i = 0; i < 100; ++i) once.push_back(i), multiplicity.push_back(1 + i % 3);
  for (double q : {0., .1, .25, .5, .77, .95, 1.})
    assert(VMP::Weighted_statistics(values, weights).quantile(q) ==
           VMP::Weighted_statistics(once, multiplicity).quantile(q));
}

Mesh make_block() {
  Mesh mesh;
  const VMP::Status status = mesh.assign(Block_with_holes<Point>(1, 2, 3).soup());
  assert(status.ok());
  return mesh;
}

template <typename Function>
std::vector<Point> move(const Mesh& mesh, Function function) {
  std::vector<Point> images;
  for (const Point& p : mesh.points()) images.push_back(function(p.x(), p.y(), p.z()));
  return images;
}

bool is_constant(const VMP::Weighted_statistics& s, double value) {
  return near(s.minimum(), value) && near(s.maximum(), value) && near(s.mean(), value) &&
         near(s.median(), value);
}

void test_affine(const Mesh& mesh) {
  // a rotation after a scaling of the axes
  const auto images = move(mesh, [](double x, double y, double z) {
    return Point(7 + 0.6 * 4 * x - 0.8 * 2 * y, 0.8 * 4 * x + 0.6 * 2 * y, 0.5 * z);
  });
  for (const VMP::Cell_distortion& d : VMP::measure_cell_distortions(mesh, images)) {
    assert(near(d.singular_values[0], 4) && near(d.singular_values[1], 2) && near(d.singular_values[2], 0.5));
    assert(near(d.volume_ratio, 4));
    assert(near(d.symmetric_dirichlet_energy, 16 + 4 + .25 + 1. / 16 + 1. / 4 + 4));
  }
  const VMP::Distortion_report report = VMP::measure_distortion(mesh, images);
  assert(near(report.scale, std::cbrt(0.25)) && is_constant(report.volume_ratio, 1));
  assert(is_constant(report.greatest_singular_value, 4 * report.scale));
  assert(is_constant(report.least_singular_value, 0.5 * report.scale));
}

void test_similarity(const Mesh& mesh) {
  const VMP::Distortion_report report = VMP::measure_distortion(
      mesh, move(mesh, [](double x, double y, double z) { return Point(10 * y, 10 * z, 10 * x); }));
  assert(near(report.scale, 0.1));
  assert(is_constant(report.symmetric_dirichlet_energy, 6) && is_constant(report.greatest_singular_value, 1));
}

void test_volumes(const Mesh& mesh) {
  double total = 0;
  for (double volume : VMP::measure_volumes(mesh, mesh.points())) total += volume;
  assert(near(total, 8)); // 3 x 3 without the hole
}

void test_flipped_and_flat(const Mesh& mesh) {
  const auto mirrored = move(mesh, [](double x, double y, double z) { return Point(x, y, -2 * z); });
  for (const VMP::Cell_distortion& d : VMP::measure_cell_distortions(mesh, mirrored))
    assert(near(d.volume_ratio, -2) && d.symmetric_dirichlet_energy == infinity &&
           near(d.singular_values[0], 2));
  const auto flat = move(mesh, [](double x, double y, double) { return Point(x, y, 0); });
  const VMP::Distortion_report report = VMP::measure_distortion(mesh, flat);
  assert(report.scale == 1 && is_constant(report.volume_ratio, 0) &&
         is_constant(report.least_singular_value, 0));
  assert(report.symmetric_dirichlet_energy.minimum() == infinity);
  // a flat tetrahedron of the mesh itself has no Jacobian and no weight
  Mesh degenerate;
  VMP::Tetrahedron_soup_3<Point> soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  soup.cells = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  const VMP::Status status = degenerate.assign(soup);
  assert(status.ok());
  assert(VMP::measure_cell_distortions(degenerate, soup.points)[1].symmetric_dirichlet_energy == infinity);
  assert(is_constant(VMP::measure_distortion(degenerate, soup.points).symmetric_dirichlet_energy, 6));
}

void test_angles() {
  const std::vector<Vector> a = {{1, 0, 0},      {1, 0, 0}, {1, 1, 0}, {0, 0, 2},
                                 {1e-200, 0, 0}, {0, 0, 0}, {1, 1, 1}};
  const std::vector<std::array<double, 3>> b = {{2, 0, 0},      {0, 0, 3}, {1, 0, 0},       {0, 0, -1},
                                                {0, 1e-200, 0}, {1, 0, 0}, {1, 1, 1 + 1e-9}};
  const std::vector<double> expected = {0, 90, 45, 180, 90, 180, 0};
  const std::vector<double> angles = VMP::measure_angles(a, b);
  for (std::size_t i = 0; i < angles.size(); ++i) assert(std::abs(angles[i] - expected[i]) < 1e-6);
  assert(angles[6] > 1e-8); // small angles keep their digits
}

template <typename Function>
void expect_line_angle(const Mesh& mesh, double expected, Function function) {
  for (double angle : VMP::measure_line_angles(mesh, move(mesh, function)))
    assert(std::abs(angle - expected) < 1e-5);
}

void test_line_angles(const Mesh& mesh) {
  expect_line_angle(mesh, 0, [](double x, double y, double z) { return Point(3 * x + y, 5 * y, 7 * z); });
  expect_line_angle(mesh, 0, [](double x, double y, double z) { return Point(y, z, x); });
  expect_line_angle(mesh, 45, [](double x, double y, double z) { return Point(x, y, z + x); });
  expect_line_angle(mesh, 45, [](double x, double y, double z) { return Point(x + z, y, 9 * z); });
  expect_line_angle(mesh, 135, [](double x, double y, double z) { return Point(x, -y, z + x); });
  expect_line_angle(mesh, 180, [](double x, double y, double) { return Point(x, y, 0); });
}

int main() {
  test_statistics();
  const Mesh mesh = make_block();
  test_affine(mesh);
  test_similarity(mesh);
  test_volumes(mesh);
  test_flipped_and_flat(mesh);
  test_angles();
  test_line_angles(mesh);
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
