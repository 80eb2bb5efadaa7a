#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Floor_map_2.h>
#include <CGAL/Volume_mesh_parameterization/measure_floor_distortion.h>

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
VMP::Floor_map_2<Kernel> test_map(const Soup<Kernel>& soup, int holes, int points, double tolerance,
                                  const VMP::Floor_map_options& options = VMP::Floor_map_options()) {
  const auto mesh = make_mesh<Kernel>(soup);
  VMP::Floor_map_2<Kernel> map(options);
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

const Grid_box square = {0, 0, 7, 7};
const std::vector<Grid_box> array_of_holes = {{1, 1, 2, 2}, {3, 1, 4, 2}, {5, 1, 6, 2},
                                              {1, 3, 2, 4}, {3, 3, 4, 4}, {5, 3, 6, 4},
                                              {1, 5, 2, 6}, {3, 5, 4, 6}, {5, 5, 6, 6}};
const std::vector<Grid_box> pinwheel = {{1, 1, 4, 2}, {5, 1, 6, 4}, {3, 5, 6, 6}, {1, 3, 2, 6}, {3, 3, 4, 4}};

Grid_box random_box(std::mt19937& random, int size) {
  const auto below = [&](int n) { return int(random() % unsigned(n)); };
  const int x = 1 + below(size - 2), y = 1 + below(size - 2);
  return {x, y, std::min(x + 1 + below(3), size - 1), std::min(y + 1 + below(3), size - 1)};
}

// Disjoint holes at random places of a square, with edges of up to 3.
std::vector<Grid_box> random_holes(int n, int size, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Grid_box> holes;
  while (int(holes.size()) < n) {
    const Grid_box hole = random_box(random, size);
    if (std::none_of(holes.begin(), holes.end(), [&](const Grid_box& h) { return h.is_near(hole); }))
      holes.push_back(hole);
  }
  return holes;
}

// Rolls a block up so far that its floor, outside, is seen from all directions.
Soup<Inexact> rolled(const Soup<Inexact>& soup, double width) {
  const double all = 1.5 * CGAL_PI, radius = width / all;
  return transformed(soup, [&](const Inexact::Point_3& p) {
    const double angle = all * (p.x() / width - .5), r = radius * (1 - p.z() / width);
    return Inexact::Point_3(r * std::sin(angle), p.y(), -r * std::cos(angle));
  });
}

// A round plate with a ring of round bores.
Soup<Inexact> flange(int bores, int m) {
  const double size = 15;
  std::vector<Grid_box> holes;
  for (int k = 0; k < bores; ++k) {
    const double angle = 2 * CGAL_PI * k / bores, radius = size / 2 - 2.2;
    const int x = int(std::lround(size / 2 + radius * std::cos(angle) - .5)),
              y = int(std::lround(size / 2 + radius * std::sin(angle) - .5));
    holes.push_back({x, y, x + 1, y + 1});
  }
  const auto soup = Block_with_holes<Inexact::Point_3>({0, 0, int(size), int(size)}, holes, m, 1).soup();
  return transformed(soup, [&](const Inexact::Point_3& p) {
    const double x = 2 * p.x() / size - 1, y = 2 * p.y() / size - 1;
    return Inexact::Point_3(x * std::sqrt(1 - .45 * y * y), y * std::sqrt(1 - .45 * x * x), p.z() / size);
  });
}

double energy_of(const Soup<Inexact>& soup, const VMP::Floor_map_2<Inexact>& map) {
  return VMP::measure_floor_distortion(make_mesh<Inexact>(soup), map).symmetric_dirichlet_energy.mean();
}

// A ribbon along a limacon, which crosses itself as seen from above and below: there one part is above the other.
Soup<Inexact> looped_ribbon(int size) {
  using Vector = Inexact::Vector_3;
  const auto frame =
      Block_with_holes<Inexact::Point_3>({0, 0, size, size}, {{1, 1, size - 1, size - 1}}, 1, 1).soup();
  const double scale = 4 * size / 13.4, height = 3; // about as long as the frame
  const auto limacon = [&](double t) {
    const double r = scale * (1 + 2 * std::cos(t));
    return Inexact::Point_3(r * std::cos(t), r * std::sin(t), height * std::sin(t));
  };
  return transformed(frame, [&](const Inexact::Point_3& p) {
    const double x = p.x() - size / 2., y = p.y() - size / 2., t = std::atan2(y, x), small = 1e-5;
    const double across = (std::max)(std::abs(x), std::abs(y)) - (size - 1) / 2.;
    const Vector along = limacon(t + small) - limacon(t - small);
    const double length = std::hypot(along.x(), along.y());
    return limacon(t) + Vector(across * along.y() / length, -across * along.x() / length, p.z());
  });
}

// Corners from the projection would be anywhere.
void test_looped_ribbon() {
  const auto soup = looped_ribbon(15);
  const double energy = energy_of(soup, test_map<Inexact>(soup, 1, 200, 1e-12));
  std::cout << "a ribbon that crosses itself: energy " << energy << std::endl;
  assert(energy < 4.4);
}

// Plates are kept: wherever the holes lie, the map is an isometry.
void test_arrangement(int size, const std::vector<Grid_box>& holes, unsigned seed) {
  const int n = int(holes.size());
  const auto soup = Block_with_holes<Inexact::Point_3>({0, 0, size, size}, holes, 2, 1).soup();
  const double energy = energy_of(soup, test_map<Inexact>(soup, n, 200, 1e-13));
  std::cout << n << " holes in a plate: energy " << energy << std::endl;
  assert(std::abs(energy - 4) < 1e-6);
  test_map<Inexact>(jittered<Inexact>(soup, .5, .2, seed), n, 200, 1e-13);
  test_map<Inexact>(rolled(soup, size), n, 200, 1e-12);
}

void test_arrangements() {
  test_arrangement(7, array_of_holes, 1);
  test_arrangement(7, pinwheel, 2);
  for (int n = 0; n <= 9; ++n) test_arrangement(12, random_holes(n, 12, unsigned(n) + 5), unsigned(n));
  for (int bores : {5, 9}) {
    const Soup<Inexact> soup = flange(bores, 2);
    const double energy = energy_of(soup, test_map<Inexact>(soup, bores, 200, 1e-13));
    std::cout << bores << " bores: energy " << energy << std::endl;
    assert(energy < 4.3);
  }
}

// All planes are integers. Of a block of cubes they are those that it has, turned by a quarter.
void test_integers() {
  VMP::Floor_map_options options;
  options.integer_planes = true;
  for (const std::vector<Grid_box>& holes : {array_of_holes, pinwheel, std::vector<Grid_box>()}) {
    const auto soup =
        transformed(Block_with_holes<Inexact::Point_3>(square, holes, 2, 2).soup(),
                    [](const auto& p) { return Inexact::Point_3(.3 * p.x(), .3 * p.y(), .3 * p.z()); });
    const auto map = test_map<Inexact>(soup, int(holes.size()), 200, 1e-13, options);
    const VMP::Prism_3<Inexact>& domain = map.domain();
    assert(domain.outer() == VMP::Rectangle_2({0, 0, 7, 7}) && domain.height() == 1);
    for (std::size_t r = 1; r < domain.number_of_rims(); ++r) {
      const Grid_box& hole = holes[std::size_t(domain.wall_label(r) - VMP::FIRST_WALL - 1)];
      assert(domain.rim(r) ==
             VMP::Rectangle_2({7. - hole.ymax, double(hole.xmin), 7. - hole.ymin, double(hole.xmax)}));
    }
  }
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto soup =
        Block_with_holes<Inexact::Point_3>({0, 0, 12, 12}, random_holes(6, 12, seed), 2, 1).soup();
    const auto map = test_map<Inexact>(rolled(soup, 12), 6, 200, 1e-12, options);
    for (std::size_t r = 0; r < map.domain().number_of_rims(); ++r)
      for (const auto& corner : map.domain().rim(r).corners())
        assert(corner[0] == std::round(corner[0]) && corner[1] == std::round(corner[1]));
    assert(map.domain().height() == std::round(map.domain().height()));
  }
}

