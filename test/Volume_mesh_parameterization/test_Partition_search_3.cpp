#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Partition_search_3.h>
#include <CGAL/Volume_mesh_parameterization/partition_boundary.h>

#include "io_test_util.h"
#include "partition_test_util.h"
#include "solid_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Search = VMP::Partition_search_3<Kernel>;
using Direction = VMP::Sweep_direction_3;

// label_of(barycentre, old label) is the new label of a facet.
template <typename LabelOf>
Mesh relabelled(Mesh mesh, const LabelOf& label_of) {
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    mesh.set_label(
        f, label_of(CGAL::centroid(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])), mesh.label(f)));
  }
  return mesh;
}

VMP::Partition_options options_with(VMP::Given_labels given_labels,
                                    const std::vector<Direction>& directions = {}) {
  VMP::Partition_options options;
  options.given_labels = given_labels;
  options.directions = directions;
  return options;
}

std::vector<int> labels_of(const Mesh& mesh) { return VMP::internal::boundary_labels(mesh); }

// Counts its calls and stops at the last one.
struct Impatient_visitor {
  int* calls;
  int last;
  bool start_stage(const char*) { return true; }
  bool advance(std::size_t done, std::size_t all) {
    assert(done < all);
    return (*calls)++ < last;
  }
};

// All that is found is legal when it is applied, sorted, and measured as it is.
void test_candidates(const Mesh& mesh, std::size_t at_least, bool only_by_loops = false) {
  VMP::Partition_options options;
  options.number_of_candidates = 6;
  options.only_by_loops = only_by_loops;
  Search search(mesh, options);
  expect(search.run(VMP::Default_parameterization_visitor()), VMP::OK);
  const auto& candidates = search.candidates();
  assert(candidates.size() >= at_least && candidates.size() <= options.number_of_candidates);
  assert(search.number_of_trials() >= candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Mesh partitioned = mesh;
    expect(search.label(i, partitioned), VMP::OK);
    const VMP::Boundary_partition_3 partition = validate(partitioned);
    assert(std::equal(mesh.points().begin(), mesh.points().end(), partitioned.points().begin()));
    assert(i == 0 || candidates[i - 1].cost <= candidates[i].cost);
    assert(candidates[i].cost == VMP::cost(candidates[i].quality) && std::isfinite(candidates[i].cost));
    assert(partition.genus == candidates[i].partition.genus);
    assert(!only_by_loops || candidates[i].method == VMP::BY_LOOPS);
    VMP::Partition_quality quality;
    expect(VMP::measure_partition(partitioned, candidates[i].direction, quality), VMP::OK);
    assert(std::abs(quality.floor_share - candidates[i].quality.floor_share) < 1e-9);
    assert(std::abs(quality.rim_length - candidates[i].quality.rim_length) < 1e-9);
  }
}

// On the given facets no two agree on nearly all of the area, whichever base is called floor.
void test_none_twice(const Mesh& mesh) {
  Search search(mesh);
  expect(search.run(VMP::Default_parameterization_visitor()), VMP::OK);
  std::vector<std::vector<int>> found;
  for (std::size_t i = 0; i < search.candidates().size(); ++i) {
    Mesh partitioned = mesh;
    expect(search.label(i, partitioned), VMP::OK);
    if (partitioned.number_of_vertices() > mesh.number_of_vertices()) continue; // it has other facets
    std::vector<int> labels = labels_of(partitioned);
    for (int& label : labels) label = std::min<int>(label, VMP::FIRST_WALL);
    std::vector<int> reversed = labels;
    for (int& label : reversed)
      if (label < VMP::FIRST_WALL) label = VMP::FLOOR + VMP::CEILING - label;
    for (const auto& other : found) assert(labels != other && reversed != other);
    found.push_back(labels);
  }
  assert(found.size() > 1);
}

void test_determinism(const Mesh& mesh) {
  Search search(mesh), again(mesh);
  expect(search.run(VMP::Default_parameterization_visitor()), VMP::OK);
  expect(again.run(VMP::Default_parameterization_visitor()), VMP::OK);
  assert(search.candidates().size() == again.candidates().size());
  assert(search.number_of_trials() == again.number_of_trials());
  for (std::size_t i = 0; i < search.candidates().size(); ++i) {
    assert(search.candidates()[i].cost == again.candidates()[i].cost);
    assert(search.candidates()[i].direction == again.candidates()[i].direction);
    Mesh a = mesh, b = mesh;
    expect(search.label(i, a), VMP::OK);
    expect(again.label(i, b), VMP::OK);
    assert(a.points() == b.points() && labels_of(a) == labels_of(b));
  }
}

