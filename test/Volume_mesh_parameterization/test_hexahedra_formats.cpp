#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/IO/Abaqus.h>
#include <CGAL/Volume_mesh_parameterization/IO/Gmsh.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#include "hexahedra_test_util.h"
#include "io_test_util.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Point = Hexahedra::Point_3;
using Quadrilateral = std::array<std::size_t, 4>;

// What a reader of a file finds, with numbers from 0.
struct Contents {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 8>> hexahedra;
  std::map<std::string, std::vector<Quadrilateral>> patches;
  std::map<std::string, std::set<std::size_t>> node_sets;
};

const std::map<int, std::string> names = {{1, "floor"}, {2, "ceiling"}, {3, "wall_0"}, {4, "wall_1"}};

std::string upper_case(std::string name) {
  for (char& c : name) c = char(std::toupper(c));
  return name;
}

// A ring with a patch turned inside out and a quadrilateral without label.
Hexahedra ring() {
  Hexahedra soup = ring_of_cubes();
  for (auto& facet : soup.facets)
    if (facet.label == VMP::CEILING) std::reverse(facet.vertices.begin(), facet.vertices.end());
  soup.facets.push_back({{0, 1, 2, 3}, VMP::INTERIOR});
  return soup;
}

Quadrilateral sorted(Quadrilateral q) {
  std::sort(q.begin(), q.end());
  return q;
}

// All labelled quadrilaterals are there in their order, counterclockwise seen from outside.
void check_patches(const Hexahedra& soup, const Contents& contents, bool upper) {
  std::map<std::string, std::vector<Quadrilateral>> expected;
  for (const auto& facet : soup.facets)
    if (facet.label != VMP::INTERIOR) {
      const std::string& name = names.at(facet.label);
      expected[upper ? upper_case(name) : name].push_back(sorted(facet.vertices));
    }
  assert(expected.size() == 4 && contents.patches.size() == 4);
  const Point inside(1.5, 0.5, 0.5);
  for (const auto& [name, quadrilaterals] : contents.patches) {
    assert(quadrilaterals.size() == expected.at(name).size());
    for (std::size_t k = 0; k < quadrilaterals.size(); ++k) {
      const Quadrilateral& q = quadrilaterals[k];
      assert(sorted(q) == expected.at(name)[k]);
      const Point &a = soup.points[q[0]], &b = soup.points[q[1]], &c = soup.points[q[2]];
      const CGAL::Orientation side = CGAL::orientation(a, b, c, inside);
      if (upper_case(name) == "FLOOR" || upper_case(name) == "CEILING") assert(side == CGAL::NEGATIVE);
    }
  }
}

// Gmsh: sections between $Name and $EndName.

std::istringstream section(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find("$" + name + "\n"), end = text.find("$End" + name + "\n");
  assert(begin != std::string::npos && end != std::string::npos && begin < end);
  return std::istringstream(text.substr(begin + name.size() + 2, end - begin - name.size() - 2));
}

template <typename Value>
Value next(std::istream& is) {
  Value value;
  is >> value;
  assert(is);
  return value;
}

// The names of the physical groups of surfaces and volumes, by entity.
std::map<std::array<int, 2>, std::string> read_Gmsh_groups(const std::string& text) {
  std::map<std::array<int, 2>, std::string> groups, result;
  std::istringstream is = section(text, "PhysicalNames");
  for (int n = next<int>(is); n > 0; --n) {
    const int dimension = next<int>(is), number = next<int>(is);
    const std::string name = next<std::string>(is);
    assert(name.front() == '"' && name.back() == '"');
    groups[{dimension, number}] = name.substr(1, name.size() - 2);
  }
  is = section(text, "Entities");
  assert(next<int>(is) == 0 && next<int>(is) == 0);
  const int surfaces = next<int>(is), volumes = next<int>(is);
  for (int k = 0; k < surfaces + volumes; ++k) {
    const int dimension = k < surfaces ? 2 : 3, entity = next<int>(is);
    double box[6];
    for (double& x : box) x = next<double>(is);
    for (int axis = 0; axis < 3; ++axis) assert(box[axis] <= box[axis + 3]);
    assert(next<int>(is) == 1);
    result[{dimension, entity}] = groups.at({dimension, next<int>(is)});
    for (int n = next<int>(is); n > 0; --n) assert(result.count({dimension - 1, next<int>(is)}) == 1);
  }
  return result;
}

