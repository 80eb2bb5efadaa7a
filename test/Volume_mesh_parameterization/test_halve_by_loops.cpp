#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/Partition_maker.h>
#include <CGAL/Volume_mesh_parameterization/partition_boundary.h>
#include <CGAL/Volume_mesh_parameterization/sweep_with_repairs.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "io_test_util.h"
#include "partition_test_util.h"
#include "solid_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Direction = VMP::Sweep_direction_3;

// Only by loops, for walls as wide as by default.
template <typename Mesh>
VMP::Status label_by_loops(Mesh& mesh, const Direction& direction) {
  VMP::Handlebody_certificate certificate;
  expect(VMP::certify_handlebody(mesh, certificate), VMP::OK);
  const VMP::Partition_options options;
  const VMP::internal::Labelled_surface given(mesh);
  const std::vector<int> no_picks(mesh.number_of_boundary_facets(), VMP::INTERIOR);
  VMP::internal::Partition_maker maker(given, certificate, no_picks, options.wall_width,
                                       options.island_share);
  VMP::internal::Labelled_surface labelled;
  const VMP::Status status = maker.by_loops(direction / VMP::internal::length(direction), labelled);
  return status.ok() ? labelled.write_to(mesh) : status;
}

// The partition is legal, hence the solid is a product, and the sweep finds that out.
void test_partition(const Mesh& mesh, const Direction& direction) {
  expect(VMP::check_tetrahedral_mesh(mesh), VMP::OK);
  Mesh labelled = mesh;
  expect(label_by_loops(labelled, direction), VMP::OK);
  for (VMP::Vertex_index v : mesh.vertices()) assert(labelled.point(v) == mesh.point(v));
  validate(labelled);
  VMP::Preparation counts;
  VMP::Product_structure_3<Kernel> structure;
  VMP::Sweep_report report;
  expect(VMP::prepare_patches(labelled, counts), VMP::OK);
  expect(VMP::sweep_with_repairs(labelled, flux_guide<Mesh>, structure, report), VMP::OK);
  expect(VMP::verify_product(labelled, structure.order()), VMP::OK);
}

void test_blocks() {
  for (int holes = 0; holes <= 4; ++holes)
    for (Shape shape : {Shape::JITTERED, Shape::TWISTED})
      for (const Direction& d : {Direction(0, 0, 1), Direction(2, 1, 0)})
        test_partition(unlabelled(shaped_block<Point>(shape, holes, 2, 2)), d);
}

// Coarse meshes leave no room for curves that share no vertex.
void test_coarse() {
  Soup tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.cells = {{{0, 1, 2, 3}}};
  test_partition(unlabelled(tetrahedron), {1, 0, 0});
  for (int holes = 1; holes <= 4; ++holes)
    for (const Direction& d :
         {Direction(1, 2, 3), Direction(0, 0, 1), Direction(0, 1, 0), Direction(-1, 0, 1)})
      test_partition(unlabelled(Block_with_holes<Point>(holes, 1, 1).soup()), d);
}

void test_knot() {
  const Mesh mesh = unlabelled(trefoil_tube<Point>(150));
  for (const Direction& d : {Direction(0, 0, 1), Direction(1, 0, 0), Direction(1, 2, -1)})
    test_partition(mesh, d);
}

// Floor and ceiling are broad, and lie where the direction says.
void test_shape() {
  Mesh mesh = unlabelled(shaped_block<Point>(Shape::PLAIN, 2, 3, 3));
  expect(label_by_loops(mesh, Direction(0, 0, 1)), VMP::OK);
  const VMP::Boundary_partition_3 summary = VMP::summarize_partition(mesh);
  double area = 0;
  for (const VMP::Boundary_patch_3& patch : summary.patches) area += patch.area;
  assert(summary.find(VMP::FLOOR)->area > area / 5 && summary.find(VMP::CEILING)->area > area / 5);
  for (const VMP::Boundary_patch_3& patch : summary.patches) assert(patch.area > area / 30);
  for (const VMP::Labelled_facet& f : mesh.labelled_facets()) {
    const auto& v = f.vertices;
    const double z = CGAL::centroid(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])).z();
    if (f.label == VMP::FLOOR) assert(z < .8);
    if (f.label == VMP::CEILING) assert(z > .2);
  }
}

