#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>

#include "io_test_util.h"
#include "test_util.h"

#include <cassert>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <utility>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;

Mesh mesh_of(const Soup& soup) {
  Mesh mesh;
  expect(mesh.assign(soup), VMP::OK);
  return mesh;
}

void refuse(const Soup& soup, VMP::Error_code code, const std::string& culprit) {
  expect(VMP::check_tetrahedral_mesh(mesh_of(soup)), code, culprit);
}

// A block of 4 x 12 x layers cubes of which those for which is_removed(x, y, z) are left out.
template <typename IsRemoved>
Soup carved_block(int layers, const IsRemoved& is_removed) {
  const Soup block = Block_with_holes<Point>(0, 4, layers).soup();
  Soup soup;
  soup.points = block.points;
  for (std::size_t c = 0; c < block.cells.size(); ++c) {
    const int cube = int(c / 6);
    if (!is_removed(cube / layers / 12, cube / layers % 12, cube % layers)) soup.cells.push_back(block.cells[c]);
  }
  VMP::remove_isolated_points(soup);
  return soup;
}

void test_good_meshes() {
  for (int holes = 0; holes <= 3; ++holes) {
    const Mesh mesh = mesh_of(Block_with_holes<Point>(holes, 2, 2).soup());
    expect(VMP::check_tetrahedral_mesh(mesh), VMP::OK);
    assert(VMP::summarize_partition(mesh).genus == holes);
  }
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  VMP::Compact_tetrahedral_mesh_3<Exact> exact;
  expect(exact.assign(Block_with_holes<Exact::Point_3>(1, 1, 1).soup()), VMP::OK);
  expect(VMP::check_tetrahedral_mesh(exact), VMP::OK);
  const Mesh tunnel = mesh_of(carved_block(3, [](int x, int y, int) { return x == 1 && y == 1; }));
  expect(VMP::check_tetrahedral_mesh(tunnel), VMP::OK);
  assert(VMP::summarize_partition(tunnel).genus == 1);
}

void test_geometry() {
  Soup one;
  one.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  one.cells = {{0, 1, 2, 3}};
  refuse(one, VMP::OK, "");
  one.cells = {{0, 2, 1, 3}};
  refuse(one, VMP::ERROR_INVERTED_TETRAHEDRON, "tetrahedron 0 with vertices 0, 2, 1 and 3");
  one.points[3] = Point(.1, .1, 0);
  refuse(one, VMP::ERROR_FLAT_TETRAHEDRON, "tetrahedron 0");
  one.points[3] = Point(.1, .1, std::numeric_limits<double>::denorm_min()); // decided exactly
  refuse(one, VMP::ERROR_INVERTED_TETRAHEDRON, "tetrahedron 0");
  one.points[3] = Point(0, 0, std::numeric_limits<double>::infinity());
  refuse(one, VMP::ERROR_COORDINATE_NOT_FINITE, "vertex 3");
  expect(VMP::check_tetrahedral_mesh(Mesh()), VMP::ERROR_EMPTY_MESH, "no tetrahedra");

  Soup block = Block_with_holes<Point>(0, 2, 2).soup();
  for (Point& p : block.points)
    if (p == Point(.5, .5, .5)) p = Point(.5, .5, 5);
  refuse(block, VMP::ERROR_INVERTED_TETRAHEDRON, "tetrahedron");
}

void test_topology() {
  refuse(carved_block(1, [](int, int y, int) { return y == 3; }), VMP::ERROR_SEVERAL_COMPONENTS, "2 parts");
  refuse(carved_block(3, [](int x, int y, int z) { return x == 1 && y == 1 && z == 1; }),
         VMP::ERROR_SEVERAL_COMPONENTS, "boundary has 2 components");
  // two cubes that share but an edge of one layer, or of all
  const auto is_beside_edge = [](int x, int y) { return (x == 1 && y == 1) || (x == 2 && y == 2); };
  refuse(carved_block(1, [&](int x, int y, int) { return is_beside_edge(x, y); }), VMP::ERROR_NON_MANIFOLD,
         "joins 2 groups of tetrahedra");
  refuse(carved_block(3, [&](int x, int y, int z) { return z == 1 && is_beside_edge(x, y); }),
         VMP::ERROR_NON_MANIFOLD, "is no disk: its Euler number is");
  // of the eight cubes around the middle only two opposite ones
  refuse(carved_block(4,
                      [](int x, int y, int z) {
                        return (x == 1 || x == 2) && (y == 1 || y == 2) && (z == 1 || z == 2) && !(x == y && y == z);
                      }),
         VMP::ERROR_NON_MANIFOLD, "joins 2 groups of tetrahedra");

  Soup more = Block_with_holes<Point>(1, 1, 1).soup();
  const Soup block = more;
  more.points.emplace_back(7, 7, 7);
  refuse(more, VMP::ERROR_NON_MANIFOLD, "vertex " + std::to_string(block.points.size()) + " is in no tetrahedron");
  VMP::remove_isolated_points(more);
  assert(more.points == block.points && more.cells == block.cells);
}

void test_checks_alone() {
  Soup two;
  two.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  two.cells = {{0, 1, 2, 3}, {0, 5, 4, 6}};
  const Mesh mesh = mesh_of(two);
  expect(VMP::check_orientations(mesh), VMP::OK);
  expect(VMP::check_connected(mesh), VMP::ERROR_SEVERAL_COMPONENTS, "2 parts");
  expect(VMP::check_vertex_links(mesh), VMP::ERROR_NON_MANIFOLD, "vertex 0 joins 2 groups");
  expect(VMP::check_boundary_connected(mesh), VMP::OK);
}

void test_orient_cells() {
  const Soup good = Block_with_holes<Point>(1, 1, 1).soup();
  Soup soup = good;
  assert(!VMP::orient_cells(soup) && soup.cells == good.cells);
  for (auto& cell : soup.cells) std::swap(cell[0], cell[1]);
  const Soup negative = soup;
  assert(VMP::orient_cells(soup));
  refuse(soup, VMP::OK, "");
  soup = negative;
  std::swap(soup.cells[5][0], soup.cells[5][1]);
  const Soup mixed = soup;
  assert(!VMP::orient_cells(soup) && soup.cells == mixed.cells);
  soup = negative;
  soup.cells[5][2] = soup.points.size();
  assert(!VMP::orient_cells(soup));
  soup = negative;
  soup.points[5] = Point(0, 0, std::numeric_limits<double>::quiet_NaN());
  assert(!VMP::orient_cells(soup));
  soup = Soup();
  assert(!VMP::orient_cells(soup));
}

int main() {
  test_good_meshes();
  test_geometry();
  test_topology();
  test_checks_alone();
  test_orient_cells();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
