#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_cells.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_polygons.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize_polycube.h>

#include "io_test_util.h"
#include "polycube_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <sstream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Point_3 = Inexact::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Inexact>;
using Boxes = VMP::Hexahedron_soup_3<Point_3>;
using Polygons = VMP::Polygon_soup_3<Point_3>;

template <typename Kernel>
typename Kernel::FT volume(const VMP::Compact_tetrahedral_mesh_3<Kernel>& mesh) {
  typename Kernel::FT sum(0);
  for (VMP::Cell_index c : mesh.cells()) {
    const auto& v = mesh.cell(c);
    const auto& p = mesh.point(v[0]);
    sum += CGAL::determinant(mesh.point(v[1]) - p, mesh.point(v[2]) - p, mesh.point(v[3]) - p);
  }
  return sum / 6;
}

template <typename Kernel>
typename Kernel::FT boundary_area(const VMP::Compact_tetrahedral_mesh_3<Kernel>& mesh) {
  typename Kernel::FT sum(0);
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    const auto n =
        CGAL::cross_product(mesh.point(v[1]) - mesh.point(v[0]), mesh.point(v[2]) - mesh.point(v[0]));
    sum += (CGAL::abs(n.x()) + CGAL::abs(n.y()) + CGAL::abs(n.z())) / 2; // one of them is not zero
  }
  return sum;
}

template <typename Polycube>
Mesh filled(const Polycube& polycube, std::size_t number_of_cells = 0) {
  Mesh mesh;
  const VMP::Status status = VMP::tetrahedralize_polycube(polycube, mesh, number_of_cells);
  if (!status.ok()) std::cerr << status.message() << std::endl;
  assert(status.ok());
  return mesh;
}

template <typename Polycube>
VMP::Status failure(const Polycube& polycube) {
  Mesh mesh = filled(cubes<Point_3>({{0, 0, 0}}));
  const VMP::Status status = VMP::tetrahedralize_polycube(polycube, mesh);
  assert(mesh.number_of_cells() == 6); // as it was
  std::cout << status.message() << std::endl;
  return status;
}

void test_cells() {
  const Boxes stairs = cubes<Point_3>(l_stairs());
  for (std::size_t wanted : {0, 100, 1000, 30000}) {
    const Mesh mesh = filled(stairs, wanted);
    std::cout << mesh.number_of_cells() << " tetrahedra for " << wanted << std::endl;
    assert(std::abs(volume(mesh) - double(l_stairs().size())) < 1e-9);
    assert(wanted < 1000 || std::abs(double(mesh.number_of_cells()) / double(wanted) - 1) < .6);
    assert(VMP::summarize_partition(mesh).genus == 0);
  }
  assert(VMP::summarize_partition(filled(cubes<Point_3>(ring()))).genus == 1);

  VMP::Compact_tetrahedral_mesh_3<Exact> exact;
  const VMP::Status status = VMP::tetrahedralize_polycube(cubes<Exact::Point_3>(l_stairs()), exact, 2000);
  assert(status.ok() && volume(exact) == int(l_stairs().size()) && exact.number_of_cells() > 500);
}

