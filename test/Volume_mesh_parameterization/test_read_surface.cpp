#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/IO/read_surface.h>

#include "io_test_util.h"

#include <cassert>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Soup = VMP::Triangle_soup_3<Point>;

const std::string off = "OFF # a tetrahedron, and a point that is not used\n5 4\t0\n"
                        "0 0 0\n9 9 9\n1 0 0\n0 1 0\n0 0 1.5e0\n"
                        "3 0 3 2 255 0 0\n3 0 2 4\n3 2 3 4\n3 3 0 4\n";
const std::string off_with_normals = "NOFF\n4 4 6\n0 0 0 -1 -1 -1\n1 0 0 1 0 0\n0 1 0 0 1 0\n0 0 1.5 0 0 1\n"
                                     "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3";
const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1.5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
const std::string ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                        "property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
                        "0 0 0\n1 0 0\n0 1 0\n0 0 1.5\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

std::string stl() {
  std::string text = "solid t\n";
  for (const char* v : {"0 0 0,0 1 0,1 0 0", "0 0 0,1 0 0,0 0 1.5", "1 0 0,0 1 0,0 0 1.5", "0 1 0,0 0 0,0 0 1.5"}) {
    std::string vertices = v;
    for (int i : {0, 1}) vertices = replaced(vertices, ",", i == 0 ? "\nvertex " : " \nvertex ");
    text += "facet normal 0 0 0\nouter loop\nvertex " + vertices + "\nendloop\nendfacet\n";
  }
  return text + "endsolid t\n";
}

void test_formats(const Temporary_folder& folder) {
  for (const auto& [name, text] : {std::pair("a.off", off), {"b.OFF", off_with_normals}, {"a.obj", obj}, {"a.ply", ply},
                                   {"a.stl", stl()}}) {
    Soup soup;
    write_text(folder.file(name), text);
    expect(VMP::IO::read_surface(folder.file(name), soup), VMP::OK);
    assert(soup.points.size() == 4 && soup.triangles.size() == 4);
    double volume = 0;
    for (const auto& t : soup.triangles)
      volume += CGAL::volume(Point(1, 1, 1), soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
    assert(std::abs(volume - .25) < 1e-12);
  }
}

void refuse(const Temporary_folder& folder, const std::string& name, const std::string& text, VMP::Error_code code,
            const std::string& culprit) {
  write_text(folder.file(name), text);
  Soup soup;
  expect(VMP::IO::read_surface(folder.file(name), soup), code, name + ": " + culprit);
  assert(soup.points.empty() && soup.triangles.empty());
}

void test_refusals_of_OFF(const Temporary_folder& folder) {
  const auto refuse_off = [&](const std::string& old_part, const std::string& new_part, VMP::Error_code code,
                              const std::string& culprit) {
    refuse(folder, "bad.off", replaced(off, old_part, new_part), code, culprit);
  };
  refuse_off("OFF", "FOO", VMP::ERROR_WRONG_FORMAT, "line 1: an OFF file");
  refuse_off("OFF", "4OFF", VMP::ERROR_WRONG_FORMAT, "line 1: an OFF file");
  refuse_off("OFF", "OFF BINARY", VMP::ERROR_WRONG_FORMAT, "line 1: the file is binary");
  refuse_off("5 4", "-5 4", VMP::ERROR_WRONG_FORMAT, "line 2: the counts: not the numbers");
  refuse_off("5 4", "1000000000000 4", VMP::ERROR_WRONG_FORMAT, "line 3: the file is truncated: 1000000000000 vertices");
  refuse_off("5 4", "5 9", VMP::ERROR_WRONG_FORMAT, "line 12: face 4: the file is truncated");
  refuse_off("9 9 9", "9 9 x", VMP::ERROR_WRONG_FORMAT, "line 4: vertex 1: not the numbers");
  refuse_off("9 9 9", "9 nan 9", VMP::ERROR_COORDINATE_NOT_FINITE, "vertex 1");
  refuse_off("3 2 3 4", "4 2 3 4 0", VMP::ERROR_NOT_TRIANGULATED, "face 2 has 4 vertices");
  refuse_off("3 2 3 4", "4294967296 2 3 4", VMP::ERROR_WRONG_FORMAT, "line 12: face 2: the file is truncated");
  refuse_off("3 2 3 4", "3 2 3 5", VMP::ERROR_INDEX_OUT_OF_RANGE, "face 2: vertex 5 of 5");
  refuse_off("3 2 3 4", "3 2 -3 4", VMP::ERROR_WRONG_FORMAT, "line 10: face 2");
  refuse(folder, "bad.off", "OFF\n0 0 0\n", VMP::ERROR_EMPTY_MESH, "it has no triangles");
  for (std::size_t size = 0; size + 2 < off.size(); ++size) {
    write_text(folder.file("bad.off"), off.substr(0, size));
    Soup soup;
    assert(!VMP::IO::read_surface(folder.file("bad.off"), soup).ok());
  }
}

void test_refusals(const Temporary_folder& folder) {
  for (const char* name : {"bad.off", "bad.obj", "bad.ply", "bad.stl"})
    refuse(folder, name, "", VMP::ERROR_WRONG_FORMAT, "the file is empty");
  refuse(folder, "bad.xyz", "0 0 0", VMP::ERROR_WRONG_FORMAT, "the type of a surface must be");
  refuse(folder, "bad", "0 0 0", VMP::ERROR_WRONG_FORMAT, "the type of a surface must be");
  refuse(folder, "bad.obj", replaced(obj, "f 2 3 4", "f 2 3 4 1"), VMP::ERROR_NOT_TRIANGULATED, "face 2 has 4 vertices");
  refuse(folder, "bad.obj", replaced(obj, "f 2 3 4", "f 2 3 5"), VMP::ERROR_INDEX_OUT_OF_RANGE, "face 2");
  refuse(folder, "bad.ply", ply.substr(0, ply.size() - 20), VMP::ERROR_WRONG_FORMAT, "it is truncated or not");
  refuse(folder, "bad.ply", replaced(ply, "3 1 2 3", "3 1 2 4"), VMP::ERROR_INDEX_OUT_OF_RANGE, "face 2");
  refuse(folder, "bad.ply", replaced(ply, "element vertex 4\n", ""), VMP::ERROR_WRONG_FORMAT,
         "a property comes before all elements");
  refuse(folder, "bad.stl", stl().substr(0, 200), VMP::ERROR_WRONG_FORMAT, "it is truncated or not");
  Soup soup;
  expect(VMP::IO::read_surface(folder.file("none.off"), soup), VMP::ERROR_CANNOT_READ_FILE, "none.off: No such file");
}

int main() {
  const Temporary_folder folder("test_read_surface");
  test_formats(folder);
  test_refusals_of_OFF(folder);
  test_refusals(folder);
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