template <std::size_t N>
std::array<std::size_t, N> read_Gmsh_element(std::istream& is) {
  std::array<std::size_t, N> vertices;
  for (std::size_t& v : vertices) v = next<std::size_t>(is) - 1;
  return vertices;
}

Contents read_Gmsh(const std::string& text) {
  Contents contents;
  assert(section(text, "MeshFormat").str() == "4.1 0 8\n");
  auto groups = read_Gmsh_groups(text);
  assert((groups.at({3, 1}) == "solid"));
  std::istringstream is = section(text, "Nodes");
  assert(next<int>(is) == 1);
  const std::size_t n = next<std::size_t>(is);
  for (std::size_t header : {std::size_t(1), n, std::size_t(3), std::size_t(1), std::size_t(0), n})
    assert(next<std::size_t>(is) == header);
  for (std::size_t k = 1; k <= n; ++k) assert(next<std::size_t>(is) == k);
  for (std::size_t k = 0; k < n; ++k) {
    const double x = next<double>(is), y = next<double>(is), z = next<double>(is);
    contents.points.emplace_back(x, y, z);
  }
  is = section(text, "Elements");
  const int blocks = next<int>(is);
  const std::size_t elements = next<std::size_t>(is);
  assert(next<std::size_t>(is) == 1 && next<std::size_t>(is) == elements);
  std::size_t last = 0;
  for (int b = 0; b < blocks; ++b) {
    const int dimension = next<int>(is), entity = next<int>(is), type = next<int>(is);
    const std::string& name = groups.at({dimension, entity});
    for (std::size_t k = next<std::size_t>(is); k > 0; --k) {
      assert(next<std::size_t>(is) == ++last);
      if (dimension == 3 && type == 5) contents.hexahedra.push_back(read_Gmsh_element<8>(is));
      if (dimension == 2 && type == 3) contents.patches[name].push_back(read_Gmsh_element<4>(is));
    }
  }
  assert(last == elements && (is >> std::ws).eof());
  return contents;
}

void test_Gmsh() {
  Hexahedra soup = ring();
  soup.points[0] = Point(-1e-300 / 3, -0.1 / 3, 1e-17 / 3);
  std::ostringstream os;
  expect(VMP::IO::write_Gmsh(os, soup), VMP::OK);
  const Contents contents = read_Gmsh(os.str());
  assert(contents.points == soup.points && contents.hexahedra == soup.hexahedra);
  check_patches(soup, contents, false);
}

// Abaqus: blocks that begin with a line *KEYWORD, KEY=VALUE, ...

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> items;
  std::istringstream is(line);
  for (std::string item; std::getline(is >> std::ws, item, ',');) items.push_back(item);
  return items;
}

// The faces of a hexahedron as the manuals of Abaqus and CalculiX number them, with vertices from 1.
constexpr std::size_t faces[6][4] = {{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2},
                                     {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}};

// These faces are clockwise seen from outside.
Quadrilateral face(const std::array<std::size_t, 8>& hexahedron, const std::string& name) {
  assert(name.size() == 2 && name[0] == 'S' && name[1] >= '1' && name[1] <= '6');
  Quadrilateral q;
  for (std::size_t i = 0; i < 4; ++i) q[i] = hexahedron[faces[name[1] - '1'][3 - i] - 1];
  return q;
}

Contents read_Abaqus(const std::string& text, const std::string& element_type) {
  Contents contents;
  std::vector<std::string> keywords;
  std::istringstream is(text);
  for (std::string line; std::getline(is, line);) {
    const std::vector<std::string> items = split(line);
    if (items[0][0] == '*') {
      keywords = items;
      continue;
    }
    const std::size_t number = std::stoul(items[0]) - 1;
    const std::string name = keywords.back().substr(keywords.back().find('=') + 1);
    if (keywords[0] == "*NODE") {
      assert(name == "SOLID" && number == contents.points.size() && items.size() == 4);
      for (const std::string& item : items) assert(item.size() <= 20);
      const auto x = [&](std::size_t i) { return std::strtod(items[i].c_str(), nullptr); };
      contents.points.emplace_back(x(1), x(2), x(3));
    } else if (keywords[0] == "*ELEMENT") {
      assert(keywords[1] == "TYPE=" + element_type && name == "SOLID" && items.size() == 9);
      assert(number == contents.hexahedra.size());
      auto& hexahedron = contents.hexahedra.emplace_back();
      for (std::size_t i = 0; i < 8; ++i) hexahedron[i] = std::stoul(items[i + 1]) - 1;
    } else if (keywords[0] == "*NSET") {
      const bool is_new = contents.node_sets[name].insert(number).second;
      assert(is_new && items.size() == 1);
    } else {
      assert(keywords[0] == "*SURFACE" && keywords[1] == "TYPE=ELEMENT" && items.size() == 2);
      contents.patches[name].push_back(face(contents.hexahedra.at(number), items[1]));
    }
  }
  return contents;
}

