// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTU_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTU_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/Data_array.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/VTK_XML_writer.h>
#include <CGAL/Volume_mesh_parameterization/internal/VTK_grid.h>
#include <CGAL/Volume_mesh_parameterization/internal/VTU_reader.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/internal/write_atomically.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <istream>
#include <iterator>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace IO {

/*!
\ingroup PkgVolumeMeshParameterizationIO

is what to write of a mesh into a VTU file. The cells of the file are the tetrahedra, then the labelled facets, then
the marked vertices and edges, as far as they are asked for.
*/
struct VTU_content {
  bool with_tetrahedra = true;              ///< whether the tetrahedra are written
  bool with_facets = true;                  ///< adds an array `label`: 0 for what is no facet
  std::vector<std::size_t> marked_vertices; ///< each becomes a cell, to be seen as a point
  std::vector<std::array<Vertex_index, 2>> marked_edges; ///< each becomes a cell, to be seen as a line
  std::vector<Data_array> point_data;       ///< arrays with a value for each vertex
  std::vector<Data_array> cell_data;        ///< arrays with a value for each cell of the file
};

} // namespace IO

namespace internal {

// Calls visit(VTK type, vertices, label) for the cells of the file in their order.
template <typename TetrahedralMesh, typename Visit>
void for_each_VTU_cell(const TetrahedralMesh& mesh, const IO::VTU_content& content, const Visit& visit) {
  if (content.with_tetrahedra)
    for (std::size_t c = 0; c < mesh.number_of_cells(); ++c) visit(VTK_TETRAHEDRON, vertex_numbers(mesh.cell(c)), 0);
  if (content.with_facets)
    for (const Labelled_facet& facet : mesh.labelled_facets())
      visit(VTK_TRIANGLE, facet.vertices, facet.label);
  for (std::size_t v : content.marked_vertices) visit(VTK_VERTEX, std::array<std::size_t, 1>{v}, 0);
  for (const auto& e : content.marked_edges) visit(VTK_LINE, std::array<std::size_t, 2>{e[0], e[1]}, 0);
}

template <typename TetrahedralMesh>
Status check_marks(const TetrahedralMesh& mesh, const IO::VTU_content& content) {
  const std::size_t n = mesh.number_of_vertices();
  for (std::size_t v : content.marked_vertices)
    if (v >= n) return {ERROR_WRONG_PARAMETER, "there is no vertex " + std::to_string(v) + " to mark"};
  for (const auto& e : content.marked_edges)
    if ((std::max)(e[0], e[1]) >= n)
      return {ERROR_WRONG_PARAMETER, "there is no vertex " + std::to_string((std::max)(e[0], e[1])) + " to mark an edge of"};
  return {};
}

template <typename TetrahedralMesh>
std::vector<IO::Data_array> with_labels(const TetrahedralMesh& mesh, const IO::VTU_content& content) {
  std::vector<IO::Data_array> arrays = content.cell_data;
  if (!content.with_facets) return arrays;
  std::vector<int> labels;
  for_each_VTU_cell(mesh, content, [&](int, const auto&, int label) { labels.push_back(label); });
  arrays.push_back({"label", std::move(labels)});
  return arrays;
}

// Writes points and cells of any kind: for_each_cell(visit) calls visit(VTK type, vertices, label) for each.
template <typename PointOf, typename ForEachCell>
class VTU_grid_writer {
public:
  VTU_grid_writer(std::size_t number_of_points, const PointOf& point_of, const ForEachCell& for_each_cell)
      : m_number_of_points(number_of_points), m_point_of(point_of), m_for_each_cell(for_each_cell) {
    m_for_each_cell([&](int, const auto&, int) { ++m_number_of_cells; });
  }

  Status write(std::ostream& os, const std::vector<IO::Data_array>& point_data,
               const std::vector<IO::Data_array>& cell_data) const {
    Status status = check_coordinates(m_number_of_points, m_point_of);
    if (status.ok()) status = check_data_arrays(point_data, m_number_of_points, "vertices");
    if (status.ok()) status = check_data_arrays(cell_data, m_number_of_cells, "cells");
    if (!status.ok()) return status;
    write_piece(os, point_data, cell_data);
    return check_stream(os);
  }

private:
  void write_piece(std::ostream& os, const std::vector<IO::Data_array>& point_data,
                   const std::vector<IO::Data_array>& cell_data) const {
    VTK_XML_writer xml(os, "UnstructuredGrid");
    xml.text() << "<Piece NumberOfPoints=\"" << m_number_of_points << "\" NumberOfCells=\"" << m_number_of_cells
               << "\">\n";
    xml.element("Points", [&] {
      xml.array("Points", "Float64", 3, [&](Text_writer& out) {
        for (std::size_t v = 0; v < m_number_of_points; ++v) xml.write_point(out, m_point_of(v));
      });
    });
    xml.element("Cells", [&] { write_cells(xml); });
    xml.data_arrays("PointData", point_data);
    xml.data_arrays("CellData", cell_data);
    xml.text() << "</Piece>\n";
  }

