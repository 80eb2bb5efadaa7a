// Follows a parameterization step by step, and stops it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_map_3.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>
#include <CGAL/Volume_mesh_parameterization/partition_boundary.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;

// 1. Write a visitor. It is copied, so it refers to what it counts.
struct Counting_visitor {
  int* steps;
  int most_steps;

  // Before a stage; `false` stops.
  bool start_stage(const char* name) {
    std::cout << "  " << ++*steps << ". " << name << std::endl;
    return *steps < most_steps;
  }
  // Within a long stage, when `done` of `all` parts are done.
  bool advance(std::size_t done, std::size_t all) {
    std::cout << "  " << ++*steps << ". after " << done << " of " << all << std::endl;
    return *steps < most_steps;
  }
};

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

// 2. Hand it to each function.
VMP::Status parameterize(Mesh mesh, int most_steps) {
  int steps = 0;
  Counting_visitor visitor{&steps, most_steps};
  VMP::Partition_options options;
  options.directions = {VMP::Sweep_direction_3(0, 0, 1), VMP::Sweep_direction_3(1, 2, 3)};
  VMP::Direct_product_parameterizer_3<Kernel> result;
  VMP::Piecewise_linear_map_3<Kernel> linear;
  VMP::Status status = VMP::partition_boundary(mesh, options, nullptr, visitor);
  if (status.ok()) status = VMP::parameterize(mesh, result, CGAL::parameters::visitor(visitor));
  if (status.ok()) status = VMP::make_piecewise_linear(result, linear, CGAL::parameters::visitor(visitor));
  return status;
}

int main(int argc, char* argv[]) {
  const std::string filename = argc > 1 ? argv[1] : "data/block_with_hole.mesh";
  VMP::Tetrahedron_soup_3<Kernel::Point_3> soup;
  Mesh mesh;
  VMP::Status status = VMP::IO::read_MEDIT(filename, soup);
  soup.facets.clear(); // so that there is a partition to search
  if (status.ok()) status = mesh.assign(soup);
  if (!status.ok()) return fail(status);

  // 3. Let all steps be taken.
  std::cout << "to the end:" << std::endl;
  status = parameterize(mesh, 1000);
  if (!status.ok()) return fail(status);

  // 4. Stop at the seventh one: that is a status like others.
  std::cout << "until the seventh step:" << std::endl;
  status = parameterize(mesh, 7);
  std::cout << "  " << status.message() << std::endl;
  return status.code() == VMP::ERROR_CANCELLED ? EXIT_SUCCESS : EXIT_FAILURE;
}