void test_Abaqus() {
  const Hexahedra soup = ring();
  std::ostringstream os;
  expect(VMP::IO::write_Abaqus(os, soup, "DC3D8"), VMP::OK);
  const Contents contents = read_Abaqus(os.str(), "DC3D8");
  assert(contents.points == soup.points && contents.hexahedra == soup.hexahedra);
  check_patches(soup, contents, true);
  assert(contents.node_sets.size() == contents.patches.size());
  for (const auto& [name, quadrilaterals] : contents.patches) {
    std::set<std::size_t> nodes;
    for (const Quadrilateral& q : quadrilaterals) nodes.insert(q.begin(), q.end());
    assert(contents.node_sets.at(name) == nodes);
  }
  for (const char* type : {"", "C3D8 ", "C3D8\n*STEP", "c3d8"})
    expect(VMP::IO::write_Abaqus(os, soup, type), VMP::ERROR_WRONG_PARAMETER, type);
}

// Numbers that are too long lose digits at their end, not their exponents.
void test_long_coordinates() {
  Hexahedra soup = cube_of_cubes(1);
  const double x[] = {-1. / 3e-5, -1e-5 / 3, -1e-300 / 3,
                      1e300 / 3,  -0.1 / 3,  std::numeric_limits<double>::denorm_min()};
  for (std::size_t k = 0; k < 6; ++k) soup.points[k] = Point(x[k], -x[k], 1 / x[(k + 1) % 5]);
  std::ostringstream os;
  expect(VMP::IO::write_Abaqus(os, soup), VMP::OK);
  const Contents contents = read_Abaqus(os.str(), "C3D8");
  for (std::size_t k = 0; k < 8; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const double written = contents.points[k][axis], exact = soup.points[k][axis];
      assert(std::abs(written - exact) <= 1e-12 * std::abs(exact));
    }
}

void test_VTU() {
  const Hexahedra soup = ring();
  std::ostringstream os;
  const std::vector<double> quality = VMP::scaled_jacobians(soup);
  assert(quality == std::vector<double>(8, 1));
  expect(VMP::IO::write_VTU(os, soup, {{"x", std::vector<double>(soup.points.size(), 7)}},
                            {{"quality", quality}}),
         VMP::OK);
  boost::property_tree::ptree tree;
  std::istringstream is(os.str());
  read_xml(is, tree);
  const auto& piece = tree.get_child("VTKFile.UnstructuredGrid.Piece");
  assert(piece.get<std::size_t>("<xmlattr>.NumberOfPoints") == soup.points.size());
  assert(piece.get<int>("<xmlattr>.NumberOfCells") == 8);
  std::map<std::string, std::vector<double>> arrays;
  for (const char* group : {"Points", "Cells", "PointData", "CellData"})
    for (const auto& [tag, array] : piece.get_child(group)) {
      assert(tag == "DataArray");
      std::istringstream values(array.data());
      for (double value; values >> value;) arrays[array.get<std::string>("<xmlattr>.Name")].push_back(value);
    }
  assert(arrays.at("types") == std::vector<double>(8, 12) && arrays.at("quality") == quality);
  assert(arrays.at("x").size() == soup.points.size() && arrays.at("Points").size() == 3 * soup.points.size());
  for (std::size_t h = 0; h < 8; ++h) {
    assert(arrays.at("offsets")[h] == 8. * double(h + 1));
    for (std::size_t i = 0; i < 8; ++i)
      assert(arrays.at("connectivity")[8 * h + i] == double(soup.hexahedra[h][i]));
  }
  expect(VMP::IO::write_VTU(os, soup, {}, {{"q", std::vector<double>(7)}}), VMP::ERROR_WRONG_PARAMETER,
         "for 8 cells");
}

