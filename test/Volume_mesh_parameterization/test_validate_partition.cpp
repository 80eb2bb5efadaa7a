#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>

#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Kernel::Point_3>;

Mesh make_mesh(const Soup& soup) {
  Mesh mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  return mesh;
}

Mesh make_block(int holes, int m = 3, int layers = 3) {
  return make_mesh(Block_with_holes<Kernel::Point_3>(holes, m, layers).soup());
}

VMP::Error_code code_of(const Mesh& mesh) {
  VMP::Boundary_partition_3 summary;
  return VMP::validate_partition(mesh, summary).code();
}

Kernel::Point_3 center(const Mesh& mesh, VMP::Facet_index f) {
  const auto v = mesh.vertices(f);
  return CGAL::centroid(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
}

// Gives the label to the facets whose center is in the region.
void paint(Mesh& mesh, int label, const std::function<bool(const Kernel::Point_3&)>& region) {
  for (VMP::Facet_index f : mesh.boundary_facets())
    if (region(center(mesh, f))) mesh.set_label(f, label);
}

void test_block(int holes) {
  const Mesh mesh = make_block(holes);
  VMP::Boundary_partition_3 summary;
  VMP::Status status = VMP::validate_partition(mesh, summary);
  assert(status.ok());
  assert(summary.genus == holes && summary.patches.size() == std::size_t(holes + 3));
  assert(summary.patches[0].name() == "floor" && summary.patches[1].name() == "ceiling");
  assert(summary.patches[2].name() == "wall 0" && summary.find(VMP::FIRST_WALL + holes + 1) == nullptr);
  assert(std::abs(summary.find(VMP::FLOOR)->area - (3 * (2 * holes + 1) - holes)) < 1e-9);
  if (holes > 0) assert(std::abs(summary.find(VMP::FIRST_WALL + 1)->area - 4) < 1e-9);
  VMP::Handlebody_certificate certificate;
  status = VMP::certify_handlebody(mesh, certificate);
  assert(status.ok());
  status = VMP::validate_fundamental_group(mesh, certificate);
  assert(status.ok());
}

void test_labels() {
  Mesh mesh = make_block(1);
  mesh.set_label(VMP::Facet_index(5), 0);
  assert(code_of(mesh) == VMP::ERROR_UNLABELLED_FACET);
  mesh.set_label(VMP::Facet_index(5), 6);
  assert(code_of(mesh) == VMP::ERROR_NUMBER_OF_PATCHES);
  mesh.set_label(VMP::Facet_index(5), -3);
  assert(code_of(mesh) == VMP::ERROR_NUMBER_OF_PATCHES);
  mesh = make_block(1);
  for (VMP::Facet_index f : mesh.boundary_facets())
    if (mesh.label(f) == VMP::FIRST_WALL + 1) mesh.set_label(f, VMP::FIRST_WALL);
  assert(code_of(mesh) == VMP::ERROR_NUMBER_OF_PATCHES);
}

// The squares of edge 1/3 of the floor whose lower left corner is (i, j) / 3.
auto is_square(int i, int j) {
  return [=](const Kernel::Point_3& p) { return p.z() == 0 && int(3 * p.x()) == i && int(3 * p.y()) == j; };
}

void test_patches() {
  Mesh mesh = make_block(0);
  paint(mesh, VMP::FIRST_WALL, is_square(1, 4));
  assert(code_of(mesh) == VMP::ERROR_PATCH_NOT_CONNECTED);
  // both walls reach into the floor and touch in a vertex, the floor being on both sides of it
  mesh = make_block(1);
  paint(mesh, VMP::FIRST_WALL + 1, is_square(2, 4));
  paint(mesh, VMP::FIRST_WALL + 1, is_square(1, 4));
  assert(code_of(mesh) == VMP::OK);
  paint(mesh, VMP::FIRST_WALL, is_square(0, 5));
  assert(code_of(mesh) == VMP::ERROR_PATCH_NOT_A_SURFACE);
  // they touch in an edge
  paint(mesh, VMP::FLOOR, is_square(0, 5));
  paint(mesh, VMP::FIRST_WALL, is_square(0, 4));
  assert(code_of(mesh) == VMP::ERROR_WALLS_MEET);
  // the ceiling comes down to the floor
  mesh = make_block(0);
  paint(mesh, VMP::CEILING, [](const Kernel::Point_3& p) { return p.x() == 0 && p.y() < 1. / 3; });
  assert(code_of(mesh) == VMP::ERROR_FLOOR_MEETS_CEILING);
}

// Floor and wall 1 are disks, wall 0 is the rest of a torus.
void test_topology() {
  Mesh mesh = make_block(1);
  paint(mesh, VMP::FIRST_WALL, [](const Kernel::Point_3&) { return true; });
  paint(mesh, VMP::FLOOR, is_square(1, 4));
  paint(mesh, VMP::CEILING, [](const Kernel::Point_3& p) { return p.z() == 1 && p.x() < 1; });
  paint(mesh, VMP::FIRST_WALL + 1, [](const Kernel::Point_3& p) {
    return p.z() == 1 && 3 * p.x() > 1 && 3 * p.x() < 2 && p.y() > 1 && p.y() < 2;
  });
  assert(code_of(mesh) == VMP::ERROR_PATCH_TOPOLOGY);
}

// In a double torus, floor and ceiling are the left and the right half, a band around the middle is wall 2, and walls
// 0 and 1 are bands around a handle of the floor and one of the ceiling.
void test_wall_rims() {
  Mesh mesh = make_block(2);
  paint(mesh, VMP::FLOOR, [](const Kernel::Point_3& p) { return p.x() < 2.5; });
  paint(mesh, VMP::CEILING, [](const Kernel::Point_3& p) { return p.x() > 2.5; });
  const auto band = [&](int label, double x, double largest_y) {
    paint(mesh, label, [=](const Kernel::Point_3& p) {
      return p.x() > x - 1. / 6 && p.x() < x + 1. / 6 && p.y() <= largest_y;
    });
  };
  band(VMP::FIRST_WALL, 1.5, 1);
  band(VMP::FIRST_WALL + 1, 3.5, 1);
  band(VMP::FIRST_WALL + 2, 2.5, 3);
  assert(code_of(mesh) == VMP::ERROR_WALL_RIMS);
}

// Four bands around the tube of a solid torus: all counts are right, but the floor's loop bounds a disk in the solid.
void test_not_onto() {
  Mesh mesh = make_block(1);
  paint(mesh, VMP::FLOOR, [](const Kernel::Point_3& p) { return p.y() <= 1; });
  paint(mesh, VMP::CEILING, [](const Kernel::Point_3& p) { return p.y() >= 2; });
  paint(mesh, VMP::FIRST_WALL, [](const Kernel::Point_3& p) { return p.x() <= 1; });
  paint(mesh, VMP::FIRST_WALL + 1, [](const Kernel::Point_3& p) { return p.x() >= 2; });
  assert(code_of(mesh) == VMP::OK);
  VMP::Handlebody_certificate certificate;
  const VMP::Status status = VMP::certify_handlebody(mesh, certificate);
  assert(status.ok());
  assert(VMP::validate_fundamental_group(mesh, certificate).code() == VMP::ERROR_FLOOR_NOT_ONTO);
}

// Two tetrahedra that share their first vertices; the second one is the first one's reflection in the others.
Mesh make_pair(std::size_t shared) {
  using Point = Kernel::Point_3;
  Soup soup;
  soup.points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)};
  soup.cells = {{0, 1, 2, 3}, {0, 1, 2, 3}};
  for (std::size_t i = shared; i < 4; ++i) {
    soup.cells[1][i] = soup.points.size();
    soup.points.push_back(Point(-soup.points[i].x(), -soup.points[i].y(), -soup.points[i].z() - 1));
  }
  return make_mesh(soup);
}

