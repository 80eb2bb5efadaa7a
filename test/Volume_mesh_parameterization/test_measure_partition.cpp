#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/measure_partition.h>

#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Direction = VMP::Sweep_direction_3;

const double pi = std::acos(-1.);
const Direction up(0, 0, 1), mean(0, 0, 0);

template <typename K>
VMP::Compact_tetrahedral_mesh_3<K> make_mesh(const VMP::Tetrahedron_soup_3<typename K::Point_3>& soup) {
  VMP::Compact_tetrahedral_mesh_3<K> mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  return mesh;
}

Mesh make_block(int holes, int m, int layers, double height = 1) {
  return make_mesh<Kernel>(Block_with_holes<Point>(holes, m, layers, height).soup());
}

// label_of(barycentre, old label) is the new label of a facet.
template <typename LabelOf>
Mesh relabelled(Mesh mesh, const LabelOf& label_of) {
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    mesh.set_label(
        f, label_of(CGAL::centroid(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])), mesh.label(f)));
  }
  return mesh;
}

template <typename Mesh>
VMP::Partition_quality quality_of(const Mesh& mesh, const Direction& direction = up) {
  VMP::Partition_quality quality;
  VMP::Status status = VMP::measure_partition(mesh, direction, quality);
  if (status.ok()) status = VMP::try_partition(mesh, quality);
  assert(status.ok());
  return quality;
}

bool near(double a, double b, double tolerance = 1e-12) { return std::abs(a - b) < tolerance; }

// [0, 3] x [0, 3] x [0, height] with a hole [1, 2] x [1, 2].
template <typename Mesh>
void test_block(const Mesh& mesh, double height) {
  const VMP::Partition_quality q = quality_of(mesh);
  const double walls = 16 * height, total = 16 + walls;
  assert(near(q.floor_share, 8 / total) && near(q.ceiling_share, 8 / total) &&
         near(q.wall_share, walls / total));
  assert(near(q.balance, 1) && near(q.smallest_wall, .25));
  assert(near(q.rim_length, 32 / std::sqrt(total)) && near(q.mean_width, height / std::sqrt(total)));
  assert(near(q.wall_gap, height / std::sqrt(total)));
  assert(near(q.alignment, 1) && near(quality_of(mesh, mean).alignment, 1));
  assert(near(q.zigzag, 1));
  assert(near(q.gradient_spread, 0, 1e-9) && near(q.length_spread, 0, 1e-9));
  assert(q.number_of_critical_points == 0);
}

void test_blocks() {
  test_block(make_block(1, 2, 2), 1);
  test_block(make_block(1, 4, 2, .5), .5);
  test_block(make_mesh<Exact_kernel>(Block_with_holes<Exact_kernel::Point_3>(1, 2, 2, 1).soup()), 1);
}

// The block has 8 units of area each of floor, ceiling, walls across x and walls across y.
void test_alignment() {
  const Mesh mesh = make_block(1, 2, 2);
  assert(near(quality_of(mesh, {5, 0, 0}).alignment, 8. / 32)); // the walls across y
  assert(near(quality_of(mesh, -up).alignment, 16. / 32));      // all walls
  assert(near(quality_of(mesh, {0, 1, 1}).alignment, (24 * std::sqrt(.5) + 8) / 32));
}

// A closed polygon is measured as a rim.
template <typename PointOf>
double zigzag(std::size_t n, const PointOf& point_of) {
  std::vector<VMP::internal::Double_kernel::Point_3> points;
  VMP::internal::Rim rim;
  for (std::size_t i = 0; i < n; ++i) {
    points.push_back(point_of(i));
    rim.push_back(VMP::Vertex_index(i));
  }
  const VMP::internal::Closed_polyline polyline(points, rim);
  return polyline.length() / polyline.smoothed_length();
}

using Double_point = VMP::internal::Double_kernel::Point_3;

