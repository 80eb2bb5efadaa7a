#undef NDEBUG
#include "test_util.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/optimize_hexahedra.h>

#include <CGAL/tags.h>

#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <set>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;

template <typename K>
using Object = VMP::Compact_tetrahedral_mesh_3<K>;
template <typename K>
using Hexahedra = VMP::Hexahedron_soup_3<typename K::Point_3>;

constexpr double height = 1.5;

// A cut solid and its hexahedra, before both are bent in the same way.
template <typename K>
struct Block {
  VMP::Tetrahedron_soup_3<typename K::Point_3> tetrahedra;
  Hexahedra<K> hexahedra;

  Block(int holes, double edge)
      : tetrahedra(Block_with_holes<typename K::Point_3>(holes, 2, 3, height).soup()) {
    std::vector<VMP::Rectangle_2> rectangles;
    for (double k = 0; k < holes; ++k) rectangles.push_back({2 * k + 1, 1, 2 * k + 2, 2});
    const VMP::Prism_3<K> prism({0, 0, 2. * holes + 1, 3}, rectangles, height);
    const auto column = [](const typename K::Point_2& p, const std::vector<double>& levels, auto& points) {
      for (double level : levels) points.emplace_back(p.x(), p.y(), height * level);
      return VMP::Status();
    };
    const VMP::Status status = VMP::hexahedral_mesh(prism, VMP::prism_grid(prism, edge), column, hexahedra);
    assert(status.ok());
  }

  Object<K> object() const {
    Object<K> mesh;
    const VMP::Status status = mesh.assign(tetrahedra);
    assert(status.ok());
    return mesh;
  }
};

// Moves nodes by up to `amplitude` along each axis, but not off planes with integer x or y, nor off the bases.
template <typename K>
void jitter(Hexahedra<K>& hexahedra, double amplitude) {
  std::mt19937 random(7);
  const auto moved = [&](double c, bool is_fixed) {
    const double offset = amplitude * (2. * random() / random.max() - 1);
    return is_fixed ? c : c + offset;
  };
  const auto is_integer = [](double c) { return c == std::floor(c); };
  for (auto& point : hexahedra.points) {
    const double x = CGAL::to_double(point.x()), y = CGAL::to_double(point.y()),
                 z = CGAL::to_double(point.z());
    const double mx = moved(x, is_integer(x)), my = moved(y, is_integer(y)),
                 mz = moved(z, z == 0 || z == height);
    point = typename K::Point_3(mx, my, mz);
  }
}

// Each node is near a triangle of each label that its quadrilaterals have.
template <typename K>
void check_carriers(const Object<K>& object, const Hexahedra<K>& hexahedra) {
  const auto point = [](const auto& p) {
    return Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  };
  std::set<std::pair<std::size_t, int>> labels;
  for (const VMP::Labelled_quadrilateral& q : hexahedra.facets)
    for (std::size_t v : q.vertices) labels.emplace(v, q.label);
  for (const auto& [v, label] : labels) {
    double nearest = std::numeric_limits<double>::infinity();
    for (VMP::Facet_index f : object.boundary_facets()) {
      if (object.label(f) != label) continue;
      const auto t = object.vertices(f);
      const Kernel::Triangle_3 triangle(point(object.point(t[0])), point(object.point(t[1])),
                                        point(object.point(t[2])));
      nearest =
          std::min(nearest, CGAL::to_double(CGAL::squared_distance(point(hexahedra.points[v]), triangle)));
    }
    assert(nearest < 1e-24);
  }
}

// The greatest distance between both boundaries, in mean edges.
template <typename K>
double distance_by_edge(const Object<K>& object, const Hexahedra<K>& hexahedra) {
  const VMP::Hexahedral_fit fit = VMP::measure_hexahedral_fit(object, hexahedra);
  return std::max(fit.distance_to_solid, fit.distance_from_solid) / fit.edge;
}

// Random moves tangle the mesh of a block; they are undone, and creases are found again.
template <typename K>
void test_untangling(int holes, double edge, double amplitude) {
  Block<K> block(holes, edge);
  jitter<K>(block.hexahedra, amplitude);
  const Object<K> object = block.object();
  assert(VMP::verify_hexahedra(block.hexahedra).inverted > 10);
  Hexahedra<K> again = block.hexahedra;
  assert(VMP::optimize_hexahedra(object, block.hexahedra).ok());
  const VMP::Hexahedra_report report = VMP::verify_hexahedra(block.hexahedra);
  assert(report.is_valid() && report.genus == holes);
  assert(report.minimum_scaled_jacobian > 0.5 && report.mean_scaled_jacobian > 0.9);
  check_carriers<K>(object, block.hexahedra);
  assert(distance_by_edge<K>(object, block.hexahedra) <= VMP::Hexahedra_optimization().greatest_distance);
  assert(VMP::optimize_hexahedra<CGAL::Parallel_if_available_tag>(object, again).ok() &&
         again.points == block.hexahedra.points);
}