// Boxes of any sizes, with vertices in any order and labels on one of their quadrilaterals.
void test_boxes() {
  Boxes boxes = cubes<Point_3>({{0, 0, 0}, {1, 0, 0}});
  for (std::size_t v = 0; v < boxes.points.size(); ++v) {
    const Point_3 p = boxes.points[v];
    boxes.points[v] = Point_3(p.x() == 2 ? 1.25 : p.x(), .01 * p.y(), v < 8 ? 3 * p.z() : p.z());
  }
  std::swap(boxes.hexahedra[0][0], boxes.hexahedra[0][5]);
  boxes.facets.push_back({{0, 1, 2, 3}, VMP::FLOOR});       // whole
  boxes.facets.push_back({{9, 10, 14, 13}, 7});             // x = 1.25
  boxes.facets.push_back({{8, 11, 15, 12}, VMP::INTERIOR}); // between the boxes, without a label
  for (std::size_t wanted : {0, 5000}) {
    const Mesh mesh = filled(boxes, wanted);
    assert(std::abs(volume(mesh) - .0325) < 1e-12);
    std::size_t labelled = 0;
    for (VMP::Facet_index f : mesh.boundary_facets()) {
      const auto v = mesh.vertices(f);
      const Point_3 p = CGAL::centroid(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
      assert(mesh.label(f) == (p.z() == 0 && p.x() < 1 ? int(VMP::FLOOR)
                               : p.x() == 1.25         ? 7
                                                       : int(VMP::INTERIOR)));
      labelled += mesh.label(f) != VMP::INTERIOR;
    }
    assert(labelled > 0);
  }
  boxes.facets[2].label = 3;
  assert(failure(boxes).code() == VMP::ERROR_LABEL_NOT_ON_BOUNDARY);
  boxes.facets[2] = {{0, 2, 13, 6}, 3}; // in no plane
  assert(failure(boxes).code() == VMP::ERROR_LABEL_NOT_ON_BOUNDARY);
  boxes.facets[2] = {{0, 2, 13, 99}, 3};
  assert(failure(boxes).code() == VMP::ERROR_LABEL_NOT_ON_BOUNDARY);
}

void test_bad_boxes() {
  expect(failure(Boxes()), VMP::ERROR_EMPTY_MESH);
  Boxes boxes = cubes<Point_3>({{0, 0, 0}, {1, 0, 0}});
  boxes.hexahedra[1][3] = 16;
  expect(failure(boxes), VMP::ERROR_INDEX_OUT_OF_RANGE, "hexahedron 1");
  boxes.hexahedra[1][3] = 12;
  expect(failure(boxes), VMP::ERROR_NOT_A_POLYCUBE, "hexahedron 1");
  boxes = cubes<Point_3>({{0, 0, 0}, {1, 0, 0}});
  boxes.points[9] = Point_3(2, .5, 0);
  expect(failure(boxes), VMP::ERROR_NOT_A_POLYCUBE, "hexahedron 1");
  boxes.points[9] = Point_3(2, std::numeric_limits<double>::quiet_NaN(), 0);
  expect(failure(boxes), VMP::ERROR_COORDINATE_NOT_FINITE, "vertex 9");
  expect(failure(cubes<Point_3>({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}})), VMP::ERROR_NOT_A_POLYCUBE,
         "hexahedra 0 and 2");
  expect(failure(cubes<Point_3>({{0, 0, 0}, {1, 1, 0}})), VMP::ERROR_NON_MANIFOLD, "(1, 1, 0)");
  expect(failure(cubes<Point_3>({{0, 0, 0}, {1, 1, 1}})), VMP::ERROR_NON_MANIFOLD, "(1, 1, 1)");
  // the complement is pinched: seven of the eight cubes around (1, 1, 1) but for two opposite ones
  expect(failure(cubes<Point_3>({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}})),
         VMP::ERROR_NON_MANIFOLD);
  expect(failure(cubes<Point_3>({{0, 0, 0}, {2, 0, 0}})), VMP::ERROR_SEVERAL_COMPONENTS, "2 parts");
  std::vector<Cell> shell;
  for (int i = 0; i < 27; ++i)
    if (i != 13) shell.push_back({i % 3, i / 3 % 3, i / 9});
  expect(failure(cubes<Point_3>(shell)), VMP::ERROR_SEVERAL_COMPONENTS, "cavity");
  // each of n long boxes is cut by the planes of all others
  Boxes slats;
  for (int i = 0; i < 300; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const Boxes cube = cubes<Point_3>({{0, 0, 0}});
      for (std::size_t v = 0; v < 8; ++v) {
        double x[3];
        for (int k = 0; k < 3; ++k)
          x[k] = k == axis ? 2 * i + cube.points[v][k] : 1000 * axis + 1000 * cube.points[v][k];
        slats.points.emplace_back(x[0], x[1], x[2]);
      }
      slats.hexahedra.push_back(cube.hexahedra[0]);
      for (std::size_t& v : slats.hexahedra.back()) v += slats.points.size() - 8;
    }
  expect(failure(slats), VMP::ERROR_WRONG_PARAMETER, "boxes");
}

