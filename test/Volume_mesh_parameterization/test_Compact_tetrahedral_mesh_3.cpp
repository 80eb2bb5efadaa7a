#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>

#include "test_util.h"

#include <array>
#include <cassert>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;

void test_adjacency_is_symmetric(const Mesh& mesh) {
  for (VMP::Facet_index f : mesh.facets()) {
    const VMP::Half_facet h = mesh.half_facet(f);
    assert(mesh.facet(h.cell, h.index) == f);
    if (mesh.is_boundary(f)) {
      assert(!mesh.neighbor(h.cell, h.index).is_valid());
      continue;
    }
    const VMP::Half_facet o = mesh.opposite(h);
    assert(mesh.opposite(o).cell == h.cell && mesh.opposite(o).index == h.index);
    for (VMP::Vertex_index v : mesh.vertices(h)) assert(mesh.index(o.cell, v) >= 0 && mesh.index(o.cell, v) != o.index);
  }
}

// Euler number of the surface: 2 - 2 genus. Labels: every facet got one.
void test_block(int holes) {
  const Block_with_holes<Point> block(holes, 2, 3);
  Mesh mesh;
  const VMP::Status status = mesh.assign(block.soup());
  assert(status.ok());
  test_adjacency_is_symmetric(mesh);
  std::vector<char> on_boundary(mesh.number_of_vertices(), 0);
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    assert(mesh.label(f) >= VMP::FLOOR && mesh.label(f) <= VMP::FIRST_WALL + holes);
    for (VMP::Vertex_index v : mesh.vertices(f)) on_boundary[v] = 1;
  }
  const long vertices = std::count(on_boundary.begin(), on_boundary.end(), 1);
  assert(vertices - long(mesh.number_of_boundary_facets()) / 2 == 2 - 2 * holes);
  for (VMP::Cell_index c : mesh.cells())
    assert(CGAL::orientation(mesh.point(mesh.vertex(c, 0)), mesh.point(mesh.vertex(c, 1)), mesh.point(mesh.vertex(c, 2)),
                             mesh.point(mesh.vertex(c, 3))) == CGAL::POSITIVE);
}

// A label that is set is had by the facet, seen from its cell too, and by no other.
void test_labels() {
  Mesh mesh;
  const VMP::Status status = mesh.assign(Block_with_holes<Point>(0, 1, 1).soup());
  assert(status.ok());
  for (VMP::Facet_index f : mesh.boundary_facets()) mesh.set_label(f, VMP::INTERIOR);
  const VMP::Facet_index first(0);
  const VMP::Half_facet h = mesh.half_facet(first);
  for (VMP::Boundary_label label : {VMP::FLOOR, VMP::CEILING, VMP::FIRST_WALL}) {
    mesh.set_label(first, label);
    assert(mesh.label(h.cell, h.index) == label);
    for (VMP::Facet_index f : mesh.facets()) assert(mesh.label(f) == (f == first ? label : VMP::INTERIOR));
  }
}

// Says that it has more cells than 32 bits can number the edges of, and never shows one.
struct Huge_mesh {
  std::size_t number_of_vertices() const { return 4; }
  std::size_t number_of_cells() const { return Mesh::most_cells + 1; }
  Point point(std::size_t) const { std::abort(); }
  std::array<std::size_t, 4> cell(std::size_t) const { std::abort(); }
  std::vector<VMP::Labelled_facet> labelled_facets() const { std::abort(); }
};

template <typename TetrahedralMesh>
VMP::Error_code code_of(const TetrahedralMesh& given) {
  Mesh mesh;
  const VMP::Error_code code = mesh.assign(given).code();
  assert(code == VMP::OK || mesh.number_of_cells() == 0);
  return code;
}