double distance_to_boundary(const Object<Kernel>& object, const Point_3& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (VMP::Facet_index f : object.boundary_facets()) {
    const auto t = object.vertices(f);
    const Kernel::Triangle_3 triangle(object.point(t[0]), object.point(t[1]), object.point(t[2]));
    nearest = std::min(nearest, CGAL::squared_distance(p, triangle));
  }
  return std::sqrt(nearest);
}

// A square made round: its four vertical edges vanish in a smooth wall, where corners are nearly flat. A higher target
// gives a better worst corner; that nodes may leave the surface, better ones, near to it.
void test_smooth_wall() {
  const auto round = [](const Point_3& p) {
    const double x = p.x() / 1.5 - 1, y = p.y() / 1.5 - 1;
    const double r = std::max(std::abs(x), std::abs(y)), norm = std::hypot(x, y);
    const double s = norm > 0 ? 1 - r + r * r / norm : 1;
    return Point_3(s * x, s * y, p.z());
  };
  Block<Kernel> block(0, 0.5);
  block.tetrahedra = transformed(block.tetrahedra, round);
  const Object<Kernel> object = block.object();
  for (Point_3& p : block.hexahedra.points) p = round(p);
  const double start = VMP::verify_hexahedra(block.hexahedra).minimum_scaled_jacobian;
  double least = start;
  for (double target : {0., 1.}) {
    Hexahedra<Kernel> hexahedra = block.hexahedra;
    assert(VMP::optimize_hexahedra(object, hexahedra, {100, target, 0}).ok());
    check_carriers<Kernel>(object, hexahedra);
    const VMP::Hexahedra_report report = VMP::verify_hexahedra(hexahedra);
    assert(report.is_valid() && report.minimum_scaled_jacobian > least);
    least = report.minimum_scaled_jacobian;
  }
  assert(least > 0.35 && least > start + 0.1);
  assert(VMP::optimize_hexahedra(object, block.hexahedra, {100, 1.}).ok());
  const VMP::Hexahedra_report report = VMP::verify_hexahedra(block.hexahedra);
  assert(report.is_valid() && report.minimum_scaled_jacobian > least + 0.05);
  double farthest = 0;
  for (const VMP::Labelled_quadrilateral& q : block.hexahedra.facets)
    for (std::size_t v : q.vertices) farthest = std::max(farthest, distance_to_boundary(object, block.hexahedra.points[v]));
  assert(farthest > 1e-3 && farthest < 0.35 * 0.5);
  assert(distance_by_edge<Kernel>(object, block.hexahedra) < 0.5);
}

// Nodes of two creases inside the wall have slid along it, far enough to cut these off. The creases are covered again, and
// remain so while angles are mended, whether nodes may leave the surface or not.
void test_cut_creases() {
  Block<Kernel> block(0, 0.5);
  for (Point_3& p : block.hexahedra.points)
    if (p.x() == 0 && (p.y() == 0 || p.y() == 3)) p = Point_3(0.4, p.y(), p.z());
  const Object<Kernel> object = block.object();
  for (double distance : {0.5, 0.25})
    for (double tolerance : {0., 0.35}) {
      assert(distance_by_edge<Kernel>(object, block.hexahedra) > distance);
      Hexahedra<Kernel> hexahedra = block.hexahedra;
      assert(VMP::optimize_hexahedra(object, hexahedra, {100, 0.9, tolerance, distance}).ok());
      const VMP::Hexahedra_report report = VMP::verify_hexahedra(hexahedra);
      assert(report.is_valid() && report.minimum_scaled_jacobian > 0.8);
      assert(distance_by_edge<Kernel>(object, hexahedra) < distance);
    }
}

// The points that are to be covered are the vertices of the surface and the barycentres of its triangles, each once.
void test_surface_points() {
  const Object<Kernel> object = Block<Kernel>(0, 0.5).object();
  const std::vector<Eigen::Vector3d> points = VMP::internal::surface_points(object);
  std::set<VMP::Vertex_index> vertices;
  for (VMP::Facet_index f : object.boundary_facets())
    for (VMP::Vertex_index v : object.vertices(f)) vertices.insert(v);
  assert(points.size() == vertices.size() + object.number_of_boundary_facets());
  for (const Eigen::Vector3d& p : points) assert(distance_to_boundary(object, Point_3(p.x(), p.y(), p.z())) < 1e-12);
}

