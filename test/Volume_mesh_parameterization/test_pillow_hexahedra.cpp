#undef NDEBUG
#include "test_util.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/optimize_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/pillow_hexahedra.h>

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
using Hexahedra = VMP::Hexahedron_soup_3<typename K::Point_3>;

constexpr double height = 1;

template <typename K>
VMP::Prism_3<K> prism(int holes) {
  std::vector<VMP::Rectangle_2> rectangles;
  for (double k = 0; k < holes; ++k) rectangles.push_back({2 * k + 1, 1, 2 * k + 2, 2});
  return {{0, 0, 2. * holes + 1, 3}, rectangles, height};
}

template <typename K>
Hexahedra<K> grid(int holes, double edge) {
  const auto column = [](const typename K::Point_2& p, const std::vector<double>& levels, auto& points) {
    for (double level : levels) points.emplace_back(p.x(), p.y(), height * level);
    return VMP::Status();
  };
  Hexahedra<K> mesh;
  assert(VMP::hexahedral_mesh(prism<K>(holes), VMP::prism_grid(prism<K>(holes), edge), column, mesh).ok());
  return mesh;
}

// By the divergence theorem over hexahedra whose facets are cut into triangles around their centres.
template <typename K>
double volume(const Hexahedra<K>& mesh) {
  const auto point = [&](std::size_t v) { return VMP::internal::approximate(mesh.points[v]); };
  double sum = 0;
  for (const auto& h : mesh.hexahedra)
    for (const auto& f : VMP::internal::Reference_hexahedron::facets) {
      const auto centre = CGAL::midpoint(CGAL::midpoint(point(h[f[0]]), point(h[f[2]])),
                                         CGAL::midpoint(point(h[f[1]]), point(h[f[3]])));
      for (int i = 0; i < 4; ++i)
        sum += CGAL::volume(CGAL::Simple_cartesian<double>::Point_3(0, 0, 0), centre, point(h[f[i]]),
                            point(h[f[(i + 1) % 4]]));
    }
  return sum;
}

// V - E + F - C.
template <typename K>
long euler_characteristic(const Hexahedra<K>& mesh) {
  std::set<std::size_t> vertices;
  std::set<std::set<std::size_t>> edges, facets;
  for (const auto& h : mesh.hexahedra) {
    vertices.insert(h.begin(), h.end());
    for (const auto& axis : VMP::internal::Reference_hexahedron::axis_edges)
      for (const auto& e : axis) edges.insert({h[e[0]], h[e[1]]});
    for (const auto& f : VMP::internal::Reference_hexahedron::facets)
      facets.insert({h[f[0]], h[f[1]], h[f[2]], h[f[3]]});
  }
  return long(vertices.size()) - long(edges.size()) + long(facets.size()) - long(mesh.hexahedra.size());
}

// Every interior edge that is not in four hexahedra is on the inner side of the pillow or goes across it.
template <typename K>
void check_irregular_edges(const Hexahedra<K>& mesh, std::size_t size_before, std::size_t irregular_edges) {
  std::map<std::set<std::size_t>, int> degrees;
  std::set<std::set<std::size_t>> inner;
  std::set<std::size_t> boundary;
  for (const auto& q : mesh.facets) boundary.insert(q.vertices.begin(), q.vertices.end());
  for (std::size_t i = 0; i < mesh.hexahedra.size(); ++i) {
    const auto& h = mesh.hexahedra[i];
    for (const auto& axis : VMP::internal::Reference_hexahedron::axis_edges)
      for (const auto& e : axis) ++degrees[{h[e[0]], h[e[1]]}];
    for (int k = 0; k < 4 && i >= size_before; ++k) inner.insert({h[k], h[(k + 1) % 4]});
  }
  std::size_t count = 0;
  for (const auto& [edge, degree] : degrees) {
    const bool on_boundary = boundary.count(*edge.begin()) && boundary.count(*edge.rbegin());
    if (on_boundary || degree == 4) continue;
    ++count;
    const bool is_across = boundary.count(*edge.begin()) || boundary.count(*edge.rbegin());
    assert((is_across || inner.count(edge)) && (degree == 3 || degree == 5));
  }
  assert(count == irregular_edges && count > 0);
}

VMP::Hexahedra_optimization with_pillow() {
  VMP::Hexahedra_optimization options;
  options.most_sweeps = 50;
  options.surface_tolerance = 0;
  options.slides_over_smooth_rims = true;
  return options;
}

