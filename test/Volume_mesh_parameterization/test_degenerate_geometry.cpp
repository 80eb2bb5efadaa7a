#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "io_test_util.h"
#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

// Certificates come from exact signs, so they do not depend on how thin cells are or how large numbers are. On a grid, all
// vertices of a cube are cospherical and those of an edge collinear.

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Parameterizer = VMP::Direct_product_parameterizer_3<Kernel>;

Soup block() { return Block_with_holes<Point>(1, 2, 3).soup(); }

// The barycentre of each cell returns to within `tolerance`, a share of the size of the solid.
void test_round_trips(const Parameterizer& solid, double size, double tolerance) {
  double farthest = 0;
  for (VMP::Cell_index c : solid.mesh().cells()) {
    const VMP::Location_3<Kernel> start{c, {.25, .25, .25, .25}};
    VMP::Location_3<Kernel> end = start;
    Point image(0, 0, 0);
    expect(solid.product_map()->image(start, image), VMP::OK);
    expect(solid.product_map()->preimage(image, end), VMP::OK);
    const Vector gap = (end.point(solid.mesh()) - start.point(solid.mesh())) / size; // squares of sizes may overflow
    farthest = std::max(farthest, std::sqrt(gap.squared_length()));
  }
  std::cout << "points return within " << farthest << std::endl;
  assert(farthest < tolerance);
}

// Solids that ask too much of the numbers are refused.
enum Outcome { PARAMETERIZED, PARAMETERIZED_OR_REFUSED };

void test(const char* name, double value, const Soup& soup, double size, double tolerance,
          Outcome outcome = PARAMETERIZED) {
  std::cout << name << " " << value << ": " << std::flush;
  Parameterizer solid;
  const VMP::Status status = solid.run(soup);
  if (outcome == PARAMETERIZED_OR_REFUSED && !status.ok()) {
    std::cout << status.message() << std::endl;
    assert(status.code() == VMP::ERROR_CANNOT_SOLVE || status.code() == VMP::ERROR_FLOOR_MAP);
    return;
  }
  expect(status, VMP::OK);
  expect(VMP::verify_product(solid.mesh(), solid.product_structure()->order()), VMP::OK);
  test_round_trips(solid, size, tolerance);
}

Soup stretched(double x, double z) {
  return transformed(block(), [=](const Point& p) { return Point(x * p.x(), p.y(), z * p.z()); });
}

// Fourth powers of sizes must be numbers, which areas are computed of.
void test_scales() {
  const auto scaled = [](double scale) {
    return transformed(block(), [=](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); });
  };
  for (double scale : {1e-75, 1e-30, 1e30, 1e75}) test("scaled by", scale, scaled(scale), scale, 1e-12);
  for (double scale : {1e-100, 1e100})
    test("scaled by", scale, scaled(scale), scale, 1e-12, PARAMETERIZED_OR_REFUSED);
}

// Coordinates keep fewer digits, points return less closely.
void test_distances() {
  for (double away : {1e4, 1e8})
    test("moved by", away,
         transformed(block(), [=](const Point& p) { return p + Vector(away, -away, away); }), 1,
         1e-15 * away);
}

void test_thin_cells() {
  for (double height : {1e-12, 1e-4}) test("flattened to", height, stretched(1, height), 1, 1e-12);
  for (double width : {1e3, 1e6}) test("drawn out to", width, stretched(width, 1), width, 1e-12);
  test("raised to", 1e4, stretched(1, 1e4), 1e4, 1e-9);
  test("raised to", 1e12, stretched(1, 1e12), 1e12, 1e-3, PARAMETERIZED_OR_REFUSED);
  test("squeezed to", 1e-3, stretched(1e-3, 1), 1, 1e-6);
  test("squeezed to", 1e-12, stretched(1e-12, 1), 1, 1e-3, PARAMETERIZED_OR_REFUSED);
}

// An inner vertex is moved almost to the next one, onto it, and beyond it.
void test_slivers() {
  const auto moved_to = [](double x) {
    return transformed(block(),
                       [x](const Point& p) { return p == Point(.5, .5, 1. / 3) ? Point(x, .5, 1. / 3) : p; });
  };
  test("sliver of", 1e-4, moved_to(1 - 1e-4), 1, 1e-9);
  test("sliver of", 1e-14, moved_to(1 - 1e-14), 1, 1e-3, PARAMETERIZED_OR_REFUSED);
  Parameterizer flat, inverted;
  expect(flat.run(moved_to(1)), VMP::ERROR_FLAT_TETRAHEDRON, "tetrahedron");
  expect(inverted.run(moved_to(1 + 1e-14)), VMP::ERROR_INVERTED_TETRAHEDRON, "tetrahedron");
}

int main() {
  test_scales();
  test_distances();
  test_thin_cells();
  test_slivers();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