void test_exact_kernel() {
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  VMP::Compact_tetrahedral_mesh_3<Exact> mesh;
  expect(mesh.assign(shaped_block<Exact::Point_3>(Shape::PLAIN, 1, 1, 1)), VMP::OK);
  expect(label_by_loops(mesh, Direction(0, 1, 1)), VMP::OK);
  validate(mesh);
}

void test_quotient() {
  VMP::internal::Free_quotient quotient(3);
  assert(quotient.is_primitive({2, 3, 0}) && !quotient.is_primitive({2, 4, 6}));
  assert(!quotient.is_primitive({0, 0, 0}));
  quotient.divide_by({2, 3, 0});
  assert(quotient.is_primitive({1, 1, 0}) && quotient.is_primitive({1, 1, 4}));
  assert(!quotient.is_primitive({1, 4, 0}) && !quotient.is_primitive({2, 3, 0}));
  quotient.divide_by({1, 1, 4});
  assert(quotient.is_primitive({5, 5, 21}) && !quotient.is_primitive({0, 0, 2}));
}

using Cube = std::array<int, 3>;

// The cells of a block of cubes of edge 1 that do not lie in one of some cubes.
template <typename In_cubes>
Mesh block_without(int size, int layers, const In_cubes& is_out) {
  Soup soup = Block_with_holes<Point>(0, size, layers, double(layers) / size).soup();
  soup.cells.erase(
      std::remove_if(soup.cells.begin(), soup.cells.end(),
                     [&](const std::array<std::size_t, 4>& c) {
                       const Point p = CGAL::centroid(soup.points[c[0]], soup.points[c[1]], soup.points[c[2]],
                                                      soup.points[c[3]]);
                       return is_out(Cube{int(size * p.x()), int(size * p.y()), int(size * p.z())});
                     }),
      soup.cells.end());
  return unlabelled(soup);
}

Mesh block_with_cavity() {
  return block_without(3, 3, [](const Cube& c) { return c == Cube{1, 4, 1}; });
}

// The tunnel is an overhand knot; its knot group is not free.
Mesh block_with_knotted_tunnel() {
  const std::vector<Cube> corners = {{9, 0, 3},   {9, 10, 3},  {9, 10, 1},  {9, 16, 1},  {11, 16, 1},
                                     {11, 16, 3}, {17, 16, 3}, {17, 8, 3},  {17, 8, 1},  {1, 8, 1},
                                     {1, 12, 1},  {1, 12, 3},  {13, 12, 3}, {13, 12, 1}, {13, 25, 1}};
  const auto lies_between = [](const Cube& c, const Cube& a, const Cube& b) {
    bool result = true;
    for (int i = 0; i < 3; ++i) result &= std::min(a[i], b[i]) <= c[i] && c[i] <= std::max(a[i], b[i]);
    return result;
  };
  return block_without(19, 5, [&](const Cube& c) {
    bool is_out = c[1] > 25;
    for (std::size_t k = 1; k < corners.size(); ++k) is_out |= lies_between(c, corners[k - 1], corners[k]);
    return is_out;
  });
}

Mesh two_tetrahedra_at_an_edge() {
  Soup soup;
  soup.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  soup.cells = {{{0, 2, 3, 1}}, {{0, 4, 5, 1}}};
  Mesh mesh;
  expect(mesh.assign(soup), VMP::OK);
  return mesh;
}

// The search starts with a certificate, which loops need.
void test_errors() {
  for (auto [mesh, code] : {std::pair(block_with_cavity(), VMP::ERROR_SEVERAL_COMPONENTS),
                            std::pair(block_with_knotted_tunnel(), VMP::ERROR_NOT_A_HANDLEBODY),
                            std::pair(two_tetrahedra_at_an_edge(), VMP::ERROR_NON_MANIFOLD)}) {
    const std::size_t number_of_vertices = mesh.number_of_vertices();
    expect(VMP::partition_boundary(mesh), code);
    assert(mesh.number_of_vertices() == number_of_vertices);
    for (const VMP::Labelled_facet& f : mesh.labelled_facets()) assert(f.label == VMP::INTERIOR);
    VMP::Partition_options up;
    up.directions = {{0, 0, 1}};
    VMP::Partition_search_3<Kernel> search(mesh, up);
    expect(search.run(VMP::Default_parameterization_visitor()), code);
    assert(search.candidates().empty() && search.number_of_trials() == 0);
  }
}

int main() {
  test_quotient();
  test_shape();
  test_coarse();
  test_blocks();
  test_knot();
  test_exact_kernel();
  test_errors();
  return EXIT_SUCCESS;
}