void test_cancel() {
  const Mesh block = unlabelled(Block_with_holes<Point>(1, 1, 1).soup());
  int all = 0, again = 0;
  Mesh mesh = block;
  expect(VMP::partition_boundary(mesh, {}, nullptr, Impatient_visitor{&all, 1000000}), VMP::OK);
  assert(all > 5);
  for (int last = 0; last < all; ++last) {
    int calls = 0;
    mesh = block;
    expect(VMP::partition_boundary(mesh, {}, nullptr, Impatient_visitor{&calls, last}), VMP::ERROR_CANCELLED);
    assert(calls == last + 1);
    assert(mesh.points() == block.points() && labels_of(mesh) == labels_of(block));
  }
  expect(VMP::partition_boundary(mesh, {}, nullptr, Impatient_visitor{&again, all}), VMP::OK);
  assert(again == all);
}

// The facet of the ball that is the farthest in a direction.
VMP::Facet_index farthest(const Mesh& mesh, const Direction& d) {
  VMP::Facet_index result;
  double largest = 0;
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    double sum = 0;
    for (VMP::Vertex_index v : mesh.vertices(f))
      sum += (VMP::internal::approximate(mesh.point(v)) - CGAL::ORIGIN) * d;
    if (sum > largest) result = f, largest = sum;
  }
  return result;
}

// By area, of the patch of a ball.
Direction middle(const Mesh& mesh, int label) {
  Direction sum = CGAL::NULL_VECTOR;
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    const auto &p = mesh.point(v[0]), &q = mesh.point(v[1]), &r = mesh.point(v[2]);
    if (mesh.label(f) == label)
      sum = sum + std::sqrt(CGAL::squared_area(p, q, r)) *
                      (VMP::internal::approximate(CGAL::centroid(p, q, r)) - CGAL::ORIGIN);
  }
  return sum / VMP::internal::length(sum);
}

// Picked facets outweigh the direction.
void test_picked_bases() {
  const Mesh original = unlabelled(ball<Point>(3));
  const std::vector<std::vector<Direction>> given = {{{0, 0, 1}, {1, 0, 0}}, {{0, 0, 1}}, {}};
  for (const auto& directions : given) {
    Mesh mesh = original;
    mesh.set_label(farthest(mesh, {-1, 0, 0}), VMP::FLOOR);
    mesh.set_label(farthest(mesh, {1, 0, 0}), VMP::CEILING);
    expect(VMP::partition_boundary(mesh, options_with(VMP::KEEP_LABELS, directions)), VMP::OK);
    assert(mesh.label(farthest(mesh, {-1, 0, 0})) == VMP::FLOOR &&
           mesh.label(farthest(mesh, {1, 0, 0})) == VMP::CEILING);
    assert(middle(mesh, VMP::FLOOR).x() < -.5 && middle(mesh, VMP::CEILING).x() > .5);
  }
}

bool is_outer(const Point& p) { return p.x() == 0 || p.x() == 3 || p.y() == 0 || p.y() == 3; }
bool is_in_hole(const Point& p) { return !is_outer(p) && p.z() > 0 && p.z() < 1; }

// Where any two facets of a block with a hole are walls, they are the sides of the block and of the hole.
void test_picked_walls() {
  const Mesh block = mesh_of(Block_with_holes<Point>(1, 2, 2).soup());
  const int outer_wall = VMP::FIRST_WALL + 1, inner_wall = VMP::FIRST_WALL;
  for (bool picks_outer : {false, true}) {
    Mesh mesh = relabelled(block, [&](const Point& p, int) -> int {
      const bool is_picked = picks_outer ? p.x() == 0 : is_in_hole(p) && p.x() == 1;
      return is_picked ? (picks_outer ? outer_wall : inner_wall) : VMP::INTERIOR;
    });
    expect(VMP::partition_boundary(mesh, options_with(VMP::KEEP_LABELS, {{0, 0, 1}})), VMP::OK);
    const std::vector<int> expected = labels_of(relabelled(block, [&](const Point& p, int label) -> int {
      return label < VMP::FIRST_WALL ? label : is_outer(p) ? outer_wall : inner_wall;
    }));
    assert(labels_of(mesh) == expected);
  }
}

// The vertices of the first facet with the wish that cannot be granted are named.
template <typename Pick>
void expect_refusal(const Mesh& block, const Pick& pick, const std::string& reason) {
  const Mesh picked = relabelled(block, [&](const Point& p, int) -> int { return pick(p); });
  Mesh mesh = picked;
  const VMP::Status status = VMP::partition_boundary(mesh, options_with(VMP::KEEP_LABELS, {{0, 0, 1}}));
  expect(status, VMP::ERROR_PICKED_FACET, reason);
  bool is_named = false;
  for (VMP::Facet_index f : picked.boundary_facets()) {
    const auto v = picked.vertices(f);
    const std::string name = "the facet with vertices " + std::to_string(v[0]) + ", " + std::to_string(v[1]) +
                             ", " + std::to_string(v[2]) + " is to be " + VMP::patch_name(picked.label(f));
    is_named |= picked.label(f) != VMP::INTERIOR && status.detail().find(name) != std::string::npos;
  }
  assert(is_named);
  assert(mesh.points() == picked.points() && labels_of(mesh) == labels_of(picked));
}

