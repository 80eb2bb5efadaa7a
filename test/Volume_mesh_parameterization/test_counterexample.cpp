#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/critical_points.h>
#include <CGAL/Volume_mesh_parameterization/sweep_with_repairs.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "solid_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;

constexpr int cells_per_edge = 20;

// Whether a point of the unit cube is in an arch that stands on the bottom, with a gap in the middle of its beam.
bool is_in_arch(double x, double y, double z) {
  constexpr double half_width = 0.075, thickness = 0.15, height = 0.6, half_span = 0.3, half_gap = 0.05;
  const double from_middle = std::abs(x - 0.5);
  if (std::abs(y - 0.5) > half_width || z > height || from_middle > half_span) return false;
  return from_middle > half_span - thickness || (z > height - thickness && from_middle > half_gap);
}

// The unit cube without the arch, cut into the Kuhn tetrahedra of a grid.
Soup cube_without_arch() {
  const Soup cube =
      Block_with_holes<Point>(0, cells_per_edge, cells_per_edge).soup(); // [0, 1] x [0, 3] x [0, 1]
  Soup soup;
  soup.points = cube.points;
  for (const auto& c : cube.cells) {
    const Point centre =
        CGAL::centroid(cube.points[c[0]], cube.points[c[1]], cube.points[c[2]], cube.points[c[3]]);
    const auto middle = [](double t) { return (std::floor(t * cells_per_edge) + 0.5) / cells_per_edge; };
    if (centre.y() < 1 && !is_in_arch(middle(centre.x()), middle(centre.y()), middle(centre.z())))
      soup.cells.push_back(c);
  }
  VMP::remove_isolated_points(soup);
  return soup;
}

void label(Mesh& mesh) {
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    const Point &p = mesh.point(v[0]), &q = mesh.point(v[1]), &r = mesh.point(v[2]);
    const auto all = [&](auto coordinate, double value) {
      return coordinate(p) == value && coordinate(q) == value && coordinate(r) == value;
    };
    const auto x = [](const Point& s) { return s.x(); };
    const auto y = [](const Point& s) { return s.y(); };
    const bool is_wall = all(x, 0) || all(x, 1) || all(y, 0) || all(y, 1);
    mesh.set_label(f, all([](const Point& s) { return s.z(); }, 1) ? VMP::CEILING
                      : is_wall                                    ? VMP::FIRST_WALL
                                                                   : VMP::FLOOR);
  }
}

// The floor is the bottom with the arch: a disk. The level sets of f pass around and under the beam, grow together in the
// gap and close the hole under it: f has two critical points inside, of index 1 and 2, although the solid is a product.
int main() {
  Mesh mesh;
  VMP::Boundary_partition_3 summary;
  VMP::Preparation counts;
  VMP::Status status = mesh.assign(cube_without_arch());
  if (status.ok()) status = VMP::check_tetrahedral_mesh(mesh);
  label(mesh);
  if (status.ok()) status = VMP::validate_partition(mesh, summary);
  if (status.ok()) status = VMP::prepare_patches(mesh, counts);
  std::cout << mesh.number_of_cells() << " cells, genus " << summary.genus << ": " << status.message()
            << std::endl;
  assert(status.ok() && summary.genus == 0);

  VMP::Harmonic_function_3<Mesh> f(mesh);
  std::vector<VMP::Critical_vertex> critical;
  status = f.solve();
  if (status.ok()) status = VMP::find_critical_points(mesh, f.values(), critical);
  assert(status.ok());
  int of_index[4] = {0, 0, 0, 0};
  for (const VMP::Critical_vertex& c : critical) {
    std::cout << "index " << c.index << " at " << mesh.point(c.vertex) << ", f = " << f(c.vertex)
              << std::endl;
    assert(!c.on_wall);
    of_index[c.index] += c.multiplicity;
  }
  assert(of_index[0] == 0 && of_index[1] == 1 && of_index[2] == 1 && of_index[3] == 0);

  VMP::Product_structure_3<Kernel> structure;
  VMP::Sweep_report report;
  status = VMP::sweep_with_repairs(mesh, flux_guide<Mesh>, structure, report);
  if (status.ok()) status = VMP::verify_product(mesh, structure.order());
  std::cout << "sweep, left at first " << report.left_at_first << ": " << status.message() << std::endl;
  assert(status.ok());
  return EXIT_SUCCESS;
}