template <typename K>
void test_block(int holes, double edge) {
  const Hexahedra<K> old = grid<K>(holes, edge);
  Hexahedra<K> mesh = old;
  assert(VMP::pillow_hexahedra(mesh).ok());
  const std::size_t layer =
      VMP::number_of_boundary_quadrilaterals(prism<K>(holes), VMP::prism_grid(prism<K>(holes), edge));
  assert(layer == old.facets.size() && mesh.hexahedra.size() == old.hexahedra.size() + layer);
  assert(euler_characteristic<K>(mesh) == 1 - holes && euler_characteristic<K>(old) == 1 - holes);
  for (std::size_t v = 0; v < old.points.size(); ++v) assert(mesh.points[v] == old.points[v]);
  for (std::size_t q = 0; q < layer; ++q)
    assert(mesh.facets[q].vertices == old.facets[q].vertices && mesh.facets[q].label == old.facets[q].label);
  for (std::size_t h = 0; h < old.hexahedra.size(); ++h)
    for (int i = 0; i < 8; ++i)
      assert(mesh.hexahedra[h][i] == old.hexahedra[h][i] || mesh.hexahedra[h][i] >= old.points.size());
  const VMP::Hexahedra_report report = VMP::verify_hexahedra(mesh);
  assert(report.is_valid() && report.genus == holes && report.minimum_scaled_jacobian > 0.05);
  assert(std::abs(volume<K>(mesh) - (3 * (2 * holes + 1) - holes) * height) < 1e-9);
  check_irregular_edges<K>(mesh, old.hexahedra.size(), report.irregular_edges);

  VMP::Compact_tetrahedral_mesh_3<K> object;
  assert(object.assign(Block_with_holes<typename K::Point_3>(holes, 1, 1, height).soup()).ok());
  assert(VMP::optimize_hexahedra(object, mesh, with_pillow()).ok());
  const VMP::Hexahedra_report after = VMP::verify_hexahedra(mesh);

  assert(after.is_valid() && after.minimum_scaled_jacobian > 0.4 && after.mean_scaled_jacobian > 0.6);
  assert(std::abs(volume<K>(mesh) / ((3 * (2 * holes + 1) - holes) * height) - 1) < 0.05);
}

// A ball: floor, ceiling and wall meet smoothly. Nodes leave the rims, but not the surface, and labels stay.
void test_ball() {
  const auto round = [](const Point_3& p) {
    const double x = 2 * p.x() - 1, y = p.y() / 1.5 - 1, z = 2 * p.z() / height - 1;
    const double r = std::max({std::abs(x), std::abs(y), std::abs(z)}),
                 norm = std::sqrt(x * x + y * y + z * z);
    const double s = norm > 0 ? r / norm : 1;
    return Point_3(s * x, s * y, s * z);
  };
  VMP::Compact_tetrahedral_mesh_3<Kernel> object;
  assert(object.assign(transformed(Block_with_holes<Point_3>(0, 4, 4, height).soup(), round)).ok());
  Hexahedra<Kernel> mesh = transformed(grid<Kernel>(0, 0.25), round);
  const std::vector<VMP::Labelled_quadrilateral> old_facets = mesh.facets;
  assert(VMP::pillow_hexahedra(mesh).ok());
  assert(VMP::optimize_hexahedra(object, mesh, with_pillow()).ok());
  const VMP::Hexahedra_report report = VMP::verify_hexahedra(mesh);
  assert(report.is_valid() && report.minimum_scaled_jacobian > 0.4 && report.mean_scaled_jacobian > 0.8);
  for (std::size_t q = 0; q < old_facets.size(); ++q)
    for (std::size_t v : mesh.facets[q].vertices) {
      const double distance = std::sqrt((mesh.points[v] - CGAL::ORIGIN).squared_length());
      assert(mesh.facets[q].label == old_facets[q].label && distance > 0.9 && distance < 1 + 1e-9);
    }
}

// With the pillow, the number of hexahedra is near the target.
void test_size() {
  for (int holes : {0, 1, 2})
    for (double target : {4000., 30000.}) {
      const VMP::Prism_3<Kernel> p = prism<Kernel>(holes);
      const VMP::Prism_grid grid = VMP::prism_grid_of_size(p, std::size_t(target), true);
      const std::size_t n =
          VMP::number_of_hexahedra(p, grid) + VMP::number_of_boundary_quadrilaterals(p, grid);
      assert(std::abs(double(n) / target - 1) < 0.2);
    }
}

void test_refused() {
  Hexahedra<Kernel> mesh, old = grid<Kernel>(1, 1);
  const auto code = [&] {
    const auto hexahedra = mesh.hexahedra;
    const VMP::Error_code result = VMP::pillow_hexahedra(mesh).code();
    assert(mesh.hexahedra == hexahedra);
    return result;
  };
  assert(code() == VMP::ERROR_EMPTY_MESH);
  mesh = old;
  mesh.hexahedra[0][0] = 999;
  assert(code() == VMP::ERROR_INDEX_OUT_OF_RANGE);
  mesh = old;
  mesh.points[0] = Point_3(std::numeric_limits<double>::infinity(), 0, 0);
  assert(code() == VMP::ERROR_COORDINATE_NOT_FINITE);
  mesh = old;
  mesh.hexahedra.push_back(mesh.hexahedra[4]); // its facets are in three
  assert(code() == VMP::ERROR_NON_MANIFOLD);
  mesh = old;
  mesh.hexahedra = {old.hexahedra[1], old.hexahedra[3]}; // they share an edge
  assert(code() == VMP::ERROR_NON_MANIFOLD);
}

int main() {
  for (int holes : {0, 1, 2}) test_block<Kernel>(holes, 0.5);
  test_block<CGAL::Exact_predicates_exact_constructions_kernel>(1, 1);
  test_block<Kernel>(0, 3); // hexahedra with five and more sides on the boundary
  test_ball();
  test_size();
  test_refused();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