void test_boundary() {
  assert(code_of(Mesh()) == VMP::ERROR_EMPTY_MESH);
  assert(code_of(make_pair(0)) == VMP::ERROR_SEVERAL_COMPONENTS);
  assert(code_of(make_pair(1)) == VMP::ERROR_NON_MANIFOLD);
  assert(code_of(make_pair(2)) == VMP::ERROR_NON_MANIFOLD);
  const VMP::Vertex_index a(0), b(1), c(2);
  assert(VMP::internal::Facet_adjacency(3, {{a, b, c}}).status().code() == VMP::ERROR_OPEN_SURFACE);
  assert(VMP::internal::Facet_adjacency(3, {{a, b, c}, {a, b, c}}).status().code() ==
         VMP::ERROR_NON_MANIFOLD);
  assert(VMP::internal::Facet_adjacency(3, {{a, b, c}, {a, c, b}}).status().ok());
}

bool is_whole_group(int rank, const std::vector<std::vector<int>>& words) {
  VMP::internal::Stallings_graph graph(rank);
  const auto base = graph.add_node();
  for (const std::vector<int>& word : words) graph.add_path(base, word, base);
  return graph.is_whole_group();
}

void test_folding() {
  assert(is_whole_group(0, {}));
  assert(!is_whole_group(1, {}) && is_whole_group(1, {{-1}}) && !is_whole_group(1, {{1, 1}}));
  assert(is_whole_group(1, {{1, 1}, {1, 1, 1}}));
  assert(is_whole_group(2, {{1}, {2}}) && is_whole_group(2, {{2, 1, 1}, {1}}) && !is_whole_group(2, {{1}}));
  // onto in homology, with determinant 1, but not onto
  assert(!is_whole_group(2, {{1}, {2, 1, 2, -1, -2}}));
  assert(is_whole_group(2, {{1}, {2, 1, 2, -1, -2}, {1, 2, 1, 1}}));
  // a basis after Nielsen moves, and one that is dependent in homology
  assert(is_whole_group(3, {{1, 2}, {2, 3}, {3}}));
  assert(!is_whole_group(3, {{1, 2}, {2, 3, 3}, {2, 3, 3, 2, 1}}));
}

int main() {
  for (int holes = 0; holes <= 4; ++holes) test_block(holes);
  test_labels();
  test_patches();
  test_topology();
  test_wall_rims();
  test_not_onto();
  test_boundary();
  test_folding();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