Double_point on_circle(double angle, double radius) {
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

// An n-gon with four straight sides of n / 4 edges, every second vertex moved inwards by `amplitude` edges.
double zigzag_of_square(std::size_t n, double amplitude) {
  const int side = int(n / 4);
  return zigzag(n, [&](std::size_t i) {
    const double x = double(i % side), y = i % 2 ? amplitude : 0;
    const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                 turns[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const auto& c = corners[i / side];
    const auto& t = turns[i / side];
    return Double_point(side * c[0] + x * t[0] - y * t[1], side * c[1] + x * t[1] + y * t[0], 0);
  });
}

void test_zigzag_of_polygons() {
  for (std::size_t n : {16, 64, 200, 1000}) {
    const double circle = zigzag(n, [&](std::size_t i) { return on_circle(2 * pi * i / n, 3); });
    assert(circle >= 1 && circle < 1.014);
  }
  for (std::size_t n : {4, 8, 48, 400}) assert(zigzag_of_square(n, 0) < 1.001);
  for (double amplitude : {.2, .5, 1.}) // the outline of a mesh of equilateral triangles has .87
    assert(near(zigzag_of_square(400, amplitude), std::hypot(1, amplitude), .02));
  // a circle with spikes, and one vertex many times
  const double spikes =
      zigzag(400, [&](std::size_t i) { return on_circle(2 * pi * i / 400, i % 2 ? 1 : 1.02); });
  assert(spikes > 1.4);
  assert(
      near(zigzag(40, [](std::size_t i) { return Double_point(i / 10 == 1 || i / 10 == 2, i / 20, 0); }), 1));
}

// The same on a surface: the front of a block, cut by a diagonal staircase into floor and wall.
void test_staircase() {
  const int m = 10;
  const Mesh straight = make_block(0, m, 3 * m, 3);
  const auto front = [](const Point& p) { return p.x() > 1 - 1e-9; };
  const auto top = [](const Point& p) { return p.z() > 3 - 1e-9; };
  const Mesh staircase = relabelled(straight, [&](const Point& p, int) {
    if (top(p)) return int(VMP::CEILING);
    if (!front(p)) return p.z() < 1e-9 ? int(VMP::FLOOR) : int(VMP::FIRST_WALL);
    const double y = std::floor(p.y() * m), z = std::floor(p.z() * m);
    return z < std::min(y, 3 * m - 1 - y) / 1.5 - 1e-9 ? int(VMP::FLOOR) : int(VMP::FIRST_WALL);
  });
  const VMP::Partition_quality q = quality_of(staircase), s = quality_of(straight);
  assert(near(s.zigzag, 1));
  // two rims of length 8, of which 3 become 5 (3 along y, 2 up and down) where a smooth one has sqrt(9 + 4)
  const double smooth = 13 + std::sqrt(13.);
  std::cout << "staircase: zigzag " << q.zigzag << ", expected " << 18 / smooth << '\n';
  assert(near(q.zigzag, 18 / smooth, .02));
  assert(VMP::cost(q) > VMP::cost(s));
}

// Walls come down from the ceiling more and more: the ceiling grows around the edges, the floor stays.
void test_balance() {
  const Mesh mesh = make_block(0, 4, 16, 4);
  double last = VMP::cost(quality_of(mesh));
  for (double z : {3., 2., 1.}) {
    const Mesh unbalanced = relabelled(mesh, [&](const Point& p, int label) {
      return p.z() > z && label != VMP::FLOOR ? int(VMP::CEILING) : label;
    });
    const VMP::Partition_quality q = quality_of(unbalanced);
    assert(near(q.balance, 3 / (3 + 8 * (4 - z))) && near(q.wall_gap, z / std::sqrt(38.)));
    assert(q.gradient_spread > .1 && q.length_spread < 10);
    assert(VMP::cost(q) > last + .5);
    last = VMP::cost(q);
  }
}

// Each number makes a partition worse on its own.
void test_cost() {
  const VMP::Partition_quality good = quality_of(make_block(1, 2, 2));
  const auto is_worse = [&](const auto& change) {
    VMP::Partition_quality worse = good;
    change(worse);
    return VMP::cost(worse) > VMP::cost(good);
  };
  assert(is_worse([](auto& q) { q.balance = .5; }));
  assert(is_worse([](auto& q) { q.wall_gap /= 2; }));
  assert(is_worse([](auto& q) { q.alignment = .5; }));
  assert(is_worse([](auto& q) { q.zigzag = 1.2; }));
  assert(is_worse([](auto& q) { q.gradient_spread = .5; }));
  assert(is_worse([](auto& q) { q.length_spread = .5; }));
  assert(is_worse([](auto& q) { q.number_of_critical_points = 2; }));
}

// Numbers do not change when the solid is moved and scaled, but by rounding.
void test_invariance() {
  const auto soup = jitter_interior(Block_with_holes<Point>(1, 3, 3).soup(), .05, 1);
  const auto moved = transformed(soup, [](const Point& p) {
    return Point(1e3 * (.6 * p.x() - .8 * p.z()) + 7, 1e3 * p.y(), 1e3 * (.8 * p.x() + .6 * p.z()));
  });
  const VMP::Partition_quality a = quality_of(make_mesh<Kernel>(soup)),
                               b = quality_of(make_mesh<Kernel>(moved), {-4, 0, 3});
  assert(near(VMP::cost(a), VMP::cost(b), 1e-6) && near(a.gradient_spread, b.gradient_spread, 1e-6));
  assert(near(a.rim_length, b.rim_length, 1e-9) && near(a.alignment, b.alignment, 1e-9));
  assert(a.gradient_spread > 0 && a.length_spread > 0 && a.length_spread < .1);
}

// A block that is narrow in the middle, and a bent one, whose outer curves are longer.
void test_trial() {
  const auto narrow = transformed(Block_with_holes<Point>(0, 6, 18, 3).soup(), [](const Point& p) {
    const double r = .4 + .6 * std::pow(p.z() / 1.5 - 1, 2);
    return Point(r * (p.x() - .5), r * (p.y() - 1.5), p.z());
  });
  const VMP::Partition_quality q = quality_of(make_mesh<Kernel>(narrow));
  assert(q.gradient_spread > .3 && q.gradient_spread < 1);
  const auto bent = transformed(Block_with_holes<Point>(0, 8, 24).soup(), [](const Point& p) {
    return Point((1 + p.x()) * std::cos(p.z()), p.y(), (1 + p.x()) * std::sin(p.z()));
  });
  const VMP::Partition_quality b = quality_of(make_mesh<Kernel>(bent), {-1, 0, 1});
  // the logarithm of a radius from 1 to 2 has this standard deviation, for the area; for the volume it is a bit less
  const double mean_log = 2 * std::log(2.) - 1, square = 2 * std::pow(std::log(2.), 2) - 2 * mean_log;
  std::cout << "bent: spread of lengths " << b.length_spread << ", of gradients " << b.gradient_spread
            << ", expected " << std::sqrt(square - mean_log * mean_log) << '\n';
  assert(near(b.length_spread, std::sqrt(square - mean_log * mean_log), .02));
  assert(near(b.gradient_spread, b.length_spread, .03));
}

// Labels of a coarse solid: floor and ceiling touch at a vertex, along an edge, everywhere.
void test_touching_bases() {
  const Mesh mesh = make_block(0, 2, 6, 3);
  const Mesh at_vertex = relabelled(mesh, [](const Point& p, int label) {
    return label == VMP::CEILING || (p.y() < 1e-9 && p.x() > p.z() / 3) ? int(VMP::CEILING) : label;
  });
  const Mesh at_edges = relabelled(mesh, [](const Point& p, int label) {
    return label >= VMP::FIRST_WALL && p.y() < 1.5 ? int(VMP::CEILING) : label;
  });
  const Mesh everywhere =
      relabelled(mesh, [](const Point& p, int) { return p.z() < 1.5 ? int(VMP::FLOOR) : int(VMP::CEILING); });
  for (const Mesh& m : {at_vertex, at_edges, everywhere}) {
    const VMP::Partition_quality q = quality_of(m);
    assert(q.wall_gap == 0 && VMP::cost(q) == std::numeric_limits<double>::infinity());
    assert(q.gradient_spread > .3 && std::isfinite(q.gradient_spread) && std::isfinite(q.length_spread));
    assert(q.zigzag >= 1 && q.zigzag < 2);
  }
  assert(quality_of(everywhere).wall_share == 0 && quality_of(everywhere).smallest_wall == 0);
}

VMP::Error_code measured(const Mesh& mesh, const Direction& direction = up) {
  VMP::Partition_quality quality;
  return VMP::measure_partition(mesh, direction, quality).code();
}

VMP::Error_code tried(const Mesh& mesh) {
  VMP::Partition_quality quality;
  quality.gradient_spread = 7;
  const VMP::Status status = VMP::try_partition(mesh, quality);
  assert(status.ok() || quality.gradient_spread == 7);
  return status.code();
}

Soup two_blocks(double shift) {
  Soup soup = Block_with_holes<Point>(0, 1, 1).soup();
  const Soup second = soup;
  const std::size_t n = soup.points.size();
  for (const Point& p : second.points) soup.points.push_back(p + Kernel::Vector_3(shift, 0, 0));
  for (auto cell : second.cells) {
    for (std::size_t& v : cell) v += n;
    soup.cells.push_back(cell);
  }
  for (VMP::Labelled_facet f : second.facets) {
    for (std::size_t& v : f.vertices) v += n;
    f.label = VMP::FIRST_WALL;
    soup.facets.push_back(f);
  }
  return soup;
}

void test_errors() {
  const Mesh mesh = make_block(0, 1, 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  assert(measured(Mesh()) == VMP::ERROR_EMPTY_MESH && tried(Mesh()) == VMP::ERROR_NUMBER_OF_PATCHES);
  assert(measured(mesh, {0, nan, 1}) == VMP::ERROR_WRONG_PARAMETER);
  for (int base : {VMP::FLOOR, VMP::CEILING}) {
    const Mesh without = relabelled(mesh, [&](const Point&, int label) { return label == base ? 3 : label; });
    assert(measured(without) == VMP::ERROR_NUMBER_OF_PATCHES &&
           tried(without) == VMP::ERROR_NUMBER_OF_PATCHES);
  }
  const Mesh two = make_mesh<Kernel>(two_blocks(9));
  assert(measured(two) == VMP::ERROR_SEVERAL_COMPONENTS && tried(two) == VMP::ERROR_SEVERAL_COMPONENTS);
  // two tetrahedra that share an edge
  Soup pinched;
  pinched.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  pinched.cells = {{1, 0, 3, 2}, {1, 0, 5, 4}};
  assert(measured(make_mesh<Kernel>(pinched)) == VMP::ERROR_NON_MANIFOLD);
  const auto squashed = transformed(Block_with_holes<Point>(0, 1, 2).soup(),
                                    [](const Point& p) { return Point(p.x(), p.y(), 0); });
  assert(tried(make_mesh<Kernel>(squashed)) == VMP::ERROR_FLAT_TETRAHEDRON);
  // any labels do
  assert(measured(relabelled(mesh, [](const Point&, int label) { return label > 2 ? -5 : label; })) ==
         VMP::OK);
  assert(measured(relabelled(mesh, [](const Point&, int label) { return label > 2 ? 2000000000 : label; })) ==
         VMP::OK);
}

// A solver that gives up.
struct Lazy_solver : VMP::Default_solver_traits_3 {
  bool factor(const Matrix&, NT&) { return false; }
};

void test_solver() {
  const Mesh mesh = make_block(1, 2, 3);
  VMP::Partition_quality quality;
  assert(VMP::try_partition<Lazy_solver>(mesh, quality).code() == VMP::ERROR_CANNOT_SOLVE);
  assert(VMP::try_partition<VMP::Simplicial_solver_traits_3>(mesh, quality).ok());
  assert(near(quality.gradient_spread, 0, 1e-9));
}

int main() {
  test_blocks();
  test_alignment();
  test_zigzag_of_polygons();
  test_staircase();
  test_balance();
  test_cost();
  test_invariance();
  test_trial();
  test_touching_bases();
  test_errors();
  test_solver();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