  void write_cells(VTK_XML_writer& xml) const {
    xml.array("connectivity", "Int64", 1, [&](Text_writer& out) {
      m_for_each_cell([&](int, const auto& vertices, int) {
        for (std::size_t v : vertices) out << v << ' ';
        out << '\n';
      });
    });
    std::size_t end = 0;
    xml.array("offsets", "Int64", 1, [&](Text_writer& out) {
      m_for_each_cell([&](int, const auto& vertices, int) { out << (end += vertices.size()) << '\n'; });
    });
    xml.array("types", "UInt8", 1, [&](Text_writer& out) {
      m_for_each_cell([&](int type, const auto&, int) { out << type << '\n'; });
    });
  }

  std::size_t m_number_of_points;
  const PointOf& m_point_of;
  const ForEachCell& m_for_each_cell;
  std::size_t m_number_of_cells = 0;
};

} // namespace internal

namespace IO {

/*!
\ingroup PkgVolumeMeshParameterizationIO

reads tetrahedra and labelled triangles from a VTU file (XML UnstructuredGrid of VTK) with arrays in ASCII.

Labels are the integers of the cell data: the array named `label`, else the first one. Without it triangles are
ignored.

\tparam Point a point type of a \cgal kernel

\returns `ERROR_CANNOT_READ_FILE`, `ERROR_WRONG_FORMAT`, `ERROR_COORDINATE_NOT_FINITE` or `ERROR_INDEX_OUT_OF_RANGE`;
then `soup` is left as it was
*/
template <typename Point>
Status read_VTU(std::istream& is, Tetrahedron_soup_3<Point>& soup) {
  std::string text;
  internal::VTK_grid grid;
  Status status = internal::read_all(is, text);
  if (status.ok()) status = internal::VTU_reader(text, grid).read();
  return status.ok() ? grid.make_soup(soup) : status;
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

reads the file `filename`, as the function above.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
Status read_VTU(const std::string& filename, Tetrahedron_soup_3<Point>& soup) {
  return internal::read_file(filename, [&](std::istream& is) { return read_VTU(is, soup); });
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes a mesh with data on it as an ASCII VTU file (XML UnstructuredGrid of VTK).

\tparam TetrahedralMesh a model of `TetrahedralMesh_3`

\returns `ERROR_COORDINATE_NOT_FINITE`, `ERROR_WRONG_PARAMETER` (the size of an array, a value that is not finite, or a
marked vertex or edge that does not exist) or `ERROR_CANNOT_WRITE_FILE`
*/
template <typename TetrahedralMesh>
Status write_VTU(std::ostream& os, const TetrahedralMesh& mesh, const VTU_content& content = {}) {
  const Status status = internal::check_marks(mesh, content);
  if (!status.ok()) return status;
  const auto point_of = [&](std::size_t v) -> decltype(auto) { return mesh.point(v); };
  const auto for_each_cell = [&](const auto& visit) { internal::for_each_VTU_cell(mesh, content, visit); };
  return internal::VTU_grid_writer(mesh.number_of_vertices(), point_of, for_each_cell)
      .write(os, content.point_data, internal::with_labels(mesh, content));
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes the file `filename`, as the function above, under a temporary name first: on failure nothing is changed.

\tparam TetrahedralMesh a model of `TetrahedralMesh_3`
*/
template <typename TetrahedralMesh>
Status write_VTU(const std::string& filename, const TetrahedralMesh& mesh, const VTU_content& content = {}) {
  return internal::write_atomically(filename, [&](std::ostream& os) { return write_VTU(os, mesh, content); });
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes hexahedra with data on their vertices and on themselves as an ASCII VTU file; their labelled facets are left out.

\tparam Point a point type of a \cgal kernel

\returns `ERROR_EMPTY_MESH`, `ERROR_INDEX_OUT_OF_RANGE`, `ERROR_COORDINATE_NOT_FINITE`, `ERROR_WRONG_PARAMETER` (the size of
an array, or a value that is not finite) or `ERROR_CANNOT_WRITE_FILE`
*/
template <typename Point>
Status write_VTU(std::ostream& os, const Hexahedron_soup_3<Point>& soup, const std::vector<Data_array>& point_data = {},
                 const std::vector<Data_array>& cell_data = {}) {
  const Status status = internal::check_hexahedra(soup);
  if (!status.ok()) return status;
  const auto point_of = [&](std::size_t v) -> const Point& { return soup.points[v]; };
  const auto for_each_cell = [&](const auto& visit) {
    for (const auto& hexahedron : soup.hexahedra) visit(internal::VTK_HEXAHEDRON, hexahedron, 0);
  };
  return internal::VTU_grid_writer(soup.points.size(), point_of, for_each_cell).write(os, point_data, cell_data);
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes the file `filename`, as the function above, under a temporary name first: on failure nothing is changed.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
Status write_VTU(const std::string& filename, const Hexahedron_soup_3<Point>& soup,
                 const std::vector<Data_array>& point_data = {}, const std::vector<Data_array>& cell_data = {}) {
  return internal::write_atomically(
      filename, [&](std::ostream& os) { return write_VTU(os, soup, point_data, cell_data); });
}

} // namespace IO
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTU_H
