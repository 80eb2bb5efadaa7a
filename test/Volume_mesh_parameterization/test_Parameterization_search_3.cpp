#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Parameterization_search_3.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "io_test_util.h"
#include "partition_test_util.h"
#include "solid_test_util.h"
#include "surface_test_util.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Sequence = VMP::Partition_sequence_3<Kernel>;
using Search = VMP::Parameterization_search_3<Kernel>;
using Options = VMP::Parameterization_search_options;

// Both maps are of the same solid and domain, and bijective.
void test_result(const Search& search) {
  const Search::Parameterizer& solid = *search.parameterizer();
  const Search::Linear_map& linear = search.linear_map();
  assert(linear.is_valid() && search.linear_status().ok() && search.chosen().status.ok());
  assert(VMP::verify_map(linear.mesh(), linear.images()).is_polycube_map());
  expect(VMP::verify_product(linear.mesh(), linear.order()), VMP::OK);
  expect(VMP::verify_product(solid.mesh(), solid.product_structure()->order()), VMP::OK);
  const auto& points = solid.mesh().points();
  assert(std::equal(points.begin(), points.end(), linear.mesh().points().begin()));
  const auto top = [](const std::vector<Point>& images) {
    return std::max_element(images.begin(), images.end(), [](const Point& p, const Point& q) { return p.z() < q.z(); })->z();
  };
  assert(top(solid.vertex_images()) == top(linear.images()) && top(linear.images()) == solid.floor_map()->domain().height());
}

// Of labels that are given there is one trial, however much energy its map has.
void test_given_labels() {
  Options options;
  options.good_energy = 0;
  Search search(options);
  Sequence labels = Sequence::of_labels(mesh_of(shaped_block<Point>(Shape::BENT, 1, 1, 4)));
  expect(search.run(labels), VMP::OK);
  test_result(search);
  assert(search.trials().size() == 1 && !search.chosen().partition);
  assert(search.chosen().boundary_energy > 3.99 && search.chosen().boundary_energy < 8);
}

// What is good enough ends the search; else all are tried, and the least is taken.
void test_trials() {
  const Mesh torus = unlabelled(solid_torus<Point>(24, 12, 2));
  for (double good : {100., 0.}) {
    Options options;
    options.good_energy = good;
    options.most_partitions = 3;
    Search search(options);
    Sequence partitions(torus);
    expect(search.run(partitions), VMP::OK);
    test_result(search);
    const auto& trials = search.trials();
    assert(trials.size() == (good > 0 ? 1 : 3));
    for (const VMP::Parameterization_trial_3& t : trials) {
      std::cout << VMP::method_name(t.partition->method) << ": energy " << t.boundary_energy << std::endl;
      assert(t.number_of_cells >= torus.number_of_cells() && t.boundary_energy >= search.chosen().boundary_energy);
    }
  }
}

// Without piecewise linear maps there is nothing to compare.
void test_curves_only() {
  Options options;
  options.good_energy = 0;
  options.most_linear_maps = 0;
  Search search(options);
  Sequence partitions(unlabelled(solid_torus<Point>(24, 12, 1)));
  expect(search.run(partitions), VMP::OK);
  assert(search.trials().size() == 1 && !search.linear_map().is_valid() && search.linear_status().ok());
  assert(search.parameterizer()->product_map());
}

void test_refusals() {
  Search none, wrong;
  Sequence empty((Mesh()));
  expect(none.run(empty), VMP::ERROR_EMPTY_MESH);
  assert(!none.parameterizer() && none.trials().empty());
  Sequence labels = Sequence::of_labels(unlabelled(Block_with_holes<Point>(1, 1, 1).soup()));
  expect(wrong.run(labels), VMP::ERROR_UNLABELLED_FACET);
  assert(wrong.parameterizer() && !wrong.parameterizer()->product_structure() && wrong.trials().size() == 1);
}

// Fails the first time.
struct Fickle_floor_map : VMP::Floor_map_2<Kernel> {
  static int builds;
  VMP::Status build(const Mesh& mesh) {
    return builds++ == 0 ? VMP::Status(VMP::ERROR_FLOOR_MAP, "it is the first one") : VMP::Floor_map_2<Kernel>::build(mesh);
  }
};
int Fickle_floor_map::builds = 0;

// A partition that leads to a map is better than one that does not, whether the boundary can be mapped or not.
void test_failure_of_first() {
  Options options;
  options.good_energy = 0;
  options.most_partitions = 2;
  options.most_linear_maps = 1;
  VMP::Parameterization_search_3<Kernel, VMP::Default_solver_traits_3, Fickle_floor_map> search(options);
  Sequence partitions(unlabelled(solid_torus<Point>(24, 12, 1)));
  expect(search.run(partitions), VMP::OK);
  assert(search.trials().size() == 2 && search.linear_map().is_valid());
  expect(search.trials()[0].status, VMP::ERROR_FLOOR_MAP);
  assert(search.chosen().partition->method == search.trials()[1].partition->method);
}

// Notes the stages, and stops before the last.
struct Noting_visitor {
  std::vector<std::string>* stages;
  std::size_t last;
  bool start_stage(const char* name) {
    stages->push_back(name);
    return stages->size() < last;
  }
  bool advance(std::size_t, std::size_t) { return stages->size() < last; }
};

VMP::Status run(std::vector<std::string>& stages, std::size_t last, Search& search) {
  stages.clear();
  Sequence partitions(unlabelled(solid_torus<Point>(16, 8, 1)));
  return search.run(partitions, CGAL::parameters::visitor(Noting_visitor{&stages, last}));
}

// The visitor is told of each trial, and may stop in each stage; a map that was finished is kept.
void test_visitor() {
  Options options;
  options.good_energy = 0;
  options.most_partitions = 2;
  std::vector<std::string> all, stages;
  Search search(options);
  expect(run(all, 1000, search), VMP::OK);
  assert(std::count(all.begin(), all.end(), "partition") == 1 && std::count(all.begin(), all.end(), "map the boundary") == 1);
  assert(std::count(all.begin(), all.end(), "partition 2: map the boundary") == 1 && all.back() == "untangle");
  for (std::size_t last = 1; last <= all.size(); ++last) {
    Search stopped(options);
    expect(run(stages, last, stopped), VMP::ERROR_CANCELLED);
    assert(stages.size() == last && !stopped.linear_map().is_valid());
    const bool is_one_finished = std::count(stages.begin(), stages.end(), "partition 2: check the mesh") == 1;
    assert(!is_one_finished || stopped.parameterizer()->product_map());
  }
}

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN

void test_surface() {
  Search search;
  expect(VMP::parameterize_surface(block_surface<Point>(2, 1, 1), search, VMP::parameters::number_of_cells(500)), VMP::OK);
  test_result(search);
  assert(search.parameterizer()->partition().genus == 2);
}

#else

void test_surface() {}

#endif

int main() {
  test_given_labels();
  test_trials();
  test_curves_only();
  test_refusals();
  test_failure_of_first();
  test_visitor();
  test_surface();
  return EXIT_SUCCESS;
}
