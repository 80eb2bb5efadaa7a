#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Floor_map_2.h>

#include "test_util.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <random>
#include <set>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

template <typename Kernel>
using Soup = VMP::Tetrahedron_soup_3<typename Kernel::Point_3>;

// Moves the vertices of the bottom by less than a quarter of the edges in the plane, and up and down.
template <typename Kernel>
Soup<Kernel> jittered(Soup<Kernel> soup, double edge, double amplitude, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amplitude * edge, amplitude * edge);
  for (auto& p : soup.points)
    if (p.z() == 0) p = typename Kernel::Point_3(p.x() + shift(random), p.y() + shift(random), shift(random));
  return soup;
}

template <typename Kernel>
VMP::Compact_tetrahedral_mesh_3<Kernel> make_mesh(const Soup<Kernel>& soup) {
  VMP::Compact_tetrahedral_mesh_3<Kernel> mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  return mesh;
}

// Positive triangles that cover the base once, by their area, and whose borders lie on the sides.
template <typename Kernel>
void test_is_one_to_one(const VMP::Floor_map_2<Kernel>& map) {
  double area = 0;
  for (std::size_t t = 0; t < map.number_of_triangles(); ++t) {
    const auto& v = map.triangle(t);
    assert(CGAL::orientation(map.image(v[0]), map.image(v[1]), map.image(v[2])) == CGAL::LEFT_TURN);
    area += CGAL::to_double(CGAL::area(map.image(v[0]), map.image(v[1]), map.image(v[2])));
  }
  assert(map.domain().is_valid() && std::abs(area - map.domain().base_area()) < 1e-9 * area);
}

// Each rim of the floor goes to that rim of the base whose label its wall has, and nothing else goes to the border.
template <typename Kernel>
void test_rims(const VMP::Compact_tetrahedral_mesh_3<Kernel>& mesh, const VMP::Floor_map_2<Kernel>& map) {
  std::vector<int> wall(mesh.number_of_vertices(), 0);
  for (VMP::Facet_index f : mesh.boundary_facets())
    if (mesh.label(f) >= VMP::FIRST_WALL)
      for (VMP::Vertex_index v : mesh.vertices(f)) wall[v] = mesh.label(f);
  std::set<int> seen;
  for (std::size_t v = 0; v < map.number_of_vertices(); ++v) {
    const std::size_t rim = map.domain().rim_at(map.image(v));
    const bool on_rim = rim < map.domain().number_of_rims();
    if (!map.mesh_vertex(v).is_valid()) continue;
    assert(wall[map.mesh_vertex(v)] == (on_rim ? map.domain().wall_label(rim) : 0));
    if (on_rim) seen.insert(map.domain().wall_label(rim));
  }
  assert(seen.size() == map.domain().number_of_rims());
}

// The corners of the refined triangles have exact places.
template <typename Kernel>
void test_corners(const VMP::Floor_map_2<Kernel>& map) {
  for (std::size_t t = 0; t < map.number_of_triangles(); ++t)
    for (int i = 0; i < 3; ++i) assert(map.image(map.corner(t, i)) == map.image(map.triangle(t)[i]));
}

template <typename Kernel>
double distance(const typename Kernel::Point_2& p, const typename Kernel::Point_2& q) {
  return std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
}

template <typename Kernel>
void test_round_trips(const VMP::Floor_map_2<Kernel>& map, int points, double tolerance) {
  std::mt19937 random(7);
  const VMP::Rectangle_2& box = map.domain().outer();
  std::uniform_real_distribution<double> x(box.xmin, box.xmax), y(box.ymin, box.ymax);
  for (int k = 0; k < points;) {
    const typename Kernel::Point_2 p(x(random), y(random));
    VMP::Base_point_3<Kernel> q;
    const VMP::Status status = map.preimage(p, q);
    assert(status.ok() == (map.domain().bounded_side(p) != CGAL::ON_UNBOUNDED_SIDE));
    if (!status.ok()) continue;
    assert(std::abs(CGAL::to_double(q.barycentric[0] + q.barycentric[1] + q.barycentric[2]) - 1) < 1e-14);
    assert(distance<Kernel>(map.image(q), p) <= tolerance * box.width());
    ++k;
  }
}

