#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Volume_mesh_parameterization/check_surface.h>
#include <CGAL/Volume_mesh_parameterization/make_triangle_soup.h>

#include "io_test_util.h"
#include "surface_test_util.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <random>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Soup = VMP::Triangle_soup_3<Point>;

double volume(const Soup& soup) {
  double sum = 0;
  for (const auto& t : soup.triangles)
    sum += CGAL::volume(Point(0, 0, 0), soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
  return sum;
}

void test_good_surfaces() {
  for (int holes = 0; holes <= 3; ++holes) {
    const Soup soup = block_surface<Point>(holes, 2, 2);
    Soup checked = soup;
    expect(VMP::check_surface(checked), VMP::OK);
    assert(checked.triangles == soup.triangles && checked.points == soup.points && checked.labels == soup.labels);
    assert(VMP::genus(checked) == holes);
  }
}

// A triangle is reversed if it alone or the first one alone was turned.
void test_is_reversed(const Soup& turned, const Soup& soup) {
  std::vector<char> is_reversed;
  expect(VMP::check_closed_manifold(turned, is_reversed), VMP::OK);
  const auto is_turned = [&](std::size_t t) { return turned.triangles[t] != soup.triangles[t]; };
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    assert(bool(is_reversed[t]) == (is_turned(t) != is_turned(0)));
}

// However triangles are oriented, they end as they were.
void test_orientation() {
  const Soup soup = block_surface<Point>(1, 2, 2);
  std::mt19937 random(1);
  for (int first : {0, 1})
    for (int mixed : {0, 1}) {
      Soup turned = soup;
      for (std::size_t t = 0; t < turned.triangles.size(); ++t)
        if ((first + (t > 0 && mixed ? random() : 0)) % 2 == 1) std::swap(turned.triangles[t][1], turned.triangles[t][2]);
      test_is_reversed(turned, soup);
      expect(VMP::check_surface(turned), VMP::OK);
      assert(std::abs(volume(turned) - 8) < 1e-12);
      for (std::size_t t = 0; t < turned.triangles.size(); ++t) {
        auto triangle = turned.triangles[t];
        std::rotate(triangle.begin(), std::find(triangle.begin(), triangle.end(), soup.triangles[t][0]), triangle.end());
        assert(triangle == soup.triangles[t]);
      }
    }
}

void refuse(Soup soup, VMP::Error_code code, const std::string& culprit) {
  const Soup before = soup;
  expect(VMP::check_surface(soup), code, culprit);
  assert(soup.triangles == before.triangles);
}

// The parts of `check_surface()` by themselves: what is wrong with single triangles is found first.
void refuse_triangles(const Soup& soup, VMP::Error_code code, const std::string& culprit) {
  expect(VMP::check_triangles(soup), code, culprit);
  refuse(soup, code, culprit);
}

void refuse_topology(const Soup& soup, VMP::Error_code code, const std::string& culprit) {
  std::vector<char> is_reversed;
  expect(VMP::check_triangles(soup), VMP::OK);
  expect(VMP::check_closed_manifold(soup, is_reversed), code, culprit);
  refuse(soup, code, culprit);
}

// The surface together with its copy moved by v, equal points being one.
Soup with_moved_copy(const Soup& soup, const Kernel::Vector_3& v) {
  Soup both;
  std::map<Point, std::size_t> number;
  for (const Kernel::Vector_3& move : {Kernel::Vector_3(0, 0, 0), v})
    for (const auto& t : soup.triangles) {
      both.triangles.emplace_back();
      for (int i = 0; i < 3; ++i) {
        const auto inserted = number.emplace(soup.points[t[i]] + move, both.points.size());
        if (inserted.second) both.points.push_back(inserted.first->first);
        both.triangles.back()[i] = inserted.first->second;
      }
    }
  return both;
}

void test_refusals_of_triangles() {
  const Soup good = block_surface<Point>(0, 1, 1);
  expect(VMP::check_triangles(good), VMP::OK);
  refuse_triangles(Soup(), VMP::ERROR_EMPTY_MESH, "no triangles");
  Soup bad = good;
  bad.labels.pop_back();
  refuse_triangles(bad, VMP::ERROR_WRONG_PARAMETER, "labels");
  bad = good;
  bad.triangles[3][1] = bad.points.size();
  refuse_triangles(bad, VMP::ERROR_INDEX_OUT_OF_RANGE, "triangle 3 has the vertices");
  bad = good;
  bad.triangles[3][1] = bad.triangles[3][0];
  refuse_triangles(bad, VMP::ERROR_INDEX_OUT_OF_RANGE, "triangle 3 has the vertices");
  bad = good;
  bad.points[4] = Point(0, 0, std::numeric_limits<double>::quiet_NaN());
  refuse_triangles(bad, VMP::ERROR_COORDINATE_NOT_FINITE, "vertex 4");
  bad = good;
  const auto& t = bad.triangles[0];
  bad.points[t[0]] = CGAL::midpoint(bad.points[t[1]], bad.points[t[2]]);
  refuse_triangles(bad, VMP::ERROR_DEGENERATE_TRIANGLE, "triangle 0");
}

void test_refusals_of_topology() {
  const Soup good = block_surface<Point>(0, 1, 1);
  Soup bad = good;
  const auto removed = bad.triangles.back();
  bad.triangles.pop_back();
  bad.labels.clear();
  refuse_topology(bad, VMP::ERROR_OPEN_SURFACE, std::to_string(*std::min_element(removed.begin(), removed.end())));
  refuse_topology(with_moved_copy(good, {10, 0, 0}), VMP::ERROR_SEVERAL_COMPONENTS, "2 components");
  refuse_topology(with_moved_copy(good, {1, 3, 0}), VMP::ERROR_NON_MANIFOLD, "4 triangles share the edge between vertices");
  refuse_topology(with_moved_copy(good, {1, 3, 1}), VMP::ERROR_NON_MANIFOLD, "touch at vertex");

  Soup doubled;
  doubled.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  doubled.triangles = {{0, 1, 2}, {0, 2, 1}};
  refuse_topology(doubled, VMP::ERROR_NON_MANIFOLD, "triangles 0 and 1 have the same vertices");

  Soup projective_plane; // with 6 vertices
  projective_plane.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}, {4, 1, 1}};
  projective_plane.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                                {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  refuse_topology(projective_plane, VMP::ERROR_NON_MANIFOLD, "one side only");
}

