#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/measure_floor_distortion.h>

#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

bool is_near(double a, double b) { return std::abs(a - b) < 1e-6; }

template <typename Kernel>
VMP::Floor_distortion_report report(const VMP::Tetrahedron_soup_3<typename Kernel::Point_3>& soup,
                                    const VMP::Floor_map_options& options) {
  VMP::Compact_tetrahedral_mesh_3<Kernel> mesh;
  VMP::Floor_map_2<Kernel> map(options);
  assert(mesh.assign(soup).ok() && map.build(mesh).ok());
  return VMP::measure_floor_distortion(mesh, map);
}

// The base [0, 6] x [0, 3] onto a rectangle: an affine map whose singular values are known.
template <typename Kernel>
void test_rectangle(double width, double depth) {
  VMP::Floor_map_options options;
  options.size = {width, depth, 0};
  const auto soup = Block_with_holes<typename Kernel::Point_3>({0, 0, 6, 3}, {}, 1, 1).soup();
  const VMP::Floor_distortion_report r = report<Kernel>(soup, options);
  const double stretch = std::sqrt(width / 6 / (depth / 3)); // in x, when areas agree
  assert(is_near(r.scale, std::sqrt(18 / (width * depth))));
  assert(is_near(r.greatest_singular_value.minimum(), std::max(stretch, 1 / stretch)));
  assert(is_near(r.greatest_singular_value.maximum(), std::max(stretch, 1 / stretch)));
  assert(is_near(r.least_singular_value.minimum(), std::min(stretch, 1 / stretch)));
  assert(is_near(r.symmetric_dirichlet_energy.mean(), 2 * (stretch * stretch + 1 / (stretch * stretch))));
}

// A floor that is bent but not stretched is unrolled.
void test_unrolled() {
  const auto soup =
      transformed(Block_with_holes<Inexact::Point_3>({0, 0, 6, 3}, {{1, 1, 2, 2}, {3, 1, 5, 2}}, 8, 1).soup(),
                  [](const Inexact::Point_3& p) {
                    const double angle = p.x() / 2, r = 2 - p.z();
                    return Inexact::Point_3(r * std::sin(angle), p.y(), -r * std::cos(angle));
                  });
  const VMP::Floor_distortion_report r = report<Inexact>(soup, VMP::Floor_map_options());
  assert(r.symmetric_dirichlet_energy.maximum() < 4 + 1e-6 && r.least_singular_value.minimum() > 1 - 1e-3);
}

int main() {
  test_rectangle<Inexact>(6, 3);
  test_rectangle<Inexact>(12, 3);
  test_rectangle<Inexact>(100, 70);
  test_rectangle<Exact>(6, 6);
  test_unrolled();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