// Points on the sides come from edges of the rim: the third weight is exactly 0, and the way back hits the side.
template <typename Kernel>
void test_border(const VMP::Compact_tetrahedral_mesh_3<Kernel>& mesh, const VMP::Floor_map_2<Kernel>& map,
                 int points) {
  std::mt19937 random(11);
  std::vector<char> on_wall(mesh.number_of_vertices(), 0);
  for (VMP::Facet_index f : mesh.boundary_facets())
    if (mesh.label(f) >= VMP::FIRST_WALL)
      for (VMP::Vertex_index v : mesh.vertices(f)) on_wall[v] = 1;
  for (std::size_t r = 0; r < map.domain().number_of_rims(); ++r)
    for (int k = 0; k < points; ++k) {
      const auto& box = map.domain().rim(r);
      const auto corners = box.corners();
      const auto &c = corners[k % 4], &d = corners[(k + 1) % 4];
      const double share = k < 4 ? 0 : std::uniform_real_distribution<double>(0, 1)(random);
      const typename Kernel::Point_2 p(c[0] + share * (d[0] - c[0]), c[1] + share * (d[1] - c[1]));
      if (box.bounded_side(p) != CGAL::ON_BOUNDARY) continue; // rounded off the side at its end
      VMP::Base_point_3<Kernel> q;
      const VMP::Status status = map.preimage(p, q);
      assert(status.ok());
      const auto v = mesh.vertices(q.facet);
      int zeros = 0;
      for (int i = 0; i < 3; ++i) {
        zeros += q.barycentric[i] == 0;
        assert(q.barycentric[i] == 0 || on_wall[v[i]]);
      }
      assert(zeros >= 1);
      const typename Kernel::Point_2 back = map.image(q);
      assert(back[1 - k % 2] == p[1 - k % 2] &&
             distance<Kernel>(back, p) <= 1e-14 * map.domain().outer().width());
    }
}

template <typename Kernel>
VMP::Floor_map_2<Kernel> test_map(const Soup<Kernel>& soup, int holes, int points, double tolerance) {
  const auto mesh = make_mesh<Kernel>(soup);
  VMP::Floor_map_2<Kernel> map;
  const VMP::Status status = map.build(mesh);
  if (!status.ok()) std::cerr << status.message() << std::endl;
  assert(status.ok() && map.domain().number_of_holes() == std::size_t(holes));
  test_is_one_to_one(map);
  test_rims(mesh, map);
  test_corners(map);
  test_round_trips(map, points, tolerance);
  test_border(mesh, map, points);
  return map;
}

// The floor of a block is a rectangle with square holes already: the map is close to the identity.
void test_block_is_kept(int holes) {
  const auto map =
      test_map<Inexact>(Block_with_holes<Inexact::Point_3>(holes, 4, 2).soup(), holes, 1000, 1e-14);
  const VMP::Prism_3<Inexact>& domain = map.domain();
  VMP::Base_point_3<Inexact> q;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Inexact::Point_2& p :
       {Inexact::Point_2(nan, 1), Inexact::Point_2(1, nan), Inexact::Point_2(-1, 1)})
    assert(map.preimage(p, q).code() == VMP::ERROR_OUTSIDE);
  assert(std::abs(domain.outer().width() * domain.outer().height() - 3 * (2 * holes + 1)) <
         0.05 * (2 * holes + 1));
  assert(std::abs(domain.height() - 1) < 1e-12);
  for (std::size_t k = 0; k < domain.number_of_holes(); ++k)
    assert(std::abs(domain.hole(k).area() - 1) < 0.1);
}

// Lines of holes that almost coincide are moved to one, but never the two of a thin hole.
void test_alignment() {
  const std::vector<VMP::Rectangle_2> rims = {
      {0, 0, 10, 10}, {1, 2, 2, 7}, {3, 2.2, 4, 7.3}, {5, 5, 6, 5.1}, {7, 4, 8, 5.2}};
  const std::vector<VMP::Rectangle_2> aligned = VMP::internal::align(rims);
  assert(aligned[0] == rims[0] && aligned[1].ymin == aligned[2].ymin && aligned[1].ymax == aligned[2].ymax);
  assert(std::abs(aligned[1].ymin - 2.1) < 1e-12 && std::abs(aligned[1].ymax - 7.15) < 1e-12);
  assert(aligned[3].ymin == 5 && aligned[3].ymax == aligned[4].ymax && aligned[4].ymin == 4);
  assert(VMP::internal::align(aligned) == aligned);
}

VMP::Error_code code_of(const Soup<Inexact>& soup) {
  VMP::Floor_map_2<Inexact> map;
  const VMP::Error_code code = map.build(make_mesh<Inexact>(soup)).code();
  assert(code == VMP::OK || map.number_of_vertices() == 0);
  return code;
}

Soup<Inexact> all_labelled(Soup<Inexact> soup, int from, int to) {
  for (VMP::Labelled_facet& f : soup.facets)
    if (f.label == from) f.label = to;
  return soup;
}