// Triangles that intersect may well be a closed manifold.
void test_refusal_of_intersections() {
  const Soup soup = self_intersecting_surface<Point>();
  std::vector<char> is_reversed;
  expect(VMP::check_closed_manifold(soup, is_reversed), VMP::OK);
  refuse(soup, VMP::ERROR_SELF_INTERSECTION, "triangles");
}

void test_face_list_graph() {
  const Soup soup = block_surface<Point>(1, 1, 1);
  CGAL::Surface_mesh<Point> mesh = VMP::internal::make_surface_mesh(soup);
  Soup back;
  expect(VMP::make_triangle_soup(mesh, back), VMP::OK);
  assert(back.points == soup.points && back.triangles.size() == soup.triangles.size());
  assert(volume(back) == volume(soup));

  const auto moved = mesh.add_property_map<CGAL::Surface_mesh<Point>::Vertex_index, Point>("v:moved").first;
  for (auto v : mesh.vertices()) moved[v] = mesh.point(v) + Kernel::Vector_3(0, 0, 5);
  expect(VMP::make_triangle_soup(mesh, back, CGAL::parameters::vertex_point_map(moved)), VMP::OK);
  assert(back.points[0] == soup.points[0] + Kernel::Vector_3(0, 0, 5));

  mesh.clear();
  std::vector<CGAL::Surface_mesh<Point>::Vertex_index> square;
  for (const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})
    square.push_back(mesh.add_vertex(p));
  mesh.add_face(square);
  expect(VMP::make_triangle_soup(mesh, back), VMP::ERROR_NOT_TRIANGULATED, "face 0 has 4 vertices");
}

void test_isolated_points() {
  const Soup soup = block_surface<Point>(1, 1, 1);
  Soup more = soup;
  more.points.insert(more.points.begin() + 5, Point(7, 7, 7));
  for (auto& t : more.triangles)
    for (std::size_t& v : t) v += v >= 5;
  Soup checked = more;
  expect(VMP::check_surface(checked), VMP::OK);
  assert(VMP::genus(checked) == 1);
  VMP::remove_isolated_points(more);
  assert(more.points == soup.points && more.triangles == soup.triangles);
}

int main() {
  test_good_surfaces();
  test_orientation();
  test_refusals_of_triangles();
  test_refusals_of_topology();
  test_refusal_of_intersections();
  test_face_list_graph();
  test_isolated_points();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
