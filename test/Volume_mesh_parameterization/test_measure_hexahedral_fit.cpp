#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/measure_hexahedral_fit.h>

#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Hexahedra = VMP::Hexahedron_soup_3<Point_3>;

bool is_close(double a, double b) { return std::abs(a - b) < 1e-12; }

// The block of 3 x 3 with a hole of 1 x 1, of height 1, by cubes of edge 1 / 2.
Hexahedra cubes() {
  const VMP::Prism_3<Kernel> prism({0, 0, 3, 3}, {{1, 1, 2, 2}}, 1);
  const auto column = [](const Point_2& p, const std::vector<double>& levels, std::vector<Point_3>& points) {
    for (double level : levels) points.push_back(Point_3(p.x(), p.y(), level));
    return VMP::Status();
  };
  Hexahedra result;
  const VMP::Status status = VMP::hexahedral_mesh(prism, VMP::prism_grid(prism, 0.5), column, result);
  assert(status.ok());
  return result;
}

int main() {
  VMP::Compact_tetrahedral_mesh_3<Kernel> solid;
  const VMP::Status status = solid.assign(Block_with_holes<Point_3>(1, 2, 2).soup());
  assert(status.ok());
  Hexahedra hexahedra = cubes();
  VMP::Hexahedral_fit fit = VMP::measure_hexahedral_fit(solid, hexahedra);
  assert(is_close(fit.edge, 0.5) && fit.distance_to_solid == 0 && fit.distance_from_solid == 0);
  assert(is_close(fit.volume, 8) && is_close(fit.solid_volume, 8));

  // Twice as high: the ceiling is 1 away, as is the middle of its hexahedra's sides.
  for (Point_3& p : hexahedra.points) p = Point_3(p.x(), p.y(), 2 * p.z());
  fit = VMP::measure_hexahedral_fit(solid, hexahedra);
  assert(is_close(fit.distance_to_solid, 1) && is_close(fit.volume, 16) && is_close(fit.solid_volume, 8));
  assert(is_close(fit.distance_from_solid,
                  0.5)); // from the middle of the ceiling's ring of width 1 to its walls

  // One node is pulled out.
  hexahedra = cubes();
  for (Point_3& p : hexahedra.points)
    if (p == Point_3(0, 0, 0)) p = Point_3(-0.3, -0.4, 0);
  fit = VMP::measure_hexahedral_fit(solid, hexahedra);
  assert(is_close(fit.distance_to_solid, 0.5) && fit.volume > 8);
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
