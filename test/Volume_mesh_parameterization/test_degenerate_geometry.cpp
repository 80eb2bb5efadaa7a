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

template <typename Map>
void test(const char* name, double size, double tolerance, const Map& map) {
  std::cout << name << ": " << std::flush;
  Parameterizer solid;
  expect(solid.run(transformed(block(), map)), VMP::OK);
  expect(VMP::verify_product(solid.mesh(), solid.product_structure()->order()), VMP::OK);
  test_round_trips(solid, size, tolerance);
}

void test_scales() {
  for (double scale : {1e-90, 1e-30, 1e30, 1e90})
    test("scaled", scale, 1e-12, [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); });
  test("far away", 1, 1e-6, [](const Point& p) { return p + Vector(1e8, -1e8, 1e8); });
}

void test_thin_cells() {
  for (double height : {1e-8, 1e-4, 1e4, 1e8})
    test("flat or needles", (std::max)(1., height), 1e-9, [&](const Point& p) { return Point(p.x(), p.y(), height * p.z()); });
  for (double width : {1e-6, 1e6})
    test("narrow", (std::max)(1., width), 1e-9, [&](const Point& p) { return Point(width * p.x(), p.y(), p.z()); });
}

// One inner vertex of the block is moved next to a facet of a cell, on it, and beyond it.
void test_slivers() {
  const auto with_moved_vertex = [](double x) {
    return transformed(block(), [x](const Point& p) {
      return p == Point(.5, .5, 1. / 3) ? Point(x, .5, 1. / 3) : p;
    });
  };
  Parameterizer sliver, flat, inverted;
  expect(sliver.run(with_moved_vertex(1 - 1e-14)), VMP::OK);
  expect(VMP::verify_product(sliver.mesh(), sliver.product_structure()->order()), VMP::OK);
  expect(flat.run(with_moved_vertex(1)), VMP::ERROR_FLAT_TETRAHEDRON, "tetrahedron");
  expect(inverted.run(with_moved_vertex(1 + 1e-14)), VMP::ERROR_INVERTED_TETRAHEDRON, "tetrahedron");
}

int main() {
  test_scales();
  test_thin_cells();
  test_slivers();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
