#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Partition_sequence_3.h>
#include <CGAL/Volume_mesh_parameterization/make_triangle_soup.h>

#include "io_test_util.h"
#include "partition_test_util.h"
#include "solid_test_util.h"
#include "surface_test_util.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = VMP::Triangle_soup_3<Point>;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Sequence = VMP::Partition_sequence_3<Kernel>;
using Visitor = VMP::Default_parameterization_visitor;

bool are_alike(const VMP::Partition_candidate_3& a, const VMP::Partition_candidate_3& b) {
  return a.method == b.method && std::abs(a.direction * b.direction) > .866 * std::sqrt(a.direction.squared_length() * b.direction.squared_length());
}

// All that come are legal, no two alike, and of the same solid; then it is said that there are no more, again and again.
void test_all(Sequence sequence, int genus, const std::vector<Point>& first_points, std::size_t least) {
  std::vector<VMP::Partition_candidate_3> chosen;
  Mesh mesh;
  VMP::Status status;
  while ((status = sequence.next(mesh, Visitor())).ok()) {
    const VMP::Boundary_partition_3 partition = validate(mesh);
    assert(partition.genus == genus && sequence.chosen()->partition.genus == genus);
    assert(std::equal(first_points.begin(), first_points.end(), mesh.points().begin()));
    for (const auto& other : chosen) assert(!are_alike(other, *sequence.chosen()));
    chosen.push_back(*sequence.chosen());
    mesh = Mesh();
  }
  std::cout << chosen.size() << " partitions" << std::endl;
  assert(chosen.size() >= least && mesh.number_of_cells() == 0);
  expect(status, VMP::ERROR_NO_PARTITION);
  expect(sequence.next(mesh, Visitor()), VMP::ERROR_NO_PARTITION);
}

void test_solids() {
  const Mesh torus = unlabelled(solid_torus<Point>(48, 24, 1)), block = unlabelled(Block_with_holes<Point>(2, 1, 1).soup());
  test_all(Sequence(torus), 1, torus.points(), 3);
  test_all(Sequence(torus, along({0, 0, 1})), 1, torus.points(), 2); // by normals, and by loops
  test_all(Sequence(block), 2, block.points(), 2);
}

// Labels that are given are the only partition, and are kept.
void test_given_labels() {
  Mesh labelled, mesh;
  expect(labelled.assign(Block_with_holes<Point>(1, 1, 1).soup()), VMP::OK);
  Sequence sequence = Sequence::of_labels(labelled);
  expect(sequence.next(mesh, Visitor()), VMP::OK);
  assert(!sequence.chosen());
  for (VMP::Facet_index f : mesh.boundary_facets()) assert(mesh.label(f) == labelled.label(f));
  expect(sequence.next(mesh, Visitor()), VMP::ERROR_NO_PARTITION);
  assert(mesh.number_of_cells() == labelled.number_of_cells());
}

void expect_refusal(Sequence sequence, VMP::Error_code code) {
  Mesh mesh;
  expect(sequence.next(mesh, Visitor()), code);
  assert(mesh.number_of_cells() == 0);
}

void expect_refusal(const Mesh& solid, const VMP::Partition_options& options, VMP::Error_code code) {
  expect_refusal(Sequence(solid, options), code);
}

void expect_refusal(const Surface& surface, const VMP::Partition_options& options, VMP::Error_code code) {
  expect_refusal(Sequence(surface, 1000, options), code);
}

void test_refused_solids() {
  const Mesh block = unlabelled(Block_with_holes<Point>(1, 1, 1).soup());
  expect_refusal(block, along({0, 0, 0}), VMP::ERROR_WRONG_PARAMETER);
  VMP::Partition_options none;
  none.number_of_candidates = 0;
  expect_refusal(block, none, VMP::ERROR_WRONG_PARAMETER);
  expect_refusal(Mesh(), {}, VMP::ERROR_EMPTY_MESH);
}

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN

// Stops before the stage whose name is given.
struct Stopper {
  std::string stage;
  bool start_stage(const char* name) { return name != stage; }
  bool advance(std::size_t, std::size_t) { return true; }
};

void test_cancelling() {
  for (const char* stage : {"tetrahedralize, to try partitions", "partition", "tetrahedralize"}) {
    Mesh mesh;
    expect(Sequence(block_surface<Point>(1, 1, 1), 1000).next(mesh, Stopper{stage}), VMP::ERROR_CANCELLED, stage);
    assert(mesh.number_of_cells() == 0);
  }
}

