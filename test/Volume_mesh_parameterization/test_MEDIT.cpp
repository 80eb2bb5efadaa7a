#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>

#include "io_test_util.h"
#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <sstream>
#include <streambuf>

namespace CGAL::Volume_mesh_parameterization {
bool operator==(const Labelled_facet& a, const Labelled_facet& b) {
  return a.vertices == b.vertices && a.label == b.label;
}
bool operator==(const Labelled_quadrilateral& a, const Labelled_quadrilateral& b) {
  return a.vertices == b.vertices && a.label == b.label;
}
} // namespace CGAL::Volume_mesh_parameterization

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Hexahedra = VMP::Hexahedron_soup_3<Point>;

template <typename Mesh>
std::string written(const Mesh& mesh) {
  std::ostringstream os;
  expect(VMP::IO::write_MEDIT(os, mesh), VMP::OK);
  return os.str();
}

template <typename Mesh = Soup>
VMP::Status read(const std::string& text, Mesh& mesh) {
  std::istringstream is(text);
  return VMP::IO::read_MEDIT(is, mesh);
}

Soup block_with_awkward_coordinates() {
  Soup soup = Block_with_holes<Point>(1, 2, 2).soup();
  for (Point& p : soup.points) p = Point(p.x() / 3, -std::sqrt(1 + p.y()) * 1e-9, p.z() * 1.1e300);
  soup.points[0] = Point(-0., std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max());
  return soup;
}

void test_round_trip() {
  const Soup soup = block_with_awkward_coordinates();
  Soup back;
  expect(read(written(soup), back), VMP::OK);
  assert(back.points == soup.points && back.cells == soup.cells && back.facets == soup.facets);
  assert(written(back) == written(soup));
}

void test_models_of_the_concept() {
  const Soup soup = Block_with_holes<Point>(1, 2, 2).soup();
  VMP::Compact_tetrahedral_mesh_3<Kernel> mesh, mesh_back;
  expect(mesh.assign(soup), VMP::OK);
  Soup back;
  expect(read(written(mesh), back), VMP::OK);
  expect(mesh_back.assign(back), VMP::OK);
  assert(back.points == soup.points && back.cells == soup.cells);
  for (VMP::Facet_index f : mesh.boundary_facets()) assert(mesh.label(f) == mesh_back.label(f));

  using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  VMP::Tetrahedron_soup_3<Exact_point> exact;
  expect(read(written(soup), exact), VMP::OK);
  assert(written(exact) == written(soup));
}

Hexahedra cube() {
  Hexahedra cube;
  for (int z : {0, 1})
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
      cube.points.emplace_back(x, y, z + .1);
  cube.hexahedra = {{0, 1, 2, 3, 4, 5, 6, 7}};
  cube.facets = {{{0, 3, 2, 1}, 1}, {{4, 5, 6, 7}, 2}};
  return cube;
}

void test_hexahedra() {
  Hexahedra back;
  expect(read(written(cube()), back), VMP::OK);
  assert(back.points == cube().points && back.hexahedra == cube().hexahedra && back.facets == cube().facets);
  Soup soup;
  expect(read(written(cube()), soup), VMP::ERROR_WRONG_FORMAT, "section Hexahedra: all cells must be Tetrahedra");
}

const std::string good = "MeshVersionFormatted 1 # a comment\n"
                         "Dimension\n3\n"
                         "Tetrahedra 1\n1 2 3 4 7\n"
                         "Corners\n1\n2\n"
                         "Vertices\n4\n0 0 0 1\n1 0 0 1\n+0 1.0E0 0 1 # another\n1e-400 0 1e0 1\n"
                         "Edges 2 1 2 0 2 3 0\n"
                         "Triangles\r\n1\r\n1 2 3 5\r\n"
                         "End\n";

