#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/IO/VTK.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTP.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>

#include "io_test_util.h"
#include "test_util.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <sstream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Soup = VMP::Tetrahedron_soup_3<Point>;

const std::string old_style = "# vtk DataFile Version 2.0\na title\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                              "FIELD FieldData 1\nTIME 1 1 double\n0.5\n"
                              "POINTS 4 double\n0 0 0 1 0 0\n0 1 0\n0 0 1\n"
                              "CELLS 4 14\n4 0 1 2 3\n3 0 1 2\n2 0 1\n1 3\n"
                              "CELL_TYPES 4\n10\n5\n3\n1\n"
                              "POINT_DATA 4\nVECTORS v double\n0 0 0 0 0 0 0 0 0 0 0 0\n"
                              "CELL_DATA 4\nSCALARS quality double 1\nLOOKUP_TABLE default\n1 1 1 1\n"
                              "SCALARS patch int\nLOOKUP_TABLE default\n0 7 0 0\n";

const std::string new_style = "# vtk DataFile Version 5.1\na title\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                              "POINTS 4 float\n0 0 0 1 0 0\n0 1 0\n0 0 1\n"
                              "METADATA\nINFORMATION 1\nNAME L2 LOCATION vtkDataArray\nDATA 2 0 1\n\n"
                              "CELLS 3 7\nOFFSETS vtktypeint64\n0 4 7\nCONNECTIVITY vtktypeint64\n0 1 2 3 0 1 2\n"
                              "CELL_TYPES 2\n10\n5\n"
                              "CELL_DATA 2\nFIELD FieldData 2\nother 1 2 int\n5 5\n"
                              "METADATA\nINFORMATION 0\n\nlabel 1 2 vtktypeint64\n0 7\n";

const std::string xml =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n<!-- a comment -->\n"
    "<UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"2\">\n"
    "<PointData/>\n<CellData><DataArray type=\"Float64\" Name=\"q\" format=\"ascii\">1 1</DataArray>\n"
    "<DataArray type=\"Int32\" Name=\"patch\" format=\"ascii\">0 7</DataArray></CellData>\n"
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 1"
    "</DataArray></Points>\n"
    "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 0 1 2</DataArray>\n"
    "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4 7</DataArray>\n"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">10 5</DataArray></Cells>\n"
    "</Piece></UnstructuredGrid></VTKFile>\n";

VMP::Status read(const std::string& text, Soup& soup) {
  std::istringstream is(text);
  return text[0] == '<' ? VMP::IO::read_VTU(is, soup) : VMP::IO::read_VTK(is, soup);
}

