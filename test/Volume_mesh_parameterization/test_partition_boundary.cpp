#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/make_triangle_soup.h>
#include <CGAL/Volume_mesh_parameterization/partition_boundary.h>

#include "io_test_util.h"
#include "partition_test_util.h"
#include "solid_test_util.h"
#include "surface_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using Solid = VMP::Tetrahedron_soup_3<Point>;
using Surface = VMP::Triangle_soup_3<Point>;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Direction = VMP::Sweep_direction_3;

template <typename Mesh>
VMP::Partition_quality quality_of(const Mesh& mesh, const Direction& direction) {
  VMP::Partition_quality quality;
  expect(VMP::measure_partition(mesh, direction, quality), VMP::OK);
  return quality;
}

// On a block the creases give the labels: those of the generator, up to the numbers of the walls.
template <typename K>
void test_block(int holes) {
  VMP::Compact_tetrahedral_mesh_3<K> original;
  expect(original.assign(Block_with_holes<typename K::Point_3>(holes, 2, 2).soup()), VMP::OK);
  auto mesh = unlabelled(make_soup(original));
  VMP::Partition_candidate_3 chosen;
  expect(VMP::partition_boundary(mesh, along({.05, 0, 1}), &chosen), VMP::OK);
  assert(chosen.method == VMP::BY_CREASES && chosen.partition.genus == holes);
  assert(mesh.points() == original.points() && mesh.number_of_cells() == original.number_of_cells());
  std::map<int, int> renumbered;
  for (VMP::Facet_index f : mesh.boundary_facets())
    assert(renumbered.emplace(original.label(f), mesh.label(f)).first->second == mesh.label(f));
  assert(renumbered.size() == std::size_t(holes + 3));
  assert(renumbered[VMP::FLOOR] == VMP::FLOOR && renumbered[VMP::CEILING] == VMP::CEILING);
  assert(renumbered[VMP::FIRST_WALL] == VMP::FIRST_WALL); // the outer one is the largest
}

// A smooth solid that the direction halves by symmetry.
template <typename K>
void test_smooth(const VMP::Tetrahedron_soup_3<typename K::Point_3>& soup, const Direction& direction,
                 int genus) {
  const auto original = unlabelled(soup);
  auto mesh = original;
  VMP::Partition_candidate_3 chosen;
  expect(VMP::partition_boundary(mesh, along(direction), &chosen), VMP::OK);
  assert(chosen.method == VMP::BY_NORMALS && validate(mesh).genus == genus);
  assert(mesh.number_of_vertices() > original.number_of_vertices());
  assert(std::equal(original.points().begin(), original.points().end(), mesh.points().begin()));
  const VMP::Partition_quality quality = quality_of(mesh, direction);
  std::cout << "balance " << quality.balance << ", walls " << quality.wall_share << ", zigzag "
            << quality.zigzag << ", alignment " << quality.alignment << std::endl;
  assert(quality.balance > .97 && quality.zigzag < 1.05 && quality.alignment > .8);
  assert(std::abs(quality.zigzag - chosen.quality.zigzag) < 1e-3); // its curves start elsewhere
  for (const VMP::Labelled_facet& f : mesh.labelled_facets())
    for (std::size_t v : f.vertices) {
      const double rise = (VMP::internal::approximate(mesh.point(v)) - CGAL::ORIGIN) * direction;
      assert(f.label != VMP::FLOOR || rise < 0);
      assert(f.label != VMP::CEILING || rise > 0);
    }
}

void test_smooth_solids() {
  test_smooth<Kernel>(solid_torus<Point>(48, 24, 2), {0, 0, 5}, 1);
  test_smooth<Kernel>(ball<Point>(4), {1, 1, 1}, 0);
  test_smooth<Exact_kernel>(solid_torus<Exact_kernel::Point_3>(48, 24, 1), {0, 0, 1}, 1);
}

// Wider walls have more area, and leave smaller bases.
void test_wall_width() {
  double last = 0;
  for (double width : {.05, .1, .2, .4, .6}) {
    Mesh mesh = unlabelled(solid_torus<Point>(48, 24, 2));
    VMP::Partition_options options = along({0, 0, 1});
    options.wall_width = width;
    expect(VMP::partition_boundary(mesh, options), VMP::OK);
    const double share = quality_of(mesh, {0, 0, 1}).wall_share;
    assert(share > 1.2 * last);
    last = share;
  }
}

// Neither labels that the solid has nor a lack of them matter, if they are not to be kept or mended.
void test_labels_are_ignored() {
  Mesh labelled, other = unlabelled(Block_with_holes<Point>(1, 2, 2).soup());
  expect(labelled.assign(make_soup(other)), VMP::OK);
  for (VMP::Facet_index f : labelled.boundary_facets()) labelled.set_label(f, VMP::FLOOR);
  expect(VMP::partition_boundary(labelled), VMP::OK);
  expect(VMP::partition_boundary(other), VMP::OK);
  assert(labelled.points() == other.points());
  for (VMP::Facet_index f : other.boundary_facets()) assert(labelled.label(f) == other.label(f));
}

void expect_refusal(const Mesh& solid, const VMP::Partition_options& options, VMP::Error_code code) {
  Mesh mesh = solid;
  VMP::Partition_candidate_3 chosen = {VMP::BY_LABELS, {1, 2, 3}, {}, {}, 17};
  expect(VMP::partition_boundary(mesh, options, &chosen), code);
  assert(mesh.points() == solid.points() && mesh.number_of_cells() == solid.number_of_cells());
  for (VMP::Facet_index f : mesh.boundary_facets()) assert(mesh.label(f) == solid.label(f));
  assert(chosen.cost == 17);
}

Solid two_blocks() {
  Solid soup = Block_with_holes<Point>(1, 1, 1).soup();
  const std::size_t n = soup.points.size();
  for (auto cell : Solid(soup).cells) {
    for (std::size_t& v : cell) v += n;
    soup.cells.push_back(cell);
  }
  return with_doubled_points(soup);
}

void test_refusals() {
  const Mesh block = unlabelled(Block_with_holes<Point>(1, 1, 1).soup());
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Direction& d : {Direction(0, 0, 0), Direction(0, 0, NAN), Direction(infinity, 0, 0)}) {
    expect_refusal(block, along(d), VMP::ERROR_WRONG_PARAMETER);
    VMP::Partition_options second = along({0, 0, 1});
    second.directions.push_back(d);
    expect_refusal(block, second, VMP::ERROR_WRONG_PARAMETER);
  }
  expect_refusal(Mesh(), {}, VMP::ERROR_EMPTY_MESH);
  expect_refusal(unlabelled(two_blocks()), {}, VMP::ERROR_SEVERAL_COMPONENTS);
  Solid pinched;
  pinched.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  pinched.cells = {{{0, 2, 3, 1}}, {{0, 4, 5, 1}}};
  expect_refusal(unlabelled(pinched), {}, VMP::ERROR_NON_MANIFOLD);
}

int main() {
  for (int holes = 0; holes <= 4; ++holes) test_block<Kernel>(holes);
  test_block<Exact_kernel>(1);
  test_smooth_solids();
  test_wall_width();
  test_labels_are_ignored();
  test_refusals();
  return EXIT_SUCCESS;
}