// The squares between a cell and another place, or all squares of all cells.
void test_surfaces() {
  for (const auto& cells : {l_stairs(), ring(), overhang()}) {
    const Mesh expected = filled(cubes<Point_3>(cells));
    for (bool with_inner : {false, true})
      for (bool as_triangles : {false, true}) {
        const Mesh mesh = filled(cube_faces<Point_3>(cells, with_inner, as_triangles));
        assert(volume(mesh) == volume(expected) && boundary_area(mesh) == boundary_area(expected));
      }
    // cells between facet planes only: fewer
    assert(filled(cube_faces<Point_3>(cells, false, false)).number_of_cells() <= expected.number_of_cells());
  }
  // a cuboid whose faces are fine triangles is one box
  std::vector<Cell> block;
  for (int i = 0; i < 60; ++i) block.push_back({i % 3, i / 3 % 4, i / 12});
  const Mesh box = filled(cube_faces<Point_3>(block, false, true));
  assert(box.number_of_cells() == 6 && volume(box) == 60);
}

void test_labelled_surface() {
  // a triangle that is too small to cover anything labels the square that it lies in
  std::vector<Cell> block;
  for (int i = 0; i < 60; ++i) block.push_back({i % 3, i / 3 % 4, i / 12});
  Polygons surface = cube_faces<Point_3>(block, false, true);
  for (std::size_t f = 0; f < surface.polygons.size(); ++f) {
    surface.labels.assign(surface.polygons.size(), VMP::INTERIOR);
    surface.labels[f] = VMP::FLOOR;
    const Mesh mesh = filled(surface);
    int labelled = 0;
    for (VMP::Facet_index g : mesh.boundary_facets()) {
      if (mesh.label(g) != VMP::FLOOR) continue;
      ++labelled;
      for (int axis = 0; axis < 3; ++axis) {
        const auto at = [&](int i) { return surface.points[surface.polygons[f][i]][axis]; };
        if (at(0) != at(1) || at(0) != at(2)) continue;
        for (VMP::Vertex_index v : mesh.vertices(g)) assert(mesh.point(v)[axis] == at(0));
      }
    }
    assert(labelled == 2);
  }
  surface = cube_faces<Point_3>({{0, 0, 0}, {1, 0, 0}}, true, false);
  surface.labels.assign(surface.polygons.size(), VMP::FLOOR);
  expect(failure(surface), VMP::ERROR_LABEL_NOT_ON_BOUNDARY, "facet");
}