void test_refusals() {
  const Soup<Inexact> good = Block_with_holes<Inexact::Point_3>(0, 2, 1).soup();
  assert(code_of(good) == VMP::OK);
  assert(code_of(all_labelled(good, 1, 3)) == VMP::ERROR_NUMBER_OF_PATCHES);
  assert(code_of(all_labelled(good, 2, 1)) == VMP::ERROR_PATCH_NOT_CONNECTED);
  assert(code_of(all_labelled(all_labelled(good, 2, 1), 3, 1)) == VMP::ERROR_PATCH_TOPOLOGY);
  Soup<Inexact> pinched = good;
  for (VMP::Labelled_facet& facet : pinched.facets) { // a square and a rectangle that touch at a corner
    const auto& p = pinched.points;
    const auto& v = facet.vertices;
    const bool is_left = p[v[0]].x() + p[v[1]].x() + p[v[2]].x() < 1.5;
    const bool is_low = p[v[0]].y() + p[v[1]].y() + p[v[2]].y() < 1.5;
    if (facet.label == 1 && is_left != is_low) facet.label = 3;
  }
  assert(code_of(pinched) == VMP::ERROR_PATCH_NOT_A_SURFACE);
  Soup<Inexact> book; // two tetrahedra at one edge
  for (double z : {0., 1., 2., 3., 4., 5.}) book.points.push_back({z, z * z, z * z * z});
  book.cells = {{0, 1, 2, 3}, {0, 1, 4, 5}};
  for (const auto& c : book.cells)
    for (std::size_t i = 0; i < 4; ++i) book.facets.push_back({{c[i], c[(i + 1) % 4], c[(i + 2) % 4]}, 1});
  assert(code_of(book) == VMP::ERROR_NON_MANIFOLD);
  Soup<Inexact> point = good;
  for (auto& p : point.points) p = Inexact::Point_3(0, 0, 0);
  const VMP::Error_code code = code_of(point);
  assert(code == VMP::ERROR_FLOOR_MAP || code == VMP::ERROR_CANNOT_SOLVE);
}

// A layer of prisms inside of a finger, closed at its tip, with its outside as floor.
VMP::Compact_tetrahedral_mesh_3<Inexact> finger(std::size_t rings, std::size_t around) {
  Soup<Inexact> soup;
  const std::size_t layer = 1 + rings * around;
  for (int top = 0; top < 2; ++top) {
    soup.points.emplace_back(0, 0, 0.5 * top);
    for (std::size_t i = 0; i < rings; ++i)
      for (std::size_t j = 0; j < around; ++j) {
        const double angle = 2 * CGAL_PI * double(j) / double(around), radius = 1 - 0.4 * top;
        soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), double(i) + 0.5 * top);
      }
  }
  const auto add_prism = [&](std::array<std::size_t, 3> v) {
    std::sort(v.begin(), v.end()); // so that neighbours share diagonals
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<std::size_t, 4> cell;
      for (std::size_t i = 0; i < 4; ++i) cell[i] = i <= k ? v[i] : v[i - 1] + layer;
      const auto& p = soup.points;
      if (CGAL::orientation(p[cell[0]], p[cell[1]], p[cell[2]], p[cell[3]]) != CGAL::POSITIVE)
        std::swap(cell[0], cell[1]);
      soup.cells.push_back(cell);
    }
  };
  const auto vertex = [&](std::size_t i, std::size_t j) { return 1 + i * around + j % around; };
  for (std::size_t j = 0; j < around; ++j) {
    add_prism({0, vertex(0, j), vertex(0, j + 1)});
    for (std::size_t i = 0; i + 1 < rings; ++i) {
      add_prism({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j)});
      add_prism({vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)});
    }
  }
  VMP::Compact_tetrahedral_mesh_3<Inexact> mesh = make_mesh<Inexact>(soup);
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    const auto outside = std::count_if(v.begin(), v.end(), [&](VMP::Vertex_index u) { return u < layer; });
    mesh.set_label(f, outside == 3 ? VMP::FLOOR : outside == 0 ? VMP::CEILING : int(VMP::FIRST_WALL));
  }
  return mesh;
}

// Each ring of a finger is embedded smaller by half, say; after fifty no double can tell its points apart.
void test_finger() {
  VMP::Floor_map_2<Inexact> map;
  const VMP::Status status = map.build(finger(60, 8));
  std::cout << "finger: " << status.message() << std::endl;
  assert(status.ok());
  test_is_one_to_one(map);
}

int main() {
  for (int holes = 0; holes <= 3; ++holes) {
    test_block_is_kept(holes);
    for (unsigned seed = 1; seed <= 3; ++seed)
      for (int m : {1, 4}) {
        const Block_with_holes<Inexact::Point_3> block(holes, m, 1);
        test_map<Inexact>(jittered<Inexact>(block.soup(), 1. / m, 0.2, seed), holes, 1000, 1e-14);
      }
  }
  test_map<Exact>(jittered<Exact>(Block_with_holes<Exact::Point_3>(1, 1, 1).soup(), 1, 0.2, 5), 1, 50, 0);
  test_alignment();
  test_finger();
  test_refusals();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