void test_sizes() {
  const auto soup = Block_with_holes<Inexact::Point_3>(square, pinwheel, 2, 1).soup();
  VMP::Floor_map_options options;
  options.size = {20, 10, 3};
  const auto stretched = test_map<Inexact>(soup, 5, 200, 1e-13, options);
  assert(stretched.domain().outer() == VMP::Rectangle_2({0, 0, 20, 10}) && stretched.domain().height() == 3);
  options.size = {0, 0, 5}; // natural sizes are about 7, 7 and 1
  const auto scaled = test_map<Inexact>(soup, 5, 200, 1e-13, options);
  assert(scaled.domain().height() == 5 && std::abs(scaled.domain().outer().width() - 35) < 1);
  options.size = {14, 21, 0};
  options.integer_planes = true;
  const auto integers = test_map<Inexact>(soup, 5, 200, 1e-13, options);
  assert(integers.domain().outer() == VMP::Rectangle_2({0, 0, 14, 21}) && integers.domain().height() == 2);
  for (const std::array<double, 3>& size : {std::array<double, 3>{2, 2, 1}, {7.5, 0, 0}, {-1, 0, 0}}) {
    options.size = size;
    VMP::Floor_map_2<Inexact> map(options);
    assert(map.build(make_mesh<Inexact>(soup)).code() == VMP::ERROR_WRONG_PARAMETER &&
           map.number_of_vertices() == 0);
  }
  options = VMP::Floor_map_options();
  options.size[1] = std::numeric_limits<double>::quiet_NaN();
  assert(VMP::Floor_map_2<Inexact>(options).build(make_mesh<Inexact>(soup)).code() ==
         VMP::ERROR_WRONG_PARAMETER);
}

