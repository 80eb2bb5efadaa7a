#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/label_polycube.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize_polycube.h>

#include "io_test_util.h"
#include "polycube_test_util.h"
#include "test_util.h"

#include <cassert>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;

Mesh polycube(const std::vector<Cell>& cells, std::size_t number_of_tetrahedra = 0) {
  Mesh mesh;
  const VMP::Status status = VMP::tetrahedralize_polycube(cubes<Point_3>(cells), mesh, number_of_tetrahedra);
  assert(status.ok());
  return mesh;
}

Point_3 center(const Mesh& mesh, VMP::Facet_index f) {
  const auto v = mesh.vertices(f);
  return CGAL::centroid(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
}

// A facet in a plane.
VMP::Facet_index facet_at(const Mesh& mesh, int axis, double height) {
  for (VMP::Facet_index f : mesh.boundary_facets())
    if (center(mesh, f)[axis] == height) return f;
  assert(false);
  return {};
}

// Every floor facet lies at its place, and the other way round.
template <typename Is_floor, typename Is_ceiling>
void expect_bases(const Mesh& mesh, const Is_floor& is_floor, const Is_ceiling& is_ceiling) {
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const Point_3 p = center(mesh, f);
    assert((mesh.label(f) == VMP::FLOOR) == is_floor(p) && (mesh.label(f) == VMP::CEILING) == is_ceiling(p));
  }
}

void test_picks() {
  for (std::size_t tetrahedra : {0, 3000}) {
    Mesh mesh = polycube(overhang(), tetrahedra);
    mesh.set_label(facet_at(mesh, 2, 0), VMP::FLOOR);
    mesh.set_label(facet_at(mesh, 2, 4), VMP::CEILING);
    mesh.set_label(facet_at(mesh, 0, 3), 17); // does not matter
    VMP::Status status = VMP::label_polycube(mesh);
    assert(status.ok());
    expect_bases(
        mesh, [](const Point_3& p) { return p.z() == 0; }, [](const Point_3& p) { return p.z() == 4; });
    // two floors: not connected
    for (VMP::Facet_index f : mesh.boundary_facets())
      if (center(mesh, f).z() == 2) mesh.set_label(f, VMP::FLOOR);
    expect(VMP::label_polycube(mesh), VMP::ERROR_PATCH_NOT_CONNECTED);
  }
  // several faces, of any direction: the treads and risers of stairs are the ceiling
  Mesh stairs = polycube({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {2, 0, 0}, {2, 0, 1}, {2, 0, 2}}, 1000);
  const auto is_tread = [](const Point_3& p) {
    return p.z() == 3 || (p.z() == 2 && p.x() < 2) || (p.z() == 1 && p.x() < 1) ||
           (p.x() == 1 && p.z() > 1) || (p.x() == 2 && p.z() > 2);
  };
  for (VMP::Facet_index f : stairs.boundary_facets()) {
    const Point_3 p = center(stairs, f);
    stairs.set_label(f, p.z() == 0 ? VMP::FLOOR : is_tread(p) ? VMP::CEILING : VMP::INTERIOR);
  }
  const VMP::Status status = VMP::label_polycube(stairs);
  if (!status.ok()) std::cerr << status.message() << std::endl;
  assert(status.ok());
  expect_bases(
      stairs, [](const Point_3& p) { return p.z() == 0; }, is_tread);
}

// One label for each wall of a ring.
void test_walls() {
  Mesh mesh = polycube(ring(), 2000);
  const VMP::Status status = VMP::label_polycube(mesh, 2);
  assert(status.ok());
  int outer = 0, inner = 0;
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const Point_3 p = center(mesh, f);
    if (mesh.label(f) < VMP::FIRST_WALL) continue;
    const bool is_inner = p.x() > .5 && p.x() < 2.5 && p.y() > .5 && p.y() < 2.5;
    int& label = is_inner ? inner : outer;
    assert(label == 0 || label == mesh.label(f));
    label = mesh.label(f);
  }
  assert(outer + inner == 2 * VMP::FIRST_WALL + 1);
}

void test_heights() {
  Mesh mesh = polycube(overhang());
  VMP::Status status = VMP::label_polycube(mesh, 2, false);
  assert(status.ok());
  expect_bases(
      mesh, [](const Point_3& p) { return p.z() == 4; }, [](const Point_3& p) { return p.z() == 0; });
  status = VMP::label_polycube_by_height(mesh);
  assert(status.ok());
  expect_bases(
      mesh, [](const Point_3& p) { return p.z() == 0; }, [](const Point_3& p) { return p.z() == 4; });
  expect(VMP::label_polycube(mesh, 0), VMP::ERROR_PATCH_NOT_CONNECTED, "floor");
  // two feet: upwards it is not legal, but along y
  mesh = polycube({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {2, 0, 0}});
  status = VMP::label_polycube_by_height(mesh);
  assert(status.ok());
  expect_bases(
      mesh, [](const Point_3& p) { return p.y() == 0; }, [](const Point_3& p) { return p.y() == 1; });
  // a block with two feet on each of three sides
  std::vector<Cell> cells = {{0, 1, -1}, {2, 1, -1}, {1, -1, 0}, {1, -1, 2}, {-1, 0, 1}, {-1, 2, 1}};
  for (int i = 0; i < 27; ++i) cells.push_back({i % 3, i / 3 % 3, i / 9});
  mesh = polycube(cells);
  expect(VMP::label_polycube_by_height(mesh), VMP::ERROR_NO_PARTITION, "along");
}

void test_refusals() {
  Mesh mesh = polycube({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  expect(VMP::label_polycube(mesh), VMP::ERROR_NUMBER_OF_PATCHES, "floor");
  for (VMP::Facet_index f : mesh.boundary_facets()) mesh.set_label(f, VMP::INTERIOR);
  const VMP::Facet_index f = facet_at(mesh, 2, 0);
  for (VMP::Facet_index g : mesh.boundary_facets())
    if (center(mesh, g).z() == 0) mesh.set_label(g, VMP::CEILING);
  mesh.set_label(f, VMP::FLOOR);
  expect(VMP::label_polycube(mesh), VMP::ERROR_WRONG_PARAMETER, "floor and as ceiling");
  // neighbors
  mesh.set_label(facet_at(mesh, 0, 0), VMP::FLOOR);
  mesh.set_label(f, VMP::CEILING);
  expect(VMP::label_polycube(mesh), VMP::ERROR_FLOOR_MEETS_CEILING);

  const auto tilted = transformed(VMP::make_soup(mesh),
                                  [](const Point_3& p) { return Point_3(p.x() + p.z(), p.y(), p.z()); });
  const VMP::Status status = mesh.assign(tilted);
  assert(status.ok());
  expect(VMP::label_polycube(mesh), VMP::ERROR_NOT_A_POLYCUBE);
  expect(VMP::label_polycube(mesh, 2), VMP::ERROR_NOT_A_POLYCUBE);
  expect(VMP::label_polycube_by_height(mesh), VMP::ERROR_NOT_A_POLYCUBE);
}

int main() {
  test_picks();
  test_walls();
  test_heights();
  test_refusals();
  return EXIT_SUCCESS;
}
