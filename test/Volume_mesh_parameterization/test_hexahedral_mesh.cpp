#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Prism = VMP::Prism_3<Kernel>;
using Hexahedra = VMP::Hexahedron_soup_3<Point_3>;

Prism block(int holes) {
  std::vector<VMP::Rectangle_2> rectangles;
  for (double k = 0; k < holes; ++k) rectangles.push_back({2 * k + 1, 1, 2 * k + 2, 2});
  return Prism({0, 0, 2. * holes + 1, 3}, rectangles, 1.5);
}

struct Identity {
  double height, factor; // a factor of -1 mirrors the block
  VMP::Status operator()(const Point_2& p, const std::vector<double>& levels,
                         std::vector<Point_3>& points) const {
    for (double level : levels) points.push_back(Point_3(p.x(), p.y(), factor * height * level));
    return {};
  }
};

double area(const Hexahedra& mesh, const VMP::Labelled_quadrilateral& q) {
  const auto& v = q.vertices;
  return std::sqrt(CGAL::squared_area(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]])) * 2;
}

// Boxes of the right total volume; quadrilaterals of each label cover that side, and are seen from outside.
void test_block(const Prism& prism) {
  const int holes = int(prism.number_of_holes());
  const VMP::Prism_grid grid = VMP::prism_grid(prism, 0.25);
  Hexahedra mesh;
  const VMP::Status status = VMP::hexahedral_mesh(prism, grid, Identity{1.5, 1}, mesh);
  assert(status.ok() && mesh.hexahedra.size() == VMP::number_of_hexahedra(prism, grid));
  assert(mesh.hexahedra.size() == std::size_t(prism.base_area() * prism.height() * 64));
  const VMP::Hexahedra_report report = VMP::verify_hexahedra(mesh);
  assert(report.is_valid() && report.genus == holes && report.irregular_edges == 0 &&
         report.irregular_vertices == 0);
  assert(report.minimum_scaled_jacobian > 1 - 1e-12);
  std::map<int, double> areas;
  for (const VMP::Labelled_quadrilateral& q : mesh.facets) {
    areas[q.label] += area(mesh, q);
    const auto& v = q.vertices;
    const Point_3 middle = CGAL::midpoint(mesh.points[v[0]], mesh.points[v[2]]);
    const Point_3 outside =
        middle + 1e-3 * CGAL::normal(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]) / area(mesh, q);
    assert(prism.label(middle) == q.label && prism.bounded_side(outside) == CGAL::ON_UNBOUNDED_SIDE);
  }
  assert(areas.size() == std::size_t(holes) + 3);
  assert(std::abs(areas[VMP::FLOOR] - prism.base_area()) < 1e-9 &&
         std::abs(areas[VMP::CEILING] - areas[VMP::FLOOR]) < 1e-9);
  for (int k = 0; k < holes; ++k) {
    const double rim = 2 * (prism.hole(k).width() + prism.hole(k).height());
    assert(std::abs(areas[VMP::FIRST_WALL + 1 + k] - rim * prism.height()) < 1e-9);
  }
}

void test_target() {
  for (std::size_t target : {1000, 5000, 40000}) {
    const Prism prism({0, 0, 3.3, 1.7}, {{0.4, 0.31, 1.1, 0.9}, {1.9, 0.45, 2.55, 1.2}}, 0.8);
    const double count = double(VMP::number_of_hexahedra(prism, VMP::prism_grid_of_size(prism, target)));
    assert(count > 0.8 * double(target) && count < 1.2 * double(target));
  }
}

// Each layer is so many times as high as the one below.
void test_grading() {
  const Prism prism = block(1);
  for (double ratio : {0.5, 1., 1.25}) {
    VMP::Prism_grid grid = VMP::prism_grid(prism, {1., 0.5, 0.3});
    assert(grid.x.size() == 4 && grid.y.size() == 7 && grid.layers() == 5);
    grid.levels = VMP::graded_levels(grid.layers(), ratio);
    Hexahedra mesh;
    const VMP::Status status = VMP::hexahedral_mesh(prism, grid, Identity{1.5, 1}, mesh);
    assert(status.ok() && VMP::verify_hexahedra(mesh).is_valid());
    for (std::size_t k = 1; k < 5; ++k) {
      const auto height = [&](std::size_t i) { return mesh.points[i + 1].z() - mesh.points[i].z(); };
      assert(std::abs(height(k) - ratio * height(k - 1)) < 1e-12);
    }
    assert(mesh.points[0].z() == 0 && mesh.points[5].z() == 1.5);
  }
}

