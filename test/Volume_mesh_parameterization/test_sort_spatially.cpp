#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/sort_spatially.h>

#include "test_util.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

namespace VMP = CGAL::Volume_mesh_parameterization;

template <typename Point>
VMP::Tetrahedron_soup_3<Point> shuffled(VMP::Tetrahedron_soup_3<Point> soup) {
  std::mt19937 random(5);
  std::vector<std::size_t> order(soup.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), random);
  const std::vector<Point> points = soup.points;
  for (std::size_t i = 0; i < order.size(); ++i) soup.points[order[i]] = points[i];
  for (auto& cell : soup.cells)
    for (std::size_t& v : cell) v = order[v];
  for (auto& facet : soup.facets)
    for (std::size_t& v : facet.vertices) v = order[v];
  std::shuffle(soup.cells.begin(), soup.cells.end(), random);
  return soup;
}

// The simplices, each as the list of its points, in an order that does not depend on numbers.
template <typename Simplices, typename Points, typename VerticesOf>
auto by_points(const Simplices& simplices, const Points& points, const VerticesOf& vertices_of) {
  std::vector<std::vector<typename Points::value_type>> result;
  for (const auto& simplex : simplices) {
    result.emplace_back();
    for (std::size_t v : vertices_of(simplex)) result.back().push_back(points[v]);
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <typename Soup>
void test_same_mesh(const Soup& a, const Soup& b) {
  const auto cell = [](const auto& c) { return c; };
  const auto facet = [](const auto& f) { return f.vertices; };
  assert(by_points(a.cells, a.points, cell) == by_points(b.cells, b.points, cell));
  for (int label = 0; label <= 5; ++label) {
    const auto of_label = [&](const Soup& soup) {
      auto facets = soup.facets;
      facets.erase(std::remove_if(facets.begin(), facets.end(), [&](const auto& f) { return f.label != label; }),
                   facets.end());
      return by_points(facets, soup.points, facet);
    };
    assert(of_label(a) == of_label(b));
  }
}

// How far apart the numbers of the ends of an edge are in the mean, and those of neighboring cells.
template <typename Kernel>
std::pair<double, double> mean_distances(const VMP::Tetrahedron_soup_3<typename Kernel::Point_3>& soup) {
  VMP::Compact_tetrahedral_mesh_3<Kernel> mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  const auto distance = [](double i, double j) { return std::abs(i - j); };
  double vertices = 0, cells = 0;
  std::size_t pairs = 0;
  for (VMP::Facet_index f : mesh.facets()) {
    if (mesh.is_boundary(f)) continue;
    ++pairs;
    vertices += distance(mesh.vertices(f)[0], mesh.vertices(f)[1]);
    cells += distance(mesh.half_facet(f, 0).cell, mesh.half_facet(f, 1).cell);
  }
  return {vertices / double(pairs), cells / double(pairs)};
}

template <typename Kernel>
void test(int holes, std::size_t points_to_keep) {
  using Point = typename Kernel::Point_3;
  const VMP::Tetrahedron_soup_3<Point> soup = shuffled(Block_with_holes<Point>(holes, 5, 5).soup());
  auto sorted = soup;
  VMP::sort_spatially(sorted, points_to_keep);
  test_same_mesh(soup, sorted);
  assert(std::equal(soup.points.begin(), soup.points.begin() + std::ptrdiff_t(points_to_keep), sorted.points.begin()));
  const auto [vertices_before, cells_before] = mean_distances<Kernel>(soup);
  const auto [vertices, cells] = mean_distances<Kernel>(sorted);
  std::cout << "mean distance of numbers: vertices " << vertices_before << " -> " << vertices << ", cells "
            << cells_before << " -> " << cells << std::endl;
  assert(cells < cells_before / 4 && (points_to_keep > 0 || vertices < vertices_before / 3));
  auto again = soup;
  VMP::sort_spatially(again, points_to_keep);
  assert(again.points == sorted.points && again.cells == sorted.cells);
}

int main() {
  using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  for (int holes : {0, 2})
    for (std::size_t points_to_keep : {0, 100}) test<Inexact>(holes, points_to_keep);
  test<Exact>(1, 50);
  VMP::Tetrahedron_soup_3<Inexact::Point_3> none;
  VMP::sort_spatially(none);
  assert(none.points.empty() && none.cells.empty());
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