// The same again and again.
void test_determinism() {
  const auto mesh =
      make_mesh<Inexact>(rolled(Block_with_holes<Inexact::Point_3>(square, pinwheel, 2, 1).soup(), 7));
  VMP::Floor_map_2<Inexact> a, b;
  assert(a.build(mesh).ok() && b.build(mesh).ok() && b.build(mesh).ok());
  assert(a.number_of_vertices() == b.number_of_vertices());
  for (std::size_t v = 0; v < a.number_of_vertices(); ++v) assert(a.image(v) == b.image(v));
}

// Lines of holes that almost coincide are moved to one, but never the two of a thin hole, and holes never touch.
void test_alignment() {
  const std::vector<VMP::Rectangle_2> rims = {
      {0, 0, 10, 10}, {1, 2, 2, 7}, {3, 2.2, 4, 7.3}, {5, 5, 6, 5.1}, {7, 4, 8, 5.2}};
  const std::vector<VMP::Rectangle_2> aligned = VMP::internal::aligned(rims);
  assert(aligned[0] == rims[0] && aligned[1].ymin == aligned[2].ymin && aligned[1].ymax == aligned[2].ymax);
  assert(std::abs(aligned[1].ymin - 2.1) < 1e-12 && std::abs(aligned[1].ymax - 7.15) < 1e-12);
  assert(aligned[3].ymin == 5 && aligned[3].ymax == aligned[4].ymax && aligned[4].ymin == 4);
  assert(VMP::internal::aligned(aligned) == aligned);
  const std::vector<VMP::Rectangle_2> facing = {
      {0, 0, 10, 10}, {1, 1, 4, 4}, {4.2, 3, 7, 7}, {3.9, 4.3, 4, 8}};
  const std::vector<VMP::Rectangle_2> moved = VMP::internal::aligned(facing);
  assert((VMP::Prism_3<Inexact>(moved[0], {moved[1], moved[2], moved[3]}, 1).is_valid()));
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-.45, .45);
    std::vector<VMP::Rectangle_2> holes, all(1, {0, 0, 12, 12});
    for (const Grid_box& h : random_holes(8, 12, seed))
      all.push_back(
          {h.xmin + shift(random), h.ymin + shift(random), h.xmax + shift(random), h.ymax + shift(random)});
    const auto result = VMP::internal::aligned(all);
    assert(VMP::Prism_3<Inexact>(result[0], {result.begin() + 1, result.end()}, 1).is_valid());
  }
}

bool is_separable(const std::vector<VMP::Rectangle_2>& rims) {
  return VMP::internal::separated(rims) == rims;
}

// Overlapping rectangles and those that no line across parts become separable; others are kept.
void test_separation() {
  const VMP::Rectangle_2 base = {0, 0, 7, 7};
  std::vector<VMP::Rectangle_2> array(1, base), wheel(1, base);
  for (const Grid_box& h : array_of_holes)
    array.push_back({double(h.xmin), double(h.ymin), double(h.xmax), double(h.ymax)});
  for (const Grid_box& h : pinwheel)
    wheel.push_back({double(h.xmin), double(h.ymin), double(h.xmax), double(h.ymax)});
  assert(is_separable(array) && !is_separable(wheel) && is_separable({base}));
  const std::vector<VMP::Rectangle_2> same = {base, {1, 1, 6, 6}, {1, 1, 6, 6}, {1, 1, 6, 6}, {2, 2, 3, 3}};
  for (const auto& rims : {wheel, same}) {
    const auto result = VMP::internal::separated(rims);
    assert(result != rims && is_separable(result) && result[0] == base);
    assert(VMP::Prism_3<Inexact>(base, {result.begin() + 1, result.end()}, 1).is_valid());
  }
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
  test_map<Exact>(
      Block_with_holes<Exact::Point_3>({0, 0, 5, 5}, {{1, 1, 2, 2}, {3, 1, 4, 2}, {2, 3, 3, 4}}, 1, 1).soup(),
      3, 50, 0);
  test_arrangements();
  test_looped_ribbon();
  test_integers();
  test_sizes();
  test_determinism();
  test_alignment();
  test_separation();
  test_finger();
  test_refusals();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
