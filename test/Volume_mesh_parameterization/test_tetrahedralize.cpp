#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/tetrahedralize.h>

#include "io_test_util.h"
#include "surface_test_util.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <iostream>
#include <map>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = VMP::Triangle_soup_3<Point>;
using Soup = VMP::Tetrahedron_soup_3<Point>;

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN

std::array<std::size_t, 3> sorted(std::array<std::size_t, 3> v) {
  std::sort(v.begin(), v.end());
  return v;
}

// The facets are the triangles of the surface, and label_of(i) is on the one that was triangle i.
template <typename LabelOf>
void test_surface_is_kept(const Surface& surface, const Soup& soup, const LabelOf& label_of) {
  std::map<std::array<std::size_t, 3>, int> label;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) label[sorted(surface.triangles[t])] = label_of(t);
  assert(std::equal(surface.points.begin(), surface.points.end(), soup.points.begin()));
  assert(soup.facets.size() == surface.triangles.size());
  for (const VMP::Labelled_facet& facet : soup.facets) assert(label.at(sorted(facet.vertices)) == facet.label);
  VMP::Compact_tetrahedral_mesh_3<Kernel> mesh;
  expect(mesh.assign(soup), VMP::OK);
  expect(VMP::check_tetrahedral_mesh(mesh), VMP::OK);
  assert(mesh.number_of_boundary_facets() == surface.triangles.size());
}

void test_meshes() {
  for (int holes : {0, 2}) {
    Surface surface = block_surface<Point>(holes, 2, 2);
    for (std::size_t n : {std::size_t(0), std::size_t(5000), std::size_t(20000)}) {
      Soup soup;
      expect(VMP::tetrahedralize(surface, soup, n), VMP::OK);
      test_surface_is_kept(surface, soup, [&](std::size_t t) { return surface.labels[t]; });
      std::cout << n << " cells wanted, got " << soup.cells.size() << std::endl;
      assert(n == 0 || (2 * soup.cells.size() > n && 2 * soup.cells.size() < 3 * n));
    }
    surface.labels.clear();
    Soup soup;
    expect(VMP::tetrahedralize(surface, soup), VMP::OK);
    test_surface_is_kept(surface, soup, [](std::size_t t) { return int(t); });
  }
  VMP::Tetrahedron_soup_3<CGAL::Exact_predicates_exact_constructions_kernel::Point_3> exact;
  expect(VMP::tetrahedralize(block_surface<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>(1, 1, 1), exact),
         VMP::OK);
}

void refuse(const Surface& surface, VMP::Error_code code, const std::string& culprit) {
  Soup soup;
  expect(VMP::tetrahedralize(surface, soup), code, culprit);
  assert(soup.points.empty() && soup.cells.empty());
}

void test_refusals() {
  refuse(Surface(), VMP::ERROR_EMPTY_MESH, "no triangles");
  refuse(self_intersecting_surface<Point>(), VMP::ERROR_SELF_INTERSECTION, "triangles");
  Surface open = block_surface<Point>(0, 1, 1);
  open.triangles.pop_back(), open.labels.pop_back();
  refuse(open, VMP::ERROR_OPEN_SURFACE, "is in triangle");
  Soup none; // TetGen fails or crashes by itself: this program goes on
  const Surface crossing = self_intersecting_surface<Point>();
  expect(VMP::internal::Tetgen_mesher<Point>(crossing).mesh(0, none), VMP::ERROR_TETRAHEDRALIZATION, "TetGen");
  Soup flat;
  flat.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  flat.cells = {{0, 1, 2, 3}};
  expect(VMP::internal::check_mesher_output(flat), VMP::ERROR_TETRAHEDRALIZATION, "a bad mesh: a tetrahedron is flat");
}

int main() {
  test_meshes();
  test_refusals();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}

#else

int main() {
  Soup soup;
  expect(VMP::tetrahedralize(block_surface<Point>(0, 1, 1), soup), VMP::ERROR_MISSING_LIBRARY, "TetGen");
  std::cout << "done, without TetGen" << std::endl;
  return EXIT_SUCCESS;
}

#endif
