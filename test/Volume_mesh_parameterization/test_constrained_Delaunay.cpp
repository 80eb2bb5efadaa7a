#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/parameterize.h>

#include "io_test_util.h"
#include "surface_test_util.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = VMP::Triangle_soup_3<Point>;
using Soup = VMP::Tetrahedron_soup_3<Point>;

// The area of the triangles with each label; `labelled(i)` returns the vertices and the label of the i-th one.
template <typename Labelled>
std::map<int, double> areas(const std::vector<Point>& points, std::size_t n, const Labelled& labelled) {
  std::map<int, double> result;
  for (std::size_t i = 0; i < n; ++i) {
    const VMP::Labelled_facet f = labelled(i);
    const auto& v = f.vertices;
    result[f.label] += std::sqrt(CGAL::squared_area(points[v[0]], points[v[1]], points[v[2]]));
  }
  return result;
}

// Triangles may be cut, but each label keeps its place.
void test_labels_are_kept(const Surface& surface, const Soup& soup) {
  const auto before = areas(surface.points, surface.triangles.size(), [&](std::size_t i) {
    return VMP::Labelled_facet{surface.triangles[i], surface.labels[i]};
  });
  const auto after = areas(soup.points, soup.facets.size(), [&](std::size_t i) { return soup.facets[i]; });
  assert(before.size() == after.size());
  for (const auto& [label, area] : before) assert(std::abs(after.at(label) - area) < 1e-12 * area);
}

void test_meshes() {
  for (int holes : {0, 2})
    for (std::size_t n : {std::size_t(0), std::size_t(5000)}) {
      const Surface surface = block_surface<Point>(holes, 2, 2);
      Soup soup;
      expect(VMP::tetrahedralize(surface, soup, n), VMP::OK);
      std::cout << n << " cells wanted, got " << soup.cells.size() << std::endl;
      assert(soup.cells.size() >= n && (n == 0 || soup.cells.size() < n + 100));
      assert(std::equal(surface.points.begin(), surface.points.end(), soup.points.begin()));
      test_labels_are_kept(surface, soup);
      VMP::Compact_tetrahedral_mesh_3<Kernel> mesh;
      expect(mesh.assign(soup), VMP::OK);
      expect(VMP::check_tetrahedral_mesh(mesh), VMP::OK);
      assert(mesh.number_of_boundary_facets() == soup.facets.size());
    }
}

void test_parameterization() {
  VMP::Direct_product_parameterizer_3<Kernel> result;
  expect(VMP::parameterize_surface(block_surface<Point>(1, 2, 2), result,
                                   VMP::parameters::number_of_cells(2000)),
         VMP::OK);
  assert(result.partition().genus == 1 && result.mesh().number_of_cells() >= 2000);
  assert(result.product_structure()->order().size() == result.mesh().number_of_cells());
}

void test_refusals() {
  Soup soup;
  expect(VMP::tetrahedralize(self_intersecting_surface<Point>(), soup), VMP::ERROR_SELF_INTERSECTION,
         "triangles");
  assert(soup.cells.empty());
}

int main() {
  test_meshes();
  test_parameterization();
  test_refusals();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