void test_impossible_picks() {
  const Mesh block = mesh_of(Block_with_holes<Point>(1, 2, 2).soup());
  const int wall = VMP::FIRST_WALL, none = VMP::INTERIOR;
  expect_refusal(
      block, [&](const Point& p) { return p.x() == 0 || is_in_hole(p) ? wall : none; }, "wall 0");
  expect_refusal(
      block, [&](const Point& p) { return p.x() == 0   ? wall
                                          : p.x() == 3 ? wall + 1
                                                       : none; }, "wall");
  expect_refusal(
      block, [&](const Point& p) { return p.x() == 0 ? wall + 2 : none; }, "the last patch is wall 1");
  expect_refusal(
      block, [&](const Point& p) { return p.x() == 0 ? -1 : none; }, "label -1");
  expect_refusal(
      block, [&](const Point&) { return VMP::FLOOR; }, "floor");
}

void test_honoured(Mesh mesh) {
  const Mesh given = mesh;
  expect(VMP::partition_boundary(mesh, options_with(VMP::KEEP_LABELS)), VMP::OK);
  assert(mesh.points() == given.points());
  for (VMP::Facet_index f : given.boundary_facets())
    assert(given.label(f) == VMP::INTERIOR || given.label(f) == mesh.label(f));
}

// A legal partition of which some or all facets are picked comes back.
void test_complete_picks() {
  Random random(5);
  for (int holes : {0, 2}) {
    const Mesh block = mesh_of(Block_with_holes<Point>(holes, 2, 2).soup());
    test_honoured(block);
    test_honoured(
        relabelled(block, [&](const Point&, int label) { return random.below(3) ? VMP::INTERIOR : label; }));
  }
}

// Whatever is picked, it is honoured or refused.
void test_random_picks(const Mesh& mesh) {
  Random random(11);
  int number_of_refusals = 0, number_of_trials = 24;
  for (int trial = 0; trial < number_of_trials; ++trial) {
    Mesh picked = mesh;
    for (std::size_t k = 0; k <= random.below(4); ++k)
      picked.set_label(VMP::Facet_index(random.below(mesh.number_of_boundary_facets())),
                       1 + int(random.below(4)));
    Mesh partitioned = picked;
    const VMP::Status status =
        VMP::partition_boundary(partitioned, options_with(VMP::KEEP_LABELS, {{0, 0, 1}, {1, 0, 0}}));
    if (!status.ok()) {
      assert(status.code() == VMP::ERROR_NO_PARTITION || status.code() == VMP::ERROR_PICKED_FACET);
      ++number_of_refusals;
      continue;
    }
    validate(partitioned);
    if (partitioned.number_of_vertices() == mesh.number_of_vertices())
      for (VMP::Facet_index f : mesh.boundary_facets())
        assert(picked.label(f) == VMP::INTERIOR || picked.label(f) == partitioned.label(f));
  }
  std::cout << number_of_refusals << " of " << number_of_trials << " random picks refused" << std::endl;
  assert(number_of_refusals < number_of_trials);
}

// A few facets with wrong labels get the right ones.
void test_mending() {
  Random random(7);
  for (int holes = 0; holes <= 3; ++holes) {
    const Mesh legal = mesh_of(shaped_block<Point>(Shape::JITTERED, holes, 4, 3));
    Mesh mesh = legal;
    for (int k = 0; k < 12; ++k)
      mesh.set_label(VMP::Facet_index(random.below(mesh.number_of_boundary_facets())),
                     1 + int(random.below(3)));
    VMP::Partition_candidate_3 chosen;
    expect(VMP::partition_boundary(mesh, options_with(VMP::MEND_LABELS), &chosen), VMP::OK);
    assert(chosen.method == VMP::BY_LABELS && chosen.direction.z() > 0);
    assert(mesh.points() == legal.points());
    for (VMP::Facet_index f : mesh.boundary_facets())
      assert(std::min<int>(mesh.label(f), VMP::FIRST_WALL) == std::min<int>(legal.label(f), VMP::FIRST_WALL));
    validate(mesh);
  }
}