void test_refusals() {
  const Soup good = Block_with_holes<Point>(0, 1, 1).soup();
  assert(code_of(good) == VMP::OK);
  assert(code_of(Soup()) == VMP::ERROR_EMPTY_MESH);
  assert(code_of(Huge_mesh()) == VMP::ERROR_WRONG_PARAMETER);
  Soup bad = good;
  bad.cells[3][2] = bad.points.size();
  assert(code_of(bad) == VMP::ERROR_INDEX_OUT_OF_RANGE);
  bad = good;
  bad.cells[3][2] = bad.cells[3][1];
  assert(code_of(bad) == VMP::ERROR_INDEX_OUT_OF_RANGE);
  bad = good;
  bad.cells.push_back(bad.cells[0]);
  bad.cells.push_back(bad.cells[0]);
  assert(code_of(bad) == VMP::ERROR_NON_MANIFOLD);
  bad = good;
  bad.facets[0].vertices = {0, 0, 0};
  assert(code_of(bad) == VMP::ERROR_LABEL_NOT_ON_BOUNDARY);
  bad = good;
  bad.facets[0].vertices[1] += std::size_t(1) << 32; // the same in 32 bits
  assert(code_of(bad) == VMP::ERROR_LABEL_NOT_ON_BOUNDARY);
  bad = good;
  bad.facets.push_back(bad.facets[0]);
  assert(code_of(bad) == VMP::OK);
  ++bad.facets.back().label;
  assert(code_of(bad) == VMP::ERROR_LABEL_NOT_ON_BOUNDARY);
}

// A mesh that knows the cells behind facets.
struct Mesh_with_neighbors : Soup {
  explicit Mesh_with_neighbors(const Soup& soup) : Soup(soup) {
    Mesh mesh;
    const VMP::Status status = mesh.assign(soup);
    assert(status.ok());
    for (VMP::Cell_index c : mesh.cells()) {
      neighbors.emplace_back();
      for (int i = 0; i < 4; ++i) neighbors.back()[i] = std::size_t(mesh.neighbor(c, i));
    }
  }
  std::size_t neighbor(std::size_t c, int i) const { return neighbors[c][i]; }

  std::vector<std::array<std::size_t, 4>> neighbors;
};

bool are_equal(const Mesh& a, const Mesh& b) {
  bool result = a.points() == b.points() && a.number_of_facets() == b.number_of_facets();
  for (VMP::Facet_index f : a.facets())
    for (int side : {0, 1})
      result = result && a.half_facet(f, side).cell == b.half_facet(f, side).cell && a.half_facet(f, side).index == b.half_facet(f, side).index;
  for (VMP::Cell_index c : a.cells())
    for (int i = 0; i < 4; ++i) result = result && a.facet(c, i) == b.facet(c, i) && a.label(c, i) == b.label(c, i);
  return result;
}

// The same mesh results, whether neighbors are known, or a mesh of the same type is copied.
void test_known_neighbors() {
  static_assert(!VMP::internal::Knows_neighbors<Soup>::value && VMP::internal::Knows_neighbors<Mesh_with_neighbors>::value);
  for (int holes = 0; holes <= 2; ++holes) {
    const Soup soup = Block_with_holes<Point>(holes, 2, 2).soup();
    Mesh found, known, copied;
    assert(found.assign(soup).ok() && known.assign(Mesh_with_neighbors(soup)).ok() && copied.assign(found).ok());
    assert(are_equal(found, known) && are_equal(found, copied));
  }
  assert(code_of(Mesh()) == VMP::ERROR_EMPTY_MESH);
}

void test_wrong_neighbors() {
  const Mesh_with_neighbors good(Block_with_holes<Point>(0, 1, 1).soup());
  const std::size_t none = good.number_of_cells();
  std::size_t c = 0;
  int inner = 0;
  while (good.neighbors[c][inner] >= none) inner == 3 ? (++c, inner = 0) : ++inner;
  Mesh_with_neighbors bad = good;
  bad.neighbors[c][inner] = none; // but its neighbor knows it
  assert(code_of(bad) == VMP::ERROR_WRONG_PARAMETER);
  bad = good;
  bad.neighbors[c][inner] = c;
  assert(code_of(bad) == VMP::ERROR_WRONG_PARAMETER);
  bad = good;
  std::swap(bad.neighbors[c][inner], bad.neighbors[c][(inner + 1) % 4]);
  assert(code_of(bad) == VMP::ERROR_WRONG_PARAMETER);
  bad = good;
  for (auto& n : bad.neighbors) n.fill(none); // facets in two cells that say they are no neighbors
  assert(code_of(bad) == VMP::ERROR_NON_MANIFOLD);
}

int main() {
  for (int holes = 0; holes <= 4; ++holes) test_block(holes);
  test_labels();
  test_refusals();
  test_known_neighbors();
  test_wrong_neighbors();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