// Boxes cannot be better, and are left to the bit; so is everything if there are no sweeps.
void test_nothing_to_do() {
  Block<Kernel> block(1, 0.5);
  Hexahedra<Kernel> hexahedra = block.hexahedra;
  assert(VMP::optimize_hexahedra(block.object(), hexahedra).ok());
  assert(hexahedra.points == block.hexahedra.points);
  jitter<Kernel>(block.hexahedra, 0.4);
  hexahedra = block.hexahedra;
  assert(VMP::optimize_hexahedra(block.object(), hexahedra, {0, 0.3}).ok());
  assert(hexahedra.points == block.hexahedra.points);
}

// The derivatives of the energy are those of its values.
void test_derivatives() {
  const auto close = [](double a, double b) { return std::abs(a - b) < 1e-6 * (1 + std::abs(b)); };
  constexpr double h = 1e-5;
  for (int power : {1, 3})
    for (double q : {0.3, 1., 2.})
      for (double d : {-0.3, 0., 0.5, 1.}) {
        const VMP::internal::Corner_energy energy{power, 0.6, 0.4};
        const auto e = energy.derivatives(q, d), q0 = energy.derivatives(q - h, d),
                   q1 = energy.derivatives(q + h, d), d0 = energy.derivatives(q, d - h),
                   d1 = energy.derivatives(q, d + h);
        assert(close(e.f, energy(q, d)));
        assert(close(e.q, (q1.f - q0.f) / (2 * h)) && close(e.d, (d1.f - d0.f) / (2 * h)));
        assert(close(e.qq, (q1.q - q0.q) / (2 * h)) && close(e.dd, (d1.d - d0.d) / (2 * h)));
        assert(close(e.qd, (d1.q - d0.q) / (2 * h)) && close(e.qd, (q1.d - q0.d) / (2 * h)));
      }
}

// What a star's energy is after a step, it is at once where the node is there.
void test_star_energy() {
  const std::vector<Eigen::Vector3d> nodes{{0, 0, 0}, {1, 0.1, 0}, {1.2, 1, 0},     {0, 0.9, 0.2},
                                           {0, 0, 1}, {1, 0, 1.1}, {1.1, 0.8, 1.3}, {0.1, 1, 1}};
  const std::array<std::size_t, 8> hexahedron{0, 1, 2, 3, 4, 5, 6, 7};
  const Eigen::Vector3d lengths(1, 0.8, 1.2), step(0.1, -0.2, 0.05);
  const VMP::internal::Corner_energy corner{2, 0.6, 0.4};
  const auto energy = [&](const std::vector<Eigen::Vector3d>& at, int vertex) {
    VMP::internal::Star_energy star(corner, 1);
    star.add(at, hexahedron, vertex, lengths, false);
    return star;
  };
  for (int v = 0; v < 8; ++v) {
    const VMP::internal::Star_energy star = energy(nodes, v);
    const auto derivatives = star.derivatives();
    std::vector<Eigen::Vector3d> moved = nodes;
    moved[v] += step;
    assert(std::abs(star(step) - energy(moved, v)(Eigen::Vector3d::Zero())) < 1e-12 * star(step));
    assert(std::abs(star(Eigen::Vector3d::Zero()) - derivatives.value) < 1e-12 * derivatives.value);
    const double h = 1e-4, slope = (star(h * step) - star(-h * step)) / (2 * h);
    const double bend = (star(h * step) - 2 * derivatives.value + star(-h * step)) / (h * h);
    assert(std::abs(slope - derivatives.gradient.dot(step)) < 1e-5 * (1 + std::abs(slope)));
    assert(std::abs(bend - step.dot(derivatives.hessian * step)) < 1e-3 * (1 + std::abs(bend)));
  }
}

// Nodes that move at the same time share no hexahedron, and each node is in one class.
void test_classes() {
  const Block<Kernel> block(1, 0.5);
  const auto& h = block.hexahedra.hexahedra;
  const VMP::internal::Incidence_lists<std::size_t, std::size_t> stars(block.hexahedra.points.size(), h.size(),
                                                                       [&](std::size_t k) { return h[k]; });
  const auto classes = VMP::internal::color_nodes(stars, h);
  std::vector<std::size_t> class_of(stars.size(), classes.size());
  for (std::size_t k = 0; k < classes.size(); ++k)
    for (std::size_t v : classes[k]) {
      assert(class_of[v] == classes.size());
      class_of[v] = k;
    }
  for (const auto& nodes : h) {
    std::set<std::size_t> found;
    for (std::size_t v : nodes) found.insert(class_of[v]);
    assert(found.size() == 8 && *found.rbegin() < classes.size());
  }
}

