#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Direct_product_3.h>

#include "io_test_util.h"
#include "solid_test_util.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cassert>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Soup = VMP::Tetrahedron_soup_3<Kernel::Point_3>;
using Product = VMP::Direct_product_3<Kernel>;

// Every stage has left its result, and the results fit together.
void test_results(const Product& product, int genus) {
  const Product::Mesh& mesh = product.mesh();
  assert(product.partition().genus == genus);
  assert(product.is_certified() && product.handlebody_certificate().genus() == genus);
  expect(VMP::verify_product(mesh, product.product_structure()->order()), VMP::OK);
  assert((product.sweep_report().refinements > 0) == (product.sweep_report().bisected_edges > 0));
  assert(product.dual_potential()->values().size() == mesh.number_of_cells());
  for (VMP::Facet_index f : mesh.boundary_facets())
    for (VMP::Vertex_index v : mesh.vertices(f)) {
      if (mesh.label(f) == VMP::FLOOR) assert((*product.harmonic_function())(v) == 0);
      if (mesh.label(f) == VMP::CEILING) assert((*product.harmonic_function())(v) == 1);
    }
}

// Every curve from the middle of a facet of the floor ends on the ceiling.
void test_curves(const Product& product) {
  const Product::Curves curves = product.curves();
  for (VMP::Facet_index f : floor_facets(product.mesh())) {
    VMP::Location_3<Kernel> at = curves.locate({f, {1. / 3, 1. / 3, 1. / 3}});
    VMP::Base_point_3<Kernel> end;
    double level = 0;
    expect(curves.trace_to_base(at, VMP::UP, end, level), VMP::OK);
    assert(product.mesh().label(end.facet) == VMP::CEILING && level > 0);
  }
}

void test_kinds_of_curves(int holes) {
  const Soup soup = shaped_block<Kernel::Point_3>(Shape::BENT, holes, 2, 3);
  for (VMP::Curve_type type : {VMP::CERTIFIED_CURVES, VMP::FLUX_CURVES}) {
    Product product;
    expect(product.build(soup, VMP::parameters::curve_type(type)), VMP::OK);
    test_results(product, holes);
    test_curves(product);
  }
}

// Two products are the same to the bit.
void expect_equal(const Product& a, const Product& b) {
  assert(a.mesh().points() == b.mesh().points());
  assert(a.harmonic_function()->values() == b.harmonic_function()->values());
  assert(a.dual_potential()->values() == b.dual_potential()->values());
  assert(a.product_structure()->order() == b.product_structure()->order());
  for (VMP::Cell_index c : a.mesh().cells()) assert(a.curve_field()->rates(c) == b.curve_field()->rates(c));
  for (VMP::Facet_index f : a.mesh().facets()) {
    assert(a.mesh().vertices(f) == b.mesh().vertices(f));
    assert(a.flux_field()->flux(f) == b.flux_field()->flux(f));
  }
}

void test_threads(const Soup& soup) {
  Product one;
  expect(one.build(soup), VMP::OK);
  for (std::size_t threads : {1, 2, 5}) {
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
#endif
    Product several;
    expect(several.build<CGAL::Parallel_if_available_tag>(soup), VMP::OK);
    expect_equal(one, several);
    std::cout << "the same with at most " << threads << " threads" << std::endl;
  }
}

// Finds no solution.
struct Failing_solver : VMP::Default_solver_traits_3 {
  bool linear_solver(const Vector&, Vector&) { return false; }
};

// Whether the solid is a handlebody is told, all the same; there are no fields.
template <typename Tag>
void test_failing_solver() {
  VMP::Direct_product_3<Kernel, Failing_solver> product;
  expect(product.build<Tag>(shaped_block<Kernel::Point_3>(Shape::PLAIN, 1, 2, 2)), VMP::ERROR_CANNOT_SOLVE);
  assert(product.is_certified() && product.handlebody_certificate().genus() == 1);
  assert(!product.harmonic_function() && !product.flux_field() && !product.dual_potential() && !product.product_structure());
}

// Lets a number of stages pass.
struct Impatient_visitor {
  int patience;
  bool start_stage(const char*) { return patience-- > 0; }
};

// What the stages before a failure have found is there, and nothing else.
void test_failures() {
  const Soup soup = shaped_block<Kernel::Point_3>(Shape::PLAIN, 1, 1, 1);
  for (int stages = 0; stages < 5; ++stages) {
    Product product;
    expect(product.build(soup, CGAL::parameters::visitor(Impatient_visitor{stages})), VMP::ERROR_CANCELLED);
    assert((product.mesh().number_of_cells() > 0) == (stages > 0));
    assert((product.partition().genus == 1) == (stages > 1));
    assert(bool(product.harmonic_function()) == (stages > 3) && bool(product.dual_potential()) == (stages > 3));
    assert(bool(product.flux_field()) == (stages > 3) && bool(product.product_structure()) == (stages > 3));
    assert(!product.curve_field() && product.is_certified() == (stages > 3));
  }
  Soup unlabelled = soup;
  unlabelled.facets.pop_back();
  Product product;
  expect(product.build(unlabelled), VMP::ERROR_UNLABELLED_FACET);
  assert(product.mesh().number_of_cells() == soup.cells.size() && !product.product_structure());
}

int main() {
  for (int holes = 0; holes <= 2; ++holes) test_kinds_of_curves(holes);
  test_threads(shaped_block<Kernel::Point_3>(Shape::JITTERED, 1, 3, 4));
  const Soup large = shaped_block<Kernel::Point_3>(Shape::JITTERED, 1, 13, 13);
  assert(large.cells.size() > 1 << 16); // several blocks of each loop
  test_threads(large);
  test_failures();
  test_failing_solver<CGAL::Sequential_tag>();
  test_failing_solver<CGAL::Parallel_if_available_tag>();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