void test_bad_surfaces() {
  expect(failure(Polygons()), VMP::ERROR_EMPTY_MESH);
  const Polygons good = cube_faces<Point_3>(overhang(), false, true);
  Polygons bad = good;
  bad.polygons[3][1] = bad.points.size();
  expect(failure(bad), VMP::ERROR_INDEX_OUT_OF_RANGE, "facet 3");
  bad = good;
  bad.polygons[5][1] = bad.polygons[5][0];
  expect(failure(bad), VMP::ERROR_NOT_A_POLYCUBE, "facet 5 ");
  bad = good;
  bad.points[bad.polygons[7][0]] = Point_3(.1, .2, .3);
  expect(failure(bad), VMP::ERROR_NOT_A_POLYCUBE, "facet");
  bad.points[0] = Point_3(0, 0, std::numeric_limits<double>::infinity());
  expect(failure(bad), VMP::ERROR_COORDINATE_NOT_FINITE, "vertex 0");
  bad = good;
  bad.polygons.resize(2);
  expect(failure(bad), VMP::ERROR_OPEN_SURFACE, "facet 0");
  bad = cube_faces<Point_3>(overhang(), false, false);
  bad.polygons.pop_back();
  expect(failure(bad), VMP::ERROR_OPEN_SURFACE, "facet");
  expect(failure(cube_faces<Point_3>({{0, 0, 0}, {1, 1, 0}}, false, false)), VMP::ERROR_NON_MANIFOLD,
         "(1, 1, 0)");
  expect(failure(cube_faces<Point_3>({{0, 0, 0}, {2, 2, 0}}, false, false)), VMP::ERROR_SEVERAL_COMPONENTS);
  std::vector<Cell> diagonal;
  for (int i = 0; i < 200; ++i) diagonal.push_back({2 * i, 2 * i, 2 * i});
  expect(failure(cube_faces<Point_3>(diagonal, false, false)), VMP::ERROR_WRONG_PARAMETER, "boxes");
}

void test_read_cells() {
  const auto read = [](const std::string& text, Boxes& boxes) {
    std::istringstream is(text);
    return VMP::IO::read_cells(is, boxes);
  };
  Boxes boxes;
  VMP::Status status = read("# two cells\n0 0 0\n\n -1 0 +0 # beside it\n", boxes);
  assert(status.ok() && boxes.hexahedra.size() == 2 && volume(filled(boxes)) == 2);
  expect(read("", boxes), VMP::ERROR_EMPTY_MESH);
  expect(read("# nothing\n", boxes), VMP::ERROR_EMPTY_MESH);
  expect(read("0 0 0\n\n1 0\n", boxes), VMP::ERROR_WRONG_FORMAT, "line 3");
  expect(read("0 0 0 1\n", boxes), VMP::ERROR_WRONG_FORMAT, "line 1");
  expect(read("0 0 .5\n", boxes), VMP::ERROR_WRONG_FORMAT, "line 1");
  expect(read("0 0 99999999999", boxes), VMP::ERROR_WRONG_FORMAT, "line 1");
  expect(read("0 0 0\n1 2 3\n0 0 0\n", boxes), VMP::ERROR_WRONG_FORMAT, "cell 0 0 0");
  assert(boxes.hexahedra.size() == 2);
  expect(VMP::IO::read_cells("no such file", boxes), VMP::ERROR_CANNOT_READ_FILE, "no such file");
}

void test_read_polygons() {
  const Temporary_folder folder("test_tetrahedralize_polycube");
  const std::string cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                           "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  write_text(folder.file("cube.obj"), cube);
  Polygons surface;
  VMP::Status status = VMP::IO::read_polygons(folder.file("cube.obj"), surface);
  assert(status.ok() && surface.polygons.size() == 6 && volume(filled(surface)) == 1);
  write_text(folder.file("tetrahedron.off"),
             "OFF 4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  status = VMP::IO::read_polygons(folder.file("tetrahedron.off"), surface);
  assert(status.ok() && surface.polygons.size() == 4);
  expect(failure(surface), VMP::ERROR_NOT_A_POLYCUBE, "facet 2 ");
  write_text(folder.file("truncated.off"), "OFF 4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n4 0");
  expect(VMP::IO::read_polygons(folder.file("truncated.off"), surface), VMP::ERROR_WRONG_FORMAT,
         "truncated.off");
  expect(VMP::IO::read_polygons(folder.file("none.off"), surface), VMP::ERROR_CANNOT_READ_FILE, "none.off");
  assert(surface.polygons.size() == 4);
}

int main() {
  test_cells();
  test_boxes();
  test_bad_boxes();
  test_surfaces();
  test_labelled_surface();
  test_bad_surfaces();
  test_read_cells();
  test_read_polygons();
  return EXIT_SUCCESS;
}