void test_reading() {
  for (const std::string& text : {old_style, new_style, xml}) {
    Soup soup;
    expect(read(text, soup), VMP::OK);
    assert(soup.points == std::vector<Point>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    assert(soup.cells.size() == 1 && soup.cells[0] == (std::array<std::size_t, 4>{0, 1, 2, 3}));
    assert(soup.facets.size() == 1 && soup.facets[0].vertices == (std::array<std::size_t, 3>{0, 1, 2}));
    assert(soup.facets[0].label == 7);
  }
  Soup soup;
  expect(read(old_style.substr(0, old_style.find("CELL_DATA")), soup), VMP::OK); // no labels, no facets
  assert(soup.cells.size() == 1 && soup.facets.empty());
}

void refuse(const std::string& text, const std::string& old_part, const std::string& new_part, VMP::Error_code code,
            const std::string& culprit) {
  Soup soup;
  expect(read(replaced(text, old_part, new_part), soup), code, culprit);
  assert(soup.points.empty() && soup.cells.empty());
}

void test_refusals_of_VTK() {
  Soup soup;
  std::istringstream empty;
  expect(VMP::IO::read_VTK(empty, soup), VMP::ERROR_WRONG_FORMAT, "does not start with '# vtk DataFile'");
  expect(VMP::IO::read_VTK(std::string("none.vtk"), soup), VMP::ERROR_CANNOT_READ_FILE, "none.vtk: No such file");
  refuse(old_style, "ASCII", "BINARY", VMP::ERROR_WRONG_FORMAT, "convert it to ASCII");
  refuse(old_style, "ASCII", "EBCDIC", VMP::ERROR_WRONG_FORMAT, "neither ASCII nor BINARY");
  refuse(old_style, "UNSTRUCTURED_GRID", "POLYDATA", VMP::ERROR_WRONG_FORMAT, "no UNSTRUCTURED_GRID");
  refuse(old_style, "VECTORS", "VICTORS", VMP::ERROR_WRONG_FORMAT, "unknown section 'VICTORS'");
  refuse(old_style, "POINTS 4", "POINTS 1000000000000000000", VMP::ERROR_WRONG_FORMAT, "section POINTS");
  refuse(old_style, "CELLS 4 14", "CELLS 4 99999999999", VMP::ERROR_WRONG_FORMAT, "section CELLS");
  refuse(old_style, "CELL_TYPES 4", "CELL_TYPES -4", VMP::ERROR_WRONG_FORMAT, "section CELL_TYPES");
  refuse(old_style, "CELL_TYPES 4\n10\n5\n3\n1", "CELL_TYPES 3\n10\n5\n3", VMP::ERROR_WRONG_FORMAT, "as many cells");
  refuse(old_style, "10\n5\n", "12\n5\n", VMP::ERROR_WRONG_FORMAT, "cell 0 has the VTK type 12");
  refuse(old_style, "10\n5\n", "10\n10\n", VMP::ERROR_WRONG_FORMAT, "cell 1 has not 4 vertices");
  refuse(old_style, "4 0 1 2 3", "4 0 1 2 4", VMP::ERROR_INDEX_OUT_OF_RANGE, "cell 0: vertex 4 of 4");
  refuse(old_style, "4 0 1 2 3", "4 0 1 2 -3", VMP::ERROR_INDEX_OUT_OF_RANGE, "cell 0: vertex -3 of 4");
  refuse(old_style, "0 0 1\n", "0 0 nan\n", VMP::ERROR_COORDINATE_NOT_FINITE, "point 3");
  refuse(old_style, "0 7 0 0", "0 7 0 x", VMP::ERROR_WRONG_FORMAT, "section SCALARS");
  refuse(old_style, "0 7 0 0", "0 7000000000 0 0", VMP::ERROR_WRONG_FORMAT, "cell 1: the label is too large");
  refuse(new_style, "0 4 7", "0 4 8", VMP::ERROR_WRONG_FORMAT, "cell 1");
  refuse(new_style, "0 4 7", "-1 4 7", VMP::ERROR_WRONG_FORMAT, "cell 0");
  refuse(new_style, "CONNECTIVITY", "CONNEXION", VMP::ERROR_WRONG_FORMAT, "section CELLS");
}

void test_refusals_of_VTU() {
  refuse(xml, "</Piece>", "", VMP::ERROR_WRONG_FORMAT, "line");
  refuse(xml, "format=\"ascii\"", "format=\"binary\"", VMP::ERROR_WRONG_FORMAT, "convert them to ASCII");
  refuse(xml, "</VTKFile>", "<AppendedData>_\1<</AppendedData></VTKFile>", VMP::ERROR_WRONG_FORMAT, "appended");
  refuse(xml, "<Piece", "<Piece/><Piece", VMP::ERROR_WRONG_FORMAT, "not one Piece");
  refuse(xml, "type=\"UnstructuredGrid\"", "type=\"PolyData\"", VMP::ERROR_WRONG_FORMAT, "no VTKFile of type");
  refuse(xml, "Name=\"offsets\"", "Name=\"onsets\"", VMP::ERROR_WRONG_FORMAT, "no array offsets");
  refuse(xml, "4 7<", "4 x<", VMP::ERROR_WRONG_FORMAT, "array offsets, value 1");
  refuse(xml, "NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"", VMP::ERROR_WRONG_FORMAT, "NumberOfPoints");
  refuse(xml, "0 7<", "0<", VMP::ERROR_WRONG_FORMAT, "as many labels as cells");
  refuse(xml, "0 0 1<", "0 0 1 1<", VMP::ERROR_WRONG_FORMAT, "three coordinates");
  std::string deep = xml.substr(0, xml.find("<!--"));
  for (int i = 0; i < 1000000; ++i) deep += "<a>";
  Soup soup;
  expect(read(deep, soup), VMP::ERROR_WRONG_FORMAT, "nested");
}

void test_truncation() {
  for (const std::string& text : {old_style, new_style, xml})
    for (std::size_t size = 1; size < text.size(); ++size) {
      Soup soup; // a legacy file has no end mark: cut between two sections it is another file
      const VMP::Status status = read(text.substr(0, size), soup);
      assert(text != xml || !status.ok() || size + 1 == text.size());
    }
}

void test_VTU_round_trip() {
  const Temporary_folder folder("test_VTK");
  Soup soup = Block_with_holes<Point>(1, 2, 2).soup(), back;
  for (Point& p : soup.points) p = Point(p.x() / 3, std::sqrt(1 + p.y()), p.z() * 1e-300);
  VMP::IO::VTU_content content;
  content.marked_vertices = {3, 5};
  std::vector<double> heights;
  for (const Point& p : soup.points) heights.push_back(p.z());
  content.point_data = {{"<f> & \"g\"", heights}};
  content.cell_data = {{"number", std::vector<int>(soup.cells.size() + soup.facets.size() + 2, 9)}};
  const std::string file = folder.file("a.vtu");
  expect(VMP::IO::write_VTU(file, soup, content), VMP::OK);
  expect(VMP::IO::read_VTU(file, back), VMP::OK);
  assert(back.points == soup.points && back.cells == soup.cells && back.facets.size() == soup.facets.size());
  for (std::size_t f = 0; f < back.facets.size(); ++f)
    assert(back.facets[f].vertices == soup.facets[f].vertices && back.facets[f].label == soup.facets[f].label);

  VMP::IO::VTU_content only_facets;
  only_facets.with_tetrahedra = false;
  expect(VMP::IO::write_VTU(file, soup, only_facets), VMP::OK);
  expect(VMP::IO::read_VTU(file, back), VMP::OK);
  assert(back.cells.empty() && back.facets.size() == soup.facets.size());

  content.marked_vertices.push_back(soup.points.size());
  expect(VMP::IO::write_VTU(file, soup, content), VMP::ERROR_WRONG_PARAMETER, "to mark");
  content.marked_vertices.pop_back();
  heights[7] = std::numeric_limits<double>::infinity();
  content.point_data = {{"f", heights}};
  expect(VMP::IO::write_VTU(file, soup, content), VMP::ERROR_WRONG_PARAMETER, "array f: value 7 is not finite");
  content.point_data = {{"f", std::vector<int>(3)}};
  expect(VMP::IO::write_VTU(file, soup, content), VMP::ERROR_WRONG_PARAMETER, "array f has 3 values for");
  soup.points[2] = Point(heights[7], 0, 0);
  expect(VMP::IO::write_VTU(file, soup), VMP::ERROR_COORDINATE_NOT_FINITE, "vertex 2");
  expect(VMP::IO::write_VTU(folder.file("none/a.vtu"), back), VMP::ERROR_CANNOT_WRITE_FILE, "none/a.vtu");
}

void test_VTP() {
  const std::vector<std::vector<Point>> curves = {{{0, 0, 0}, {.1, 0, 1}, {0, 0, 2}}, {}, {{5, 0, 0}, {5, 1e-7, 1}}};
  const VMP::IO::Data_array levels{"w", std::vector<double>{0, .5, 1, 0, 1}}, numbers{"curve", std::vector<int>{0, 1, 2}};
  std::ostringstream os;
  expect(VMP::IO::write_VTP(os, curves, {levels}, {numbers}), VMP::OK);
  boost::property_tree::ptree tree;
  std::istringstream is(os.str());
  boost::property_tree::read_xml(is, tree);
  const auto text_of = [&](const std::string& path) {
    const std::string text = tree.get<std::string>("VTKFile.PolyData.Piece." + path);
    return text.substr(1, text.size() - 2); // without the line breaks at both ends
  };
  const auto& piece = tree.get_child("VTKFile.PolyData.Piece");
  assert(piece.get<int>("<xmlattr>.NumberOfPoints") == 5 && piece.get<int>("<xmlattr>.NumberOfLines") == 3);
  assert(text_of("Points.DataArray") == "0 0 0\n0.1 0 1\n0 0 2\n5 0 0\n5 1e-07 1");
  assert(text_of("PointData.DataArray") == "0\n0.5\n1\n0\n1");
  assert(text_of("CellData.DataArray") == "0\n1\n2");
  assert(text_of("Lines.DataArray") == "0 1 2\n3 4"); // the first of the two arrays

  expect(VMP::IO::write_VTP(os, curves, {{"w", std::vector<double>{0}}}), VMP::ERROR_WRONG_PARAMETER, "for 5 points");
  expect(VMP::IO::write_VTP(os, curves, {}, {{"k", std::vector<int>{0}}}), VMP::ERROR_WRONG_PARAMETER, "3 curves");
  expect(VMP::IO::write_VTP("none/a.vtp", curves), VMP::ERROR_CANNOT_WRITE_FILE, "none/a.vtp");
  const double infinity = std::numeric_limits<double>::infinity();
  expect(VMP::IO::write_VTP(os, std::vector<std::vector<Point>>{{{infinity, 0, 0}}}), VMP::ERROR_COORDINATE_NOT_FINITE);
}

int main() {
  test_reading();
  test_refusals_of_VTK();
  test_refusals_of_VTU();
  test_truncation();
  test_VTU_round_trip();
  test_VTP();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
