#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Averaged_gradient_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>

#include "test_util.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Field = VMP::Averaged_gradient_field_3<Mesh>;
using Curve = VMP::Averaged_gradient_curve_3;

Mesh mesh_of(const Soup& soup) {
  Mesh mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  return mesh;
}

std::vector<double> values(const Mesh& mesh) {
  VMP::Harmonic_function_3<Mesh> f(mesh);
  const VMP::Status status = f.solve();
  assert(status.ok());
  return f.values();
}

// the end, computed from its facet and weights
Kernel::Point_3 end_on_facet(const Mesh& mesh, const Curve& curve) {
  const auto v = mesh.vertices(curve.facet);
  const auto& w = curve.weights;
  return CGAL::barycenter(mesh.point(v[0]), w[0], mesh.point(v[1]), w[1], mesh.point(v[2]), w[2]);
}

void test_block(int holes) {
  const double height = 1.5;
  const Mesh mesh = mesh_of(jitter_interior(Block_with_holes<Point>(holes, 4, 5, height).soup(), 0.06, 7));
  const Field field(mesh, values(mesh));
  for (int base : {VMP::FLOOR, VMP::CEILING}) {
    const Field::Arrivals inside = field.arrivals(base), on_walls = field.arrivals_on_walls(base);
    assert(inside.arrived > 0 && inside.share() == 1);
    assert(on_walls.arrived > 0 && on_walls.share() == 1);
    for (VMP::Vertex_index v : mesh.vertices()) {
      const Point& p = mesh.point(v);
      const Curve curve = field.trace(v, base, true);
      const double way = base == VMP::FLOOR ? p.z() : height - p.z();
      if (way == height) continue; // from base to base; on the rim there is no room for rounding
      assert(curve.end == Curve::ARRIVED && mesh.label(curve.facet) == base);
      assert(std::abs(curve.length - way) < 1e-9);
      assert(std::abs(curve.point.x() - p.x()) < 1e-9 && std::abs(curve.point.y() - p.y()) < 1e-9);
      assert(std::abs(curve.point.z() - (base == VMP::FLOOR ? 0 : height)) < 1e-9);
      const Point q = end_on_facet(mesh, curve);
      assert((VMP::internal::approximate(q) - curve.point).squared_length() < 1e-20);
      if (way > 0) assert(curve.polyline.size() > 1 && curve.polyline.back() == curve.point);
    }
  }
}

void test_from_inside_a_cell() {
  const Mesh mesh = mesh_of(Block_with_holes<Point>(1, 3, 3).soup());
  const Field field(mesh, values(mesh));
  for (VMP::Cell_index c : mesh.cells()) {
    const Curve up = field.trace(c, {0.1, 0.2, 0.3, 0.4}, VMP::CEILING);
    const Curve down = field.trace(c, {0.1, 0.2, 0.3, 0.4}, VMP::FLOOR);
    assert(up.end == Curve::ARRIVED && down.end == Curve::ARRIVED);
    assert(std::abs(up.length + down.length - 1) < 1e-9);
    assert(up.polyline.empty());
  }
}

// Averages of a linear function's gradients are that gradient; on a wall its part along the wall.
void test_vectors() {
  const Mesh mesh = mesh_of(jitter_interior(Block_with_holes<Point>(0, 3, 3).soup(), 0.08, 1));
  std::vector<double> values;
  for (const Point& p : mesh.points()) values.push_back(2 * p.x() - p.y() + 3 * p.z());
  const Field field(mesh, values);
  const Field::Vector_3 slope(2, -1, 3);
  for (VMP::Vertex_index v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    assert((field.vector(v) - slope).squared_length() < 1e-22);
    const bool on_x = p.x() == 0 || p.x() == 1, on_y = p.y() == 0 || p.y() == 3,
               between = p.z() > 0 && p.z() < 1;
    if (between && on_x && !on_y)
      assert((field.wall_vector(v) - Field::Vector_3(0, -1, 3)).squared_length() < 1e-22);
    if (between && on_y && !on_x)
      assert((field.wall_vector(v) - Field::Vector_3(2, 0, 3)).squared_length() < 1e-22);
  }
}

// Fields that do not lead to the base: sideways out through a wall, around for ever, nowhere.
void test_other_ends() {
  const Mesh mesh = mesh_of(Block_with_holes<Point>(0, 4, 4).soup());
  std::vector<double> sideways, valley, flat(mesh.number_of_vertices(), 0.5);
  for (const Point& p : mesh.points()) {
    sideways.push_back(p.x() + 0.001 * p.z());
    valley.push_back(CGAL::square(p.x() - 0.5) + CGAL::square(p.y() - 1.5) + CGAL::square(p.z() - 0.5));
  }
  const Field::Arrivals left = Field(mesh, sideways).arrivals(VMP::CEILING);
  assert(left.left_through_wall > 0 && left.arrived == 0 && left.stuck == 0 && left.share() == 0);
  const Field::Arrivals stuck = Field(mesh, valley, 0.25, 200).arrivals(VMP::FLOOR);
  assert(stuck.stuck > 0 && stuck.arrived == 0 && stuck.left_through_wall == 0);
  const Field::Arrivals still = Field(mesh, flat).arrivals(VMP::FLOOR);
  assert(still.stuck == stuck.stuck);
  assert(!Field(mesh, flat).trace(VMP::Cell_index(0), {0.25, 0.25, 0.25, 0.25}, VMP::FLOOR).facet.is_valid());
}

// An unused vertex lies nowhere.
void test_unused_vertex() {
  Soup soup = Block_with_holes<Point>(0, 2, 2).soup();
  soup.points.push_back(Point(5, 5, 5));
  const Mesh mesh = mesh_of(soup);
  const Field field(mesh, std::vector<double>(mesh.number_of_vertices(), 0));
  assert(field.trace(VMP::Vertex_index(mesh.number_of_vertices() - 1), VMP::FLOOR).end == Curve::STUCK);
}

int main() {
  for (int holes : {0, 1, 2}) test_block(holes);
  test_from_inside_a_cell();
  test_vectors();
  test_other_ends();
  test_unused_vertex();
  std::cout << "done\n";
  return EXIT_SUCCESS;
}