// Good corners do not rule out that a hexahedron with edges of most different lengths is inverted inside.
void test_inverted_inside() {
  const std::vector<Eigen::Vector3d> nodes{{0, 0, 0},    {-39, -10, 37}, {-11, -39, 19}, {-15, 0, -21},
                                           {-4, -4, -5}, {-11, 35, 44},  {1, -35, 27},   {1, -2, -18}};
  const std::array<std::size_t, 8> hexahedron{0, 1, 2, 3, 4, 5, 6, 7};
  const double quality = VMP::internal::corner_scaled_jacobian(nodes, hexahedron);
  assert(quality > 0.35 && VMP::internal::is_inverted(nodes, hexahedron, quality));
}

VMP::Error_code code_of(const Object<Kernel>& object, Hexahedra<Kernel> hexahedra,
                        const VMP::Hexahedra_optimization& options = {}) {
  const std::vector<Point_3> points = hexahedra.points;
  const VMP::Status status = VMP::optimize_hexahedra(object, hexahedra, options);
  assert(status.ok() || hexahedra.points == points);
  return status.code();
}

void test_refused_hexahedra() {
  const Block<Kernel> block(0, 1);
  const Object<Kernel> object = block.object();
  assert(code_of(object, {}) == VMP::ERROR_EMPTY_MESH);
  Hexahedra<Kernel> bad = block.hexahedra;
  bad.hexahedra[1][3] = 999;
  assert(code_of(object, bad) == VMP::ERROR_INDEX_OUT_OF_RANGE);
  bad = block.hexahedra;
  bad.facets.push_back({{0, 1, 2, 999}, VMP::FLOOR});
  assert(code_of(object, bad) == VMP::ERROR_LABEL_NOT_ON_BOUNDARY);
  bad = block.hexahedra;
  bad.facets.push_back(bad.facets.front());
  assert(code_of(object, bad) == VMP::ERROR_LABEL_NOT_ON_BOUNDARY);
  bad = block.hexahedra;
  bad.facets.pop_back();
  assert(code_of(object, bad) == VMP::ERROR_UNLABELLED_FACET);
  bad = block.hexahedra;
  bad.points[0] = Point_3(0, std::numeric_limits<double>::infinity(), 0);
  assert(code_of(object, bad) == VMP::ERROR_COORDINATE_NOT_FINITE);
  bad = block.hexahedra;
  for (VMP::Labelled_quadrilateral& q : bad.facets)
    if (q.label == VMP::CEILING) q.label = 77; // a patch that the object does not have
  assert(code_of(object, bad) == VMP::ERROR_WRONG_PARAMETER);
  bad = block.hexahedra;
  for (VMP::Labelled_quadrilateral& q : bad.facets)
    if (q.label == VMP::FIRST_WALL) q.label = q.vertices[0] % 2 == 0 ? VMP::FLOOR : VMP::CEILING;
  assert(code_of(object, bad) == VMP::ERROR_WRONG_PARAMETER); // they do not meet
}

void test_refused_parameters() {
  const Block<Kernel> block(0, 1);
  const Object<Kernel> object = block.object();
  assert(code_of(object, block.hexahedra, {-1, 0.3}) == VMP::ERROR_WRONG_PARAMETER);
  assert(code_of(object, block.hexahedra, {9, 1.1}) == VMP::ERROR_WRONG_PARAMETER);
  assert(code_of(Object<Kernel>(), block.hexahedra) == VMP::ERROR_EMPTY_MESH);
  VMP::Tetrahedron_soup_3<Point_3> touching;
  touching.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}};
  touching.cells = {{0, 1, 2, 3}, {0, 1, 4, 5}};
  Object<Kernel> not_manifold;
  assert(not_manifold.assign(touching).ok());
  assert(code_of(not_manifold, block.hexahedra) == VMP::ERROR_NON_MANIFOLD);
  Hexahedra<Kernel> three = block.hexahedra; // labels around a vertex
  three.facets.front().label = VMP::FIRST_WALL;
  three.facets[1].label = 9;
  assert(code_of(object, three) == VMP::ERROR_WRONG_PARAMETER);
}

int main() {
  test_derivatives();
  test_star_energy();
  test_classes();
  test_inverted_inside();
  test_untangling<Kernel>(0, 0.375, 0.28);
  test_untangling<Kernel>(2, 0.5, 0.45);
  test_untangling<CGAL::Exact_predicates_exact_constructions_kernel>(1, 0.5, 0.45);
  test_smooth_wall();
  test_cut_creases();
  test_surface_points();
  test_nothing_to_do();
  test_refused_hexahedra();
  test_refused_parameters();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
