#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Soup = VMP::Hexahedron_soup_3<Point>;

// The unit cubes of a box that `is_solid` keeps.
template <typename Point_3 = Point>
VMP::Hexahedron_soup_3<Point_3> make_grid(
    int nx, int ny, int nz,
    const std::function<bool(int, int, int)>& is_solid = [](int, int, int) { return true; }) {
  VMP::Hexahedron_soup_3<Point_3> soup;
  const auto vertex = [&](int x, int y, int z) { return std::size_t((z * (ny + 1) + y) * (nx + 1) + x); };
  for (int z = 0; z <= nz; ++z)
    for (int y = 0; y <= ny; ++y)
      for (int x = 0; x <= nx; ++x) soup.points.emplace_back(x, y, z);
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x)
        if (is_solid(x, y, z))
          soup.hexahedra.push_back({vertex(x, y, z), vertex(x + 1, y, z), vertex(x + 1, y + 1, z),
                                    vertex(x, y + 1, z), vertex(x, y, z + 1), vertex(x + 1, y, z + 1),
                                    vertex(x + 1, y + 1, z + 1), vertex(x, y + 1, z + 1)});
  return soup;
}

template <typename Point_3>
void test_box() {
  const VMP::Hexahedra_report report = VMP::verify_hexahedra(make_grid<Point_3>(3, 4, 5));
  assert(report.is_valid() && report.genus == 0 && report.boundary_components == 1 &&
         report.boundary_is_manifold);
  assert(report.inverted == 0 && report.poor == 0 && report.non_manifold_facets == 0);
  assert(report.irregular_edges == 0 && report.irregular_vertices == 0);
  assert(report.minimum_scaled_jacobian == 1 && report.mean_scaled_jacobian == 1);
}

void test_genus() {
  const auto hole = [](int x, int y, int) { return y != 1 || x % 2 == 0; };
  for (int genus = 1; genus < 4; ++genus) {
    const auto report = VMP::verify_hexahedra(make_grid(2 * genus + 1, 3, 2, hole));
    assert(report.is_valid() && report.genus == genus && report.euler_characteristic == 1 - genus);
  }
}

// All corners of a sheared cube are alike: the scaled Jacobian is 1 / |(s, 0, 1)|.
void test_shear() {
  for (double s : {0.5, 2., 4.8, 5.}) {
    Soup soup = make_grid(2, 2, 2);
    for (Point& p : soup.points) p = Point(p.x() + s * p.z(), p.y(), p.z());
    const auto report = VMP::verify_hexahedra(soup);
    const double expected = 1 / std::sqrt(1 + s * s);
    assert(std::abs(report.minimum_scaled_jacobian - expected) < 1e-14);
    assert(std::abs(report.mean_scaled_jacobian - expected) < 1e-14);
    assert(report.is_valid() && report.poor == (s == 5 ? 8 : 0));
  }
}

void test_inverted() {
  Soup soup = make_grid(2, 2, 2);
  soup.points[13] = Point(1.33, 1.33, 1.33); // the centre: the last cube is inverted beyond 4/3
  assert(VMP::verify_hexahedra(soup).inverted == 0);
  soup.points[13] = Point(1.34, 1.34, 1.34);
  auto report = VMP::verify_hexahedra(soup);
  assert(report.inverted == 1 && report.minimum_scaled_jacobian < 0);
  assert(report.status.code() == VMP::ERROR_INVERTED_HEXAHEDRON && report.status.detail() == "hexahedron 7");
  soup = make_grid(1, 1, 1);
  soup.points[7] = soup.points[6]; // a corner without volume
  assert(VMP::verify_hexahedra(soup).inverted == 1);
  soup = make_grid(2, 3, 1);
  for (Point& p : soup.points) p = Point(-p.x(), p.y(), p.z());
  report = VMP::verify_hexahedra(soup);
  assert(report.inverted == 6 && report.minimum_scaled_jacobian == -1 && report.poor == 6);
}

// A regular prism with 2n sides, cut into n hexahedra in each of two layers around its axis.
Soup make_prism(int n) {
  Soup soup;
  const auto vertex = [n](int layer, int i) { return std::size_t(layer * (2 * n + 1) + 1 + i % (2 * n)); };
  for (int layer = 0; layer < 3; ++layer) {
    soup.points.push_back(Point(0, 0, layer));
    for (int i = 0; i < 2 * n; ++i) {
      const double t = CGAL_PI * i / n;
      soup.points.push_back(Point(std::cos(t), std::sin(t), layer));
    }
  }
  for (int layer = 0; layer < 2; ++layer)
    for (int i = 0; i < 2 * n; i += 2) {
      const std::size_t axis = layer * (2 * n + 1), above = axis + 2 * n + 1;
      soup.hexahedra.push_back({axis, vertex(layer, i), vertex(layer, i + 1), vertex(layer, i + 2), above,
                                vertex(layer + 1, i), vertex(layer + 1, i + 1), vertex(layer + 1, i + 2)});
    }
  return soup;
}

void test_irregular() {
  for (int n : {3, 4, 5, 6}) {
    const auto report = VMP::verify_hexahedra(make_prism(n));
    assert(report.is_valid() && report.genus == 0);
    assert(report.irregular_edges == (n == 4 ? 0 : 2) && report.irregular_vertices == (n == 4 ? 0 : 1));
    assert(std::abs(report.minimum_scaled_jacobian - std::sin(CGAL_PI / n)) < 1e-14);
  }
}

VMP::Error_code code_of(const Soup& soup) { return VMP::verify_hexahedra(soup).status.code(); }

void test_refusals() {
  assert(code_of(Soup()) == VMP::ERROR_EMPTY_MESH);
  Soup bad = make_grid(1, 1, 2);
  bad.hexahedra[1][3] = 99;
  assert(code_of(bad) == VMP::ERROR_INDEX_OUT_OF_RANGE);
  bad.hexahedra[1][3] = bad.hexahedra[1][0];
  assert(code_of(bad) == VMP::ERROR_INDEX_OUT_OF_RANGE);
  bad = make_grid(1, 1, 1);
  bad.points[2] = Point(0, std::numeric_limits<double>::infinity(), 0);
  assert(code_of(bad) == VMP::ERROR_COORDINATE_NOT_FINITE);

  bad = make_grid(1, 1, 3); // the cubes 0 and 1, and one more on their common facet
  auto third = bad.hexahedra[1];
  for (int i = 4; i < 8; ++i) third[i] += 4;
  bad.hexahedra[2] = third;
  auto report = VMP::verify_hexahedra(bad);
  assert(report.non_manifold_facets == 1 && report.status.code() == VMP::ERROR_NON_MANIFOLD);

  report =
      VMP::verify_hexahedra(make_grid(2, 2, 1, [](int x, int y, int) { return x == y; })); // share an edge
  assert(!report.boundary_is_manifold && report.genus == -1 &&
         report.status.code() == VMP::ERROR_NON_MANIFOLD);
  report = VMP::verify_hexahedra(make_grid(2, 2, 2, [](int x, int y, int z) { return x == y && y == z; }));
  assert(!report.boundary_is_manifold && report.status.code() == VMP::ERROR_NON_MANIFOLD); // share a vertex
  report = VMP::verify_hexahedra(make_grid(3, 1, 1, [](int x, int, int) { return x != 1; }));
  assert(report.boundary_components == 2 && report.status.code() == VMP::ERROR_SEVERAL_COMPONENTS);
}

int main() {
  test_box<Point>();
  test_box<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>();
  test_genus();
  test_shear();
  test_inverted();
  test_irregular();
  test_refusals();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
