#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/verify_map.h>

#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;

template <typename GeomTraits>
VMP::Compact_tetrahedral_mesh_3<GeomTraits>
make_mesh(const VMP::Tetrahedron_soup_3<typename GeomTraits::Point_3>& soup) {
  VMP::Compact_tetrahedral_mesh_3<GeomTraits> mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  return mesh;
}

template <typename Function>
std::vector<Point> move(const Mesh& mesh, Function function) {
  std::vector<Point> images;
  for (const Point& p : mesh.points()) images.push_back(function(p.x(), p.y(), p.z()));
  return images;
}

template <typename GeomTraits>
void test_identity() {
  for (int holes = 0; holes < 3; ++holes) {
    const auto mesh =
        make_mesh<GeomTraits>(Block_with_holes<typename GeomTraits::Point_3>(holes, 2, 3).soup());
    const VMP::Map_report report = VMP::verify_map(mesh, mesh.points());
    assert(report.is_bijective() && report.is_polycube_map());
    assert(report.flipped == 0 && report.flat == 0 && report.off_axis == 0 && report.overlaps == 0);
  }
}

void test_affine() {
  const Mesh mesh = make_mesh<Kernel>(Block_with_holes<Point>(1, 2, 2).soup());
  const auto sheared =
      VMP::verify_map(mesh, move(mesh, [](double x, double y, double z) { return Point(x + y, y, z); }));
  assert(sheared.is_bijective() && !sheared.is_polycube_map());
  std::size_t along_x = 0; // the triangles in planes x = constant leave the axes
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    along_x += mesh.point(v[0]).x() == mesh.point(v[1]).x() && mesh.point(v[1]).x() == mesh.point(v[2]).x();
  }
  assert(sheared.off_axis == along_x && along_x > 0);
  const auto mirrored =
      VMP::verify_map(mesh, move(mesh, [](double x, double y, double z) { return Point(-x, y, z); }));
  assert(mirrored.flipped == mesh.number_of_cells() && mirrored.flat == 0);
  assert(mirrored.status.code() == VMP::ERROR_MAP_NOT_BIJECTIVE);
  const auto flat =
      VMP::verify_map(mesh, move(mesh, [](double x, double y, double) { return Point(x, y, 0); }));
  assert(flat.flat == mesh.number_of_cells() && flat.flipped == 0 && !flat.is_bijective());
}

// Moving an interior vertex across a facet of its star flips exactly the tetrahedra that see it from behind.
void test_fold() {
  const Mesh mesh = make_mesh<Kernel>(Block_with_holes<Point>(0, 2, 2).soup());
  std::vector<Point> images = mesh.points();
  const auto center = std::find(images.begin(), images.end(), Point(0.5, 1, 0.5));
  *center = Point(1.25, 1, 0.5);
  std::size_t flipped = 0;
  for (VMP::Cell_index c : mesh.cells()) {
    const auto& v = mesh.cell(c);
    flipped += CGAL::volume(images[v[0]], images[v[1]], images[v[2]], images[v[3]]) < 0;
  }
  const VMP::Map_report report = VMP::verify_map(mesh, images);
  assert(flipped > 0 && report.flipped == flipped);
  assert(report.status.code() == VMP::ERROR_MAP_NOT_BIJECTIVE);
  assert(report.status.detail().find("is flipped") != std::string::npos);
}

// A bar bent by 360 degrees and more runs into itself though all of its tetrahedra stay positive.
void test_overlapping_boundary() {
  Soup soup = Block_with_holes<Point>(0, 1, 24, 24).soup();
  const Mesh mesh = make_mesh<Kernel>(soup);
  const auto bend = [&](double angle) {
    return VMP::verify_map(mesh, move(mesh, [angle](double x, double y, double z) {
                             const double radius = 3 - x, t = angle * z / 24;
                             return Point(-radius * std::cos(t), y, radius * std::sin(t));
                           }));
  };
  const VMP::Map_report horseshoe = bend(6.0), ring = bend(6.6);
  assert(horseshoe.is_bijective() && horseshoe.off_axis > 0);
  assert(ring.flipped == 0 && ring.flat == 0 && ring.overlaps > 0);
  assert(ring.status.code() == VMP::ERROR_MAP_NOT_BIJECTIVE);
  assert(ring.status.detail().find("overlap") != std::string::npos);
}