// Labels without walls get some.
void test_mending_of_halves() {
  for (int holes = 0; holes <= 2; ++holes) {
    const Mesh halves =
        relabelled(mesh_of(Block_with_holes<Point>(holes, 3, 3).soup()), [](const Point& p, int label) {
          return label < VMP::FIRST_WALL ? label : p.z() < .5 ? int(VMP::FLOOR) : int(VMP::CEILING);
        });
    Mesh mesh = halves;
    VMP::Partition_candidate_3 chosen;
    expect(VMP::partition_boundary(mesh, options_with(VMP::MEND_LABELS), &chosen), VMP::OK);
    assert(chosen.method == VMP::BY_LABELS);
    validate(mesh);
    for (VMP::Facet_index f : mesh.boundary_facets())
      for (VMP::Vertex_index v : mesh.vertices(f)) {
        assert(mesh.label(f) != VMP::FLOOR || mesh.point(v).z() < .6);
        assert(mesh.label(f) != VMP::CEILING || mesh.point(v).z() > .4);
      }
  }
}

// Labels that mean nothing are replaced.
void test_mending_of_nonsense() {
  const Mesh legal = mesh_of(Block_with_holes<Point>(1, 4, 2).soup());
  Mesh mesh = legal;
  for (std::size_t f : {0, 50, 100})
    mesh.set_label(VMP::Facet_index(f), f == 0 ? -5 : f == 50 ? 1000000000 : 0);
  expect(VMP::partition_boundary(mesh, options_with(VMP::MEND_LABELS)), VMP::OK);
  assert(mesh.points() == legal.points() && labels_of(mesh) == labels_of(legal));

  mesh =
      unlabelled(Block_with_holes<Point>(1, 4, 2).soup()); // nothing to mend: as if they were to be ignored
  expect(VMP::partition_boundary(mesh, options_with(VMP::MEND_LABELS)), VMP::OK);
  assert(labels_of(mesh) == labels_of(legal));
}

void test_wrong_options() {
  const Mesh block = unlabelled(Block_with_holes<Point>(1, 1, 1).soup());
  std::vector<VMP::Partition_options> wrong(5);
  wrong[0].number_of_candidates = 0;
  wrong[1].wall_width = 0;
  wrong[2].wall_width = -1;
  wrong[3].wall_width = NAN;
  wrong[4].wall_width = INFINITY;
  for (const VMP::Partition_options& options : wrong) {
    Search search(block, options);
    expect(search.run(VMP::Default_parameterization_visitor()), VMP::ERROR_WRONG_PARAMETER);
    assert(search.candidates().empty());
  }
}

void test_method_names() {
  const VMP::Partition_method methods[] = {VMP::BY_CREASES, VMP::BY_NORMALS, VMP::BY_LOOPS, VMP::BY_LABELS};
  std::string names;
  for (VMP::Partition_method method : methods) names += std::string(VMP::method_name(method)) + ' ';
  assert(names == "creases normals loops labels ");
}

// Labels that are to be ignored change nothing.
void test_ignored_labels() {
  const Mesh labelled_block = mesh_of(Block_with_holes<Point>(1, 1, 1).soup());
  const Mesh block = unlabelled(Block_with_holes<Point>(1, 1, 1).soup());
  const VMP::Partition_options options = options_with(VMP::IGNORE_LABELS);
  Search with(labelled_block, options), without(block, options);
  expect(with.run(VMP::Default_parameterization_visitor()), VMP::OK);
  expect(without.run(VMP::Default_parameterization_visitor()), VMP::OK);
  assert(with.candidates().size() == without.candidates().size());
  for (std::size_t i = 0; i < with.candidates().size(); ++i) {
    Mesh a = labelled_block, b = block;
    expect(with.label(i, a), VMP::OK);
    expect(without.label(i, b), VMP::OK);
    assert(a.points() == b.points() && labels_of(a) == labels_of(b));
  }
}

int main() {
  const Mesh block = unlabelled(shaped_block<Point>(Shape::JITTERED, 1, 3, 3));
  const Mesh torus = unlabelled(solid_torus<Point>(30, 15, 2));
  test_candidates(block, 2);
  test_candidates(unlabelled(Block_with_holes<Point>(2, 2, 3).soup()), 2);
  test_candidates(torus, 2);
  test_candidates(torus, 1, true);
  test_none_twice(unlabelled(Block_with_holes<Point>(0, 2, 4).soup()));
  test_determinism(block);
  test_determinism(torus);
  test_cancel();
  test_method_names();
  test_ignored_labels();
  test_picked_bases();
  test_picked_walls();
  test_impossible_picks();
  test_complete_picks();
  test_random_picks(block);
  test_random_picks(unlabelled(solid_torus<Point>(20, 10, 1)));
  test_mending();
  test_mending_of_halves();
  test_mending_of_nonsense();
  test_wrong_options();
  return EXIT_SUCCESS;
}
