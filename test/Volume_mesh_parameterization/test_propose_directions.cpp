#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/propose_directions.h>

#include "surface_test_util.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Direction = VMP::Sweep_direction_3;

// A block is made of bases and walls only along its edges: these come first among those that are chosen for that.
void test_axes_of_block() {
  const std::vector<Direction> directions = VMP::propose_directions(block_surface<Point>(1, 1, 1));
  const auto is_axis = [](const Direction& d) {
    return std::max({std::abs(d.x()), std::abs(d.y()), std::abs(d.z())}) == 1;
  };
  assert(is_axis(directions[0]));
  assert(std::count_if(directions.begin(), directions.end(), is_axis) == 3);
}

void test_unit_vectors_apart() {
  const std::vector<Direction> directions = VMP::propose_directions(block_surface<Point>(2, 1, 1));
  const double cosine = std::cos(std::acos(-1.) / 12); // of 15 degrees
  for (std::size_t i = 0; i < directions.size(); ++i) {
    assert(std::abs(directions[i].squared_length() - 1) < 1e-14);
    for (std::size_t j = 0; j < i; ++j) assert(std::abs(directions[i] * directions[j]) < cosine + 1e-3);
  }
  std::cout << directions.size() << " directions" << std::endl;
}

// The boundary of a mesh is a surface like others.
void test_mesh_and_surface() {
  VMP::Compact_tetrahedral_mesh_3<Kernel> mesh;
  const VMP::Status status = mesh.assign(Block_with_holes<Point>(1, 1, 1).soup());
  assert(status.ok());
  assert(VMP::propose_directions(mesh) == VMP::propose_directions(block_surface<Point>(1, 1, 1)));
}

int main() {
  test_axes_of_block();
  test_unit_vectors_apart();
  test_mesh_and_surface();
  return EXIT_SUCCESS;
}