// What Gmsh and Abaqus refuse alike, before they write anything.
void test_refused(const Hexahedra& soup, VMP::Error_code code, const std::string& culprit) {
  std::ostringstream os;
  expect(VMP::IO::write_Gmsh(os, soup), code, culprit);
  expect(VMP::IO::write_Abaqus(os, soup), code, culprit);
  assert(os.str().empty());
}

void test_refusals() {
  test_refused(Hexahedra(), VMP::ERROR_EMPTY_MESH, "no hexahedra");
  Hexahedra soup = ring();
  soup.facets[2].label = -4;
  test_refused(soup, VMP::ERROR_WRONG_PARAMETER, "quadrilateral 2 has the label -4");
  soup = ring();
  soup.facets.push_back(soup.facets[5]);
  test_refused(soup, VMP::ERROR_LABEL_NOT_ON_BOUNDARY, "quadrilateral 33");
  soup = ring();
  const auto& h = soup.hexahedra[0];
  soup.facets[3].vertices = {h[0], h[1], h[2], h[4]}; // no facet
  test_refused(soup, VMP::ERROR_LABEL_NOT_ON_BOUNDARY, "quadrilateral 3");
  soup.facets[3].vertices = {h[1], h[2], h[6], h[5]}; // between two hexahedra
  test_refused(soup, VMP::ERROR_LABEL_NOT_ON_BOUNDARY, "quadrilateral 3");
  soup = ring();
  soup.hexahedra[1][0] = soup.points.size();
  test_refused(soup, VMP::ERROR_INDEX_OUT_OF_RANGE, "hexahedron 1");
  soup = ring();
  soup.points[3] = Point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  test_refused(soup, VMP::ERROR_COORDINATE_NOT_FINITE, "vertex 3");
  std::ostringstream os;
  expect(VMP::IO::write_VTU(os, soup), VMP::ERROR_COORDINATE_NOT_FINITE, "vertex 3");
}

// Each writer of files writes what the one of streams does, or nothing.
void test_files() {
  const Temporary_folder folder("test_hexahedra_formats");
  const Hexahedra soup = ring();
  expect(VMP::IO::write_Gmsh(folder.file("a.msh"), soup), VMP::OK);
  expect(VMP::IO::write_Abaqus(folder.file("a.inp"), soup, "C3D8I"), VMP::OK);
  expect(VMP::IO::write_VTU(folder.file("a.vtu"), soup), VMP::OK);
  assert(folder.number_of_files() == 3);
  Hexahedra wrong = soup;
  wrong.facets[0].label = -1;
  expect(VMP::IO::write_Gmsh(folder.file("b.msh"), wrong), VMP::ERROR_WRONG_PARAMETER, "b.msh");
  expect(VMP::IO::write_Abaqus(folder.file("b.inp"), wrong), VMP::ERROR_WRONG_PARAMETER, "b.inp");
  for (const char* name : {"none/a.msh", "none/a.inp", "none/a.vtu"}) {
    const std::string file = folder.file(name);
    expect(VMP::IO::write_Gmsh(file, soup), VMP::ERROR_CANNOT_WRITE_FILE, name);
    expect(VMP::IO::write_Abaqus(file, soup), VMP::ERROR_CANNOT_WRITE_FILE, name);
    expect(VMP::IO::write_VTU(file, soup), VMP::ERROR_CANNOT_WRITE_FILE, name);
  }
  assert(folder.number_of_files() == 3);
}

void test_exact_kernel() {
  using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  const Hexahedra soup = ring();
  VMP::Hexahedron_soup_3<Exact_point> exact;
  for (const Point& p : soup.points) exact.points.emplace_back(p.x(), p.y(), p.z());
  exact.hexahedra = soup.hexahedra;
  exact.facets = soup.facets;
  std::ostringstream gmsh, exact_gmsh, abaqus, exact_abaqus;
  expect(VMP::IO::write_Gmsh(gmsh, soup), VMP::OK);
  expect(VMP::IO::write_Gmsh(exact_gmsh, exact), VMP::OK);
  expect(VMP::IO::write_Abaqus(abaqus, soup), VMP::OK);
  expect(VMP::IO::write_Abaqus(exact_abaqus, exact), VMP::OK);
  assert(gmsh.str() == exact_gmsh.str() && abaqus.str() == exact_abaqus.str());
}

int main() {
  test_Gmsh();
  test_Abaqus();
  test_long_coordinates();
  test_VTU();
  test_refusals();
  test_files();
  test_exact_kernel();
  return EXIT_SUCCESS;
}
