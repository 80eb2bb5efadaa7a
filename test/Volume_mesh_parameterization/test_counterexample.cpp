#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/critical_points.h>
#include <CGAL/Volume_mesh_parameterization/sweep_with_repairs.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "solid_test_util.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;

// The cubes of edge 1 / n in [0, 1] x [0, 1] x [0, height] whose middles are in a solid, cut into Kuhn tetrahedra.
template <typename Is_solid>
Soup solid_of_cubes(int n, double height, const Is_solid& is_solid) {
  const int layers = int(std::lround(height * n));
  Soup soup = Block_with_holes<Point>(0, n, layers, height).soup(); // [0, 1] x [0, 3] x [0, height]
  const auto is_outside = [&](const auto& c) {
    const Point p =
        CGAL::centroid(soup.points[c[0]], soup.points[c[1]], soup.points[c[2]], soup.points[c[3]]);
    const auto middle = [n](double t) { return (std::floor(t * n) + 0.5) / n; };
    return p.y() > 1 || !is_solid(middle(p.x()), middle(p.y()), middle(p.z()));
  };
  soup.cells.erase(std::remove_if(soup.cells.begin(), soup.cells.end(), is_outside), soup.cells.end());
  soup.facets.clear();
  VMP::remove_isolated_points(soup);
  return soup;
}

bool lies_in_plane(const Triangle& t, int axis, double value) {
  return t[0][axis] == value && t[1][axis] == value && t[2][axis] == value;
}

bool lies_on_side(const Triangle& t, int axis) {
  return lies_in_plane(t, axis, 0) || lies_in_plane(t, axis, 1);
}

// Two critical points of f, of index 1 and 2, both on a wall or both inside, and a product all the same.
template <typename Label>
void check(const char* name, const Soup& soup, const Label& label, bool on_wall) {
  Mesh mesh;
  VMP::Boundary_partition_3 summary;
  VMP::Preparation counts;
  VMP::Status status = mesh.assign(soup);
  if (status.ok()) status = VMP::check_tetrahedral_mesh(mesh);
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    mesh.set_label(f, label(Triangle(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]))));
  }
  if (status.ok()) status = VMP::validate_partition(mesh, summary);
  if (status.ok()) status = VMP::prepare_patches(mesh, counts);
  std::cout << name << ", " << mesh.number_of_cells() << " cells, genus " << summary.genus << ": "
            << status.message() << std::endl;
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
    assert(c.on_wall == on_wall);
    of_index[c.index] += c.multiplicity;
  }
  assert(of_index[0] == 0 && of_index[1] == 1 && of_index[2] == 1 && of_index[3] == 0);

  VMP::Product_structure_3<Kernel> structure;
  VMP::Sweep_report report;
  status = VMP::sweep_with_repairs(mesh, flux_guide<Mesh>, structure, report);
  if (status.ok()) status = VMP::verify_product(mesh, structure.order());
  std::cout << "sweep, left at first " << report.left_at_first << ": " << status.message() << std::endl;
  assert(status.ok());
}

// An arch that stands on the bottom of a cube, with a gap in the middle of its beam: bottom and arch are the floor. The
// level sets of f pass around and under the beam, grow together in the gap and close the hole under it.
void test_arch() {
  const auto is_in_arch = [](double x, double y, double z) {
    constexpr double half_width = 0.075, thickness = 0.15, height = 0.6, half_span = 0.3, half_gap = 0.05;
    const double from_middle = std::abs(x - 0.5);
    if (std::abs(y - 0.5) > half_width || z > height || from_middle > half_span) return false;
    return from_middle > half_span - thickness || (z > height - thickness && from_middle > half_gap);
  };
  const auto label = [](const Triangle& t) {
    if (lies_in_plane(t, 2, 1)) return VMP::CEILING;
    return lies_on_side(t, 0) || lies_on_side(t, 1) ? VMP::FIRST_WALL : VMP::FLOOR;
  };
  const auto is_solid = [&](double x, double y, double z) { return !is_in_arch(x, y, z); };
  check("arch with a gap", solid_of_cubes(20, 1, is_solid), label, false);
}

// A ring in the plane with a slot.
bool is_in_letter_c(double x, double y) {
  const double from_middle = std::max(std::abs(x - 0.5), std::abs(y - 0.5));
  return from_middle < 0.4 && from_middle > 0.2 && !(y < 0.5 && std::abs(x - 0.5) < 0.1);
}

// A plate whose floor is a letter C on its bottom. The rest of the bottom is wall: on it f has a maximum inside the C,
// which is no maximum in the plate, and a saddle in its slot.
void test_plate() {
  const double height = 0.4;
  const auto label = [&](const Triangle& t) {
    if (lies_in_plane(t, 2, height)) return VMP::CEILING;
    const Point p = CGAL::centroid(t);
    return lies_in_plane(t, 2, 0) && is_in_letter_c(p.x(), p.y()) ? VMP::FLOOR : VMP::FIRST_WALL;
  };
  const auto is_solid = [](double, double, double) { return true; };
  check("plate with a C-shaped floor", solid_of_cubes(20, height, is_solid), label, true);
}

// A cube with a cavity in the shape of a C, the floor, and a tube to it from the top, the wall: f is nearly flat inside the
// C, and passes through its slot.
void test_cavity() {
  const double bottom = 0.4, top = 0.6;
  const auto is_solid = [&](double x, double y, double z) {
    const bool is_in_tube = z > bottom && std::abs(x - 0.5) < 0.1 && y > 0.7 && y < 0.9;
    return !is_in_tube && !(z > bottom && z < top && is_in_letter_c(x, y));
  };
  const auto label = [&](const Triangle& t) {
    if (lies_on_side(t, 0) || lies_on_side(t, 1) || lies_on_side(t, 2)) return VMP::CEILING;
    return CGAL::centroid(t).z() > top + 0.01 ? VMP::FIRST_WALL : VMP::FLOOR;
  };
  check("cube with a C-shaped cavity", solid_of_cubes(20, 1, is_solid), label, false);
}

// Solids whose harmonic function has critical points, against the theorem of Xia et al. 2010, but which are products.
int main() {
  test_arch();
  test_plate();
  test_cavity();
  return EXIT_SUCCESS;
}