// The surface may be cut finer, but stays where it was.
void test_surfaces() {
  const auto test = [](const Surface& surface, const VMP::Partition_options& options, int genus, std::size_t least) {
    test_all(Sequence(surface, 2000, options), genus, surface.points, least);
  };
  test(block_surface<Point>(2, 1, 1), {}, 2, 2);
  test(make_boundary_soup(unlabelled(solid_torus<Point>(48, 24, 1))), along({0, 0, 1}), 1, 2);
  test(make_boundary_soup(unlabelled(ball<Point>(2))), along({1, 2, 3}), 0, 1);
  Surface inside_out = block_surface<Point>(1, 1, 1);
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  test(inside_out, along({0, 0, 1}), 1, 1);

  VMP::Compact_tetrahedral_mesh_3<Exact_kernel> mesh;
  VMP::Partition_sequence_3<Exact_kernel> exact(block_surface<Exact_kernel::Point_3>(1, 1, 1), 500, along({1, 2, 3}));
  expect(exact.next(mesh, Visitor()), VMP::OK);
  assert(validate(mesh).genus == 1);
}

// Facets keep labels that they have, as on solids.
void test_picks_on_surface() {
  Surface surface = block_surface<Point>(1, 1, 1);
  for (int& label : surface.labels)
    if (label != VMP::FIRST_WALL) label = VMP::INTERIOR;
  VMP::Partition_options options;
  options.given_labels = VMP::KEEP_LABELS;
  Mesh mesh;
  expect(Sequence(surface, 500, options).next(mesh, Visitor()), VMP::OK);
  const auto is_outside = [](const Point& p) { return p.x() == 0 || p.x() == 3 || p.y() == 0 || p.y() == 3; };
  for (const VMP::Labelled_facet& f : mesh.labelled_facets()) {
    const bool is_wall = std::all_of(f.vertices.begin(), f.vertices.end(), [&](std::size_t v) { return is_outside(mesh.point(v)); });
    const double z = CGAL::to_double(mesh.point(f.vertices[0]).z());
    const bool is_base = std::all_of(f.vertices.begin(), f.vertices.end(), [&](std::size_t v) { return mesh.point(v).z() == z; });
    assert(!is_wall || is_base || f.label == VMP::FIRST_WALL);
  }
}

void test_refused_surfaces() {
  const Surface block = block_surface<Point>(1, 1, 1);
  expect_refusal(block, along({0, 0, 0}), VMP::ERROR_WRONG_PARAMETER);
  expect_refusal(block, along({0, 0, std::numeric_limits<double>::quiet_NaN()}), VMP::ERROR_WRONG_PARAMETER);
  expect_refusal(Surface(), {}, VMP::ERROR_EMPTY_MESH);
  Surface surface = block;
  surface.triangles.pop_back();
  surface.labels.pop_back();
  expect_refusal(surface, {}, VMP::ERROR_OPEN_SURFACE);
  surface = block;
  surface.triangles.push_back(surface.triangles.back());
  surface.labels.push_back(0);
  expect_refusal(surface, {}, VMP::ERROR_NON_MANIFOLD);
  surface = with_doubled_points(block);
  surface.labels.clear();
  for (auto triangle : block.triangles) {
    for (std::size_t& v : triangle) v += block.points.size();
    surface.triangles.push_back(triangle);
  }
  expect_refusal(surface, {}, VMP::ERROR_SEVERAL_COMPONENTS);
  expect_refusal(self_intersecting_surface<Point>(), {}, VMP::ERROR_SELF_INTERSECTION);
  surface = block;
  surface.triangles[3][1] = surface.points.size();
  expect_refusal(surface, {}, VMP::ERROR_INDEX_OUT_OF_RANGE);
}

#else

void test_cancelling() {}
void test_surfaces() { expect_refusal(block_surface<Point>(1, 1, 1), {}, VMP::ERROR_MISSING_LIBRARY); }
void test_picks_on_surface() {}
void test_refused_surfaces() {}

#endif

int main() {
  test_solids();
  test_given_labels();
  test_refused_solids();
  test_cancelling();
  test_surfaces();
  test_picks_on_surface();
  test_refused_surfaces();
  return EXIT_SUCCESS;
}