void test_reading() {
  Soup soup;
  expect(read(good, soup), VMP::OK);
  assert(soup.points == std::vector<Point>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  assert(soup.cells.size() == 1 && soup.cells[0] == (std::array<std::size_t, 4>{0, 1, 2, 3}));
  assert(soup.facets.size() == 1 && soup.facets[0] == (VMP::Labelled_facet{{0, 1, 2}, 5}));
}

void refuse(const std::string& old_part, const std::string& new_part, VMP::Error_code code,
            const std::string& culprit) {
  Soup soup = Block_with_holes<Point>(0, 1, 1).soup();
  const Soup before = soup;
  expect(read(replaced(good, old_part, new_part), soup), code, culprit);
  assert(soup.points == before.points && soup.cells == before.cells);
}

void test_refusals() {
  Soup soup;
  expect(read("", soup), VMP::ERROR_WRONG_FORMAT, "the file is empty");
  expect(read(" # only this\n", soup), VMP::ERROR_WRONG_FORMAT, "the file is empty");
  expect(read("OFF\n4 4 6\n", soup), VMP::ERROR_WRONG_FORMAT, "line 1: an ASCII MEDIT file starts with");
  expect(read("MeshVersionFormatted 2\nEnd", soup), VMP::ERROR_WRONG_FORMAT, "no section Vertices");
  refuse("Dimension\n3", "Dimension 2", VMP::ERROR_WRONG_FORMAT, "line 2: Dimension is not 3");
  refuse("Corners", "Corner", VMP::ERROR_WRONG_FORMAT, "line 6: unknown section 'Corner'");
  refuse("Corners", "Edges 0 Corners", VMP::ERROR_WRONG_FORMAT, "a second section Edges");
  refuse("1.0E0", "one", VMP::ERROR_WRONG_FORMAT, "line 13: Vertices, entry 3: not the numbers");
  refuse("1.0E0", "nan", VMP::ERROR_COORDINATE_NOT_FINITE, "Vertices, entry 3");
  refuse("1.0E0", "-inf", VMP::ERROR_COORDINATE_NOT_FINITE, "Vertices, entry 3");
  refuse("1.0E0", "1e999", VMP::ERROR_COORDINATE_NOT_FINITE, "Vertices, entry 3");
  refuse("Vertices\n4", "Vertices\n-4", VMP::ERROR_WRONG_FORMAT, "section Vertices does not start with a count");
  refuse("Vertices\n4", "Vertices\n1000000000000000000", VMP::ERROR_WRONG_FORMAT, "truncated: 1000000000000000000");
  refuse("Vertices\n4", "Vertices\n99999999999999999999999", VMP::ERROR_WRONG_FORMAT, "does not start with a count");
  refuse("Edges 2", "Edges 12", VMP::ERROR_WRONG_FORMAT, "Edges");
  refuse("1 2 3 4 7", "1 2 3 5 7", VMP::ERROR_INDEX_OUT_OF_RANGE, "Tetrahedra, entry 1: vertex 5 of 4");
  refuse("1 2 3 4 7", "0 2 3 4 7", VMP::ERROR_INDEX_OUT_OF_RANGE, "Tetrahedra, entry 1: vertex 0 of 4");
  refuse("1 2 3 4 7", "1 -2 3 4 7", VMP::ERROR_WRONG_FORMAT, "Tetrahedra, entry 1");
  refuse("1 2 3 5\r", "1 2 6 5\r", VMP::ERROR_INDEX_OUT_OF_RANGE, "Triangles, entry 1: vertex 6 of 4");
  refuse("1 2 3 5\r", "1 2 3 5.5\r", VMP::ERROR_WRONG_FORMAT, "Triangles, entry 1");
}

// Wherever a file is cut it is refused, except between End and the last line break.
void test_truncation() {
  for (const std::string& text : {good, written(Block_with_holes<Point>(0, 1, 1).soup())})
    for (std::size_t size = 0; size + 1 < text.size(); ++size) {
      Soup soup;
      assert(read(text.substr(0, size), soup).code() == VMP::ERROR_WRONG_FORMAT);
    }
}

void test_files() {
  const Temporary_folder folder("test_MEDIT");
  const Soup soup = block_with_awkward_coordinates();
  Soup back;
  expect(VMP::IO::write_MEDIT(folder.file("a.mesh"), soup), VMP::OK);
  expect(VMP::IO::read_MEDIT(folder.file("a.mesh"), back), VMP::OK);
  assert(back.points == soup.points && back.cells == soup.cells && back.facets == soup.facets);
  expect(VMP::IO::read_MEDIT(folder.file("b.mesh"), back), VMP::ERROR_CANNOT_READ_FILE, "b.mesh: No such file");
  expect(VMP::IO::read_MEDIT(folder.file(""), back), VMP::ERROR_CANNOT_READ_FILE, "");
  write_text(folder.file("b.mesh"), "rubbish");
  expect(VMP::IO::read_MEDIT(folder.file("b.mesh"), back), VMP::ERROR_WRONG_FORMAT, "b.mesh: line 1");
  expect(VMP::IO::write_MEDIT(folder.file("none/a.mesh"), soup), VMP::ERROR_CANNOT_WRITE_FILE, "a.mesh: No such file");
  Soup bad = soup;
  bad.points[3] = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  expect(VMP::IO::write_MEDIT(folder.file("a.mesh"), bad), VMP::ERROR_COORDINATE_NOT_FINITE, "a.mesh: vertex 3");
  expect(VMP::IO::read_MEDIT(folder.file("a.mesh"), back), VMP::OK); // what was there is still there
  assert(back.points == soup.points && folder.number_of_files() == 2);
}

// A stream that cannot take more is a failure to be returned, even if the stream has been told to throw.
void test_full_stream() {
  struct Full_buffer : std::streambuf {} buffer;
  for (bool throws : {false, true})
    for (int per_unit : {1, 5}) { // less and more than what is handed to a stream at once
      std::ostream os(&buffer);
      if (throws) os.exceptions(std::ios::badbit | std::ios::failbit);
      expect(VMP::IO::write_MEDIT(os, Block_with_holes<Point>(2, per_unit, per_unit).soup()), VMP::ERROR_CANNOT_WRITE_FILE);
    }
}

int main() {
  test_round_trip();
  test_models_of_the_concept();
  test_hexahedra();
  test_reading();
  test_refusals();
  test_truncation();
  test_files();
  test_full_stream();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