// Two holes whose sides are nearly on the same lines: no slivers between them, and nodes are on the sides all the same.
void test_shared_lines() {
  const Prism prism({0, 0, 5, 3}, {{1, 1, 2, 2}, {3, 1.1, 4, 2.2}}, 1);
  const std::vector<double> fine = VMP::prism_grid(prism, 0.1).y;
  for (double side : {1., 1.1, 2., 2.2}) assert(std::binary_search(fine.begin(), fine.end(), side));
  const VMP::Prism_grid grid = VMP::prism_grid(prism, 0.5);
  assert(grid.y.size() == 7 && grid.x.size() == 11);
  Hexahedra mesh;
  VMP::Status status = VMP::hexahedral_mesh(prism, grid, Identity{1, 1}, mesh);
  assert(status.ok() && mesh.hexahedra.size() == VMP::number_of_hexahedra(prism, grid));
  const VMP::Hexahedra_report report = VMP::verify_hexahedra(mesh);
  assert(report.is_valid() && report.genus == 2 && report.minimum_scaled_jacobian > 0.9);
  for (const VMP::Labelled_quadrilateral& q : mesh.facets)
    if (q.label > VMP::FIRST_WALL)
      for (std::size_t v : q.vertices)
        assert(prism.hole(q.label - VMP::FIRST_WALL - 1).bounded_side(mesh.points[v]) == CGAL::ON_BOUNDARY);
  status = VMP::hexahedral_mesh(prism, {{0, 2.5, 5}, {0, 1, 2, 3}, {0, 1}}, Identity{1, 1}, mesh);
  assert(status.code() == VMP::ERROR_WRONG_PARAMETER); // no column in the holes
}

void test_mirrored() {
  Hexahedra mesh;
  const Prism prism = block(1);
  const VMP::Status status = VMP::hexahedral_mesh(prism, VMP::prism_grid(prism, 1), Identity{1, -1}, mesh);
  assert(status.ok() && VMP::verify_hexahedra(mesh).inverted == mesh.hexahedra.size());
}

void test_refusals() {
  const Prism prism = block(1);
  const VMP::Prism_grid grid = VMP::prism_grid(prism, 1);
  Hexahedra mesh;
  const Identity good{1, 1};
  assert(VMP::hexahedral_mesh(Prism(), grid, good, mesh).code() == VMP::ERROR_WRONG_PARAMETER);
  assert(VMP::hexahedral_mesh(prism, VMP::Prism_grid(), good, mesh).code() == VMP::ERROR_WRONG_PARAMETER);
  VMP::Prism_grid falling = grid;
  falling.levels = {0., 0.6, 0.4, 1.};
  assert(VMP::hexahedral_mesh(prism, falling, good, mesh).code() == VMP::ERROR_WRONG_PARAMETER);
  const auto short_column = [](const Point_2&, const std::vector<double>&, std::vector<Point_3>&) {
    return VMP::Status();
  };
  assert(VMP::hexahedral_mesh(prism, grid, short_column, mesh).code() == VMP::ERROR_WRONG_PARAMETER);
  const auto lost = [](const Point_2&, const std::vector<double>&, std::vector<Point_3>&) {
    return VMP::Status(VMP::ERROR_CURVE_LOST);
  };
  assert(VMP::hexahedral_mesh(prism, grid, lost, mesh).code() == VMP::ERROR_CURVE_LOST &&
         mesh.points.empty());
}

int main() {
  for (int holes = 0; holes <= 3; ++holes) test_block(block(holes));
  test_block(Prism({0, 0, 7, 7}, {{1, 1, 4, 2}, {5, 1, 6, 4}, {3, 5, 6, 6}, {1, 3, 2, 6}, {3, 3, 4, 4}},
                   1.5)); // a pinwheel
  test_block(Prism({0, 0, 4, 3}, {{1, 1, 2, 1.5}, {0.5, 2, 2.5, 2.5}, {2.25, 0.25, 3.75, 1.75}}, 1.5));
  test_target();
  test_grading();
  test_shared_lines();
  test_mirrored();
  test_refusals();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