// Six wedges wound twice around a vertical edge: all are positive, the boundary meets itself.
void test_winding_edge() {
  const int n = 12;
  Soup soup;
  soup.points = {Point(0, 0, 0), Point(0, 0, 1)};
  std::vector<Point> wound = soup.points;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * CGAL_PI * i / n;
    soup.points.push_back(Point(std::cos(t), std::sin(t), 0));
    wound.push_back(Point(std::cos(2 * t), std::sin(2 * t), 0));
    soup.cells.push_back({0, std::size_t(2 + i), std::size_t(2 + (i + 1) % n), 1});
  }
  const Mesh mesh = make_mesh<Kernel>(soup);
  assert(VMP::verify_map(mesh, soup.points).is_bijective());
  const VMP::Map_report report = VMP::verify_map(mesh, wound);
  assert(report.flipped == 0 && report.flat == 0 && report.overlaps > 0 && !report.is_bijective());
}

// Pairs of triangles in every relation.
void test_triangle_overlaps() {
  using Overlaps = VMP::internal::Triangle_overlaps<Kernel>;
  const std::vector<Point> p = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0},   {1, 1, 0},   {1, 1, 1},
                                {1, 0, 1}, {0, 0, 2}, {4, 0, 0}, {.5, .5, 0}, {.5, .5, 1}, {1, 1, -1}};
  const auto overlap = [&](Overlaps::Triangle a, Overlaps::Triangle b) {
    const std::vector<Overlaps::Triangle> pair = {a, b}, swapped = {b, a};
    const bool result = !Overlaps(p, pair).find().empty();
    assert(result == !Overlaps(p, swapped).find().empty());
    return result;
  };
  assert(overlap({0, 1, 2}, {2, 0, 1}));  // the same vertices
  assert(!overlap({0, 1, 2}, {1, 3, 2})); // a common edge, coplanar, on both sides
  assert(overlap({0, 1, 2}, {0, 1, 9}));  // a common edge, coplanar, on one side
  assert(!overlap({0, 1, 2}, {0, 1, 7})); // a common edge, not coplanar
  assert(!overlap({0, 1, 2}, {1, 8, 6})); // a common vertex
  assert(overlap({0, 1, 2}, {0, 3, 7}));  // a common vertex, the inner edge reaches the other edge
  assert(overlap({0, 1, 2}, {0, 9, 10})); // a common vertex, an edge inside
  assert(!overlap({0, 1, 9}, {2, 3, 5})); // disjoint
  assert(overlap({0, 1, 2}, {9, 10, 8})); // no common vertex, one touches the other
  assert(overlap({0, 1, 2}, {11, 5, 3})); // no common vertex, an edge touches an edge
}

VMP::Error_code code_of(const Soup& soup) {
  const Mesh mesh = make_mesh<Kernel>(soup);
  return VMP::verify_map(mesh, mesh.points()).status.code();
}

void test_refusals() {
  const Mesh mesh = make_mesh<Kernel>(Block_with_holes<Point>(0, 1, 1).soup());
  std::vector<Point> images = mesh.points();
  images.pop_back();
  assert(VMP::verify_map(mesh, images).status.code() == VMP::ERROR_WRONG_PARAMETER);
  images.push_back(Point(0, std::numeric_limits<double>::quiet_NaN(), 0));
  assert(VMP::verify_map(mesh, images).status.code() == VMP::ERROR_COORDINATE_NOT_FINITE);
  images.back() = Point(0, 0, -std::numeric_limits<double>::infinity());
  assert(VMP::verify_map(mesh, images).status.code() == VMP::ERROR_COORDINATE_NOT_FINITE);

  Soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, .5}, {-1, 0, 0}, {0, -1, 0}};
  soup.cells = {{0, 1, 2, 3}};
  assert(code_of(soup) == VMP::OK);
  soup.cells = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  assert(code_of(soup) == VMP::OK);
  soup.cells = {{0, 1, 2, 3}, {0, 1, 2, 5}}; // both on one side of their facet
  assert(code_of(soup) == VMP::ERROR_INVERTED_TETRAHEDRON);
  soup.cells = {{0, 1, 2, 3}, {0, 6, 7, 3}}; // only an edge in common
  assert(code_of(soup) == VMP::ERROR_NON_MANIFOLD);
  soup.points.insert(soup.points.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}});
  soup.cells = {{0, 1, 2, 3}, {8, 9, 10, 11}};
  assert(code_of(soup) == VMP::ERROR_SEVERAL_COMPONENTS);
}

int main() {
  test_identity<Kernel>();
  test_identity<CGAL::Exact_predicates_exact_constructions_kernel>();
  test_affine();
  test_fold();
  test_overlapping_boundary();
  test_winding_edge();
  test_triangle_overlaps();
  test_refusals();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
