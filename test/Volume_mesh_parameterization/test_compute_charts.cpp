#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/compute_charts.h>

#include "io_test_util.h"
#include "solid_test_util.h"

#include <cassert>
#include <cstdlib>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

template <typename Kernel>
using Locations = std::vector<VMP::Location_3<Kernel>>;

// Random points inside of cells, on their facets and edges, and at vertices.
template <typename Kernel>
Locations<Kernel> random_points(const VMP::Compact_tetrahedral_mesh_3<Kernel>& mesh, std::size_t n) {
  Random random{5};
  Locations<Kernel> result;
  for (std::size_t k = 0; k < n; ++k) {
    const unsigned mask = k % 2 == 0 ? 15 : 1 + unsigned(random.below(15));
    const VMP::Cell_index c(random.below(mesh.number_of_cells()));
    result.push_back({c, random.template weights<typename Kernel::FT, 4>(mask)});
  }
  return result;
}

template <typename Point>
bool are_equal(const Point& p, const Point& q) {
  return p.facet == q.facet && p.barycentric == q.barycentric;
}

// One curve after the other gives the same, to the bit.
template <typename Tag, typename Kernel>
void test_charts(const VMP::Integral_curves_3<Kernel>& curves, const Locations<Kernel>& points) {
  std::vector<VMP::Curve_chart_3<Kernel>> charts;
  expect(VMP::compute_charts<Tag>(curves, points, charts), VMP::OK);
  assert(charts.size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    VMP::Curve_chart_3<Kernel> chart;
    expect(curves.trace_to_base(points[i], VMP::DOWN, chart.floor, chart.below), VMP::OK);
    expect(curves.trace_to_base(points[i], VMP::UP, chart.ceiling, chart.above), VMP::OK);
    assert(are_equal(chart.floor, charts[i].floor) && are_equal(chart.ceiling, charts[i].ceiling));
    assert(chart.below == charts[i].below && chart.above == charts[i].above && chart.share() == charts[i].share());
    assert(charts[i].share() >= 0 && charts[i].share() <= 1);
  }
}

template <typename Kernel>
void test(int holes, const std::vector<std::size_t>& numbers) {
  const Swept_solid<Kernel> solid(shaped_block<typename Kernel::Point_3>(Shape::TWISTED, holes, 2, 3));
  const auto field = solid.certified_field();
  const VMP::Integral_curves_3<Kernel> curves(solid.mesh, field);
  for (std::size_t n : numbers) {
    const Locations<Kernel> points = random_points(solid.mesh, n);
    test_charts<CGAL::Sequential_tag>(curves, points);
    test_charts<CGAL::Parallel_if_available_tag>(curves, points);
  }
}

// Of several curves that are lost the first one is told, and no chart is given.
void test_lost() {
  const Swept_solid<Inexact> solid(shaped_block<Inexact::Point_3>(Shape::PLAIN, 0, 2, 2));
  const VMP::Curve_field_3<Inexact> still(solid.mesh, Given_flux{Rates(solid.mesh.number_of_cells())}, solid.harmonic);
  const VMP::Integral_curves_3<Inexact> curves(solid.mesh, still);
  std::vector<VMP::Curve_chart_3<Inexact>> charts(3);
  Locations<Inexact> points = random_points(solid.mesh, 200);
  const VMP::Status status = VMP::compute_charts<CGAL::Parallel_if_available_tag>(curves, points, charts);
  expect(status, VMP::ERROR_CURVE_LOST);
  assert(status.detail() == "tetrahedron " + std::to_string(points[0].cell) + " has no facet to leave by");
  assert(charts.size() == 3);
}

// A curve that goes round for ever is told too.
void test_whirl() {
  const Swept_solid<Inexact> solid(shaped_block<Inexact::Point_3>(Shape::PLAIN, 0, 2, 2));
  VMP::Cell_index cell;
  const VMP::Curve_field_3<Inexact> field(solid.mesh, Given_flux{whirl(solid, cell)}, solid.harmonic);
  const VMP::Integral_curves_3<Inexact> curves(solid.mesh, field);
  std::vector<VMP::Curve_chart_3<Inexact>> charts;
  const Locations<Inexact> points(5, {cell, {0.25, 0.25, 0.25, 0.25}});
  const VMP::Status status = VMP::compute_charts(curves, points, charts);
  expect(status, VMP::ERROR_CURVE_LOST);
  assert(status.detail().find("is passed twice") != std::string::npos);
}

int main() {
  test<Inexact>(0, {0, 1, 2, 3, 127, 128, 129, 1000});
  test<Inexact>(2, {500});
  test<Exact>(1, {50});
  test_lost();
  test_whirl();
  return EXIT_SUCCESS;
}
