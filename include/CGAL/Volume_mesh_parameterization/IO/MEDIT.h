// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/MEDIT_reader.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_writer.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>
#include <CGAL/Volume_mesh_parameterization/internal/write_atomically.h>

#include <iterator>
#include <istream>
#include <ostream>
#include <string>
#include <utility>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {

template <typename Names, typename Soup>
Status read_MEDIT(std::istream& is, Soup& soup) {
  std::string text;
  Status status = read_all(is, text);
  if (!status.ok()) return status;
  Soup result;
  status = MEDIT_reader<Names, Soup>(text, result).read();
  if (status.ok()) soup = std::move(result);
  return status;
}

template <typename PointOf>
void write_MEDIT_points(Text_writer& out, std::size_t n, const PointOf& point_of) {
  out << "MeshVersionFormatted 2\nDimension 3\n\nVertices\n" << n << '\n';
  for (std::size_t v = 0; v < n; ++v) {
    const auto& p = point_of(v);
    out << p.x() << ' ' << p.y() << ' ' << p.z() << " 0\n";
  }
}

template <typename Vertices>
void write_MEDIT_element(Text_writer& out, const Vertices& vertices, int reference) {
  for (std::size_t v : vertices) out << v + 1 << ' ';
  out << reference << '\n';
}

template <typename Facets>
void write_MEDIT_facets(Text_writer& out, const char* section, const Facets& facets) {
  out << '\n' << section << '\n' << std::size_t(std::distance(std::begin(facets), std::end(facets))) << '\n';
  for (const auto& facet : facets) write_MEDIT_element(out, facet.vertices, facet.label);
  out << "\nEnd\n";
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgVolumeMeshParameterizationIO

reads tetrahedra and labelled triangles from an ASCII MEDIT file in linear time.

References of triangles are their labels; those of vertices and tetrahedra are ignored, and so are other sections of
MEDIT, except volume elements of another kind.

\tparam Point a point type of a \cgal kernel

\returns `ERROR_CANNOT_READ_FILE`, `ERROR_WRONG_FORMAT`, `ERROR_COORDINATE_NOT_FINITE` or `ERROR_INDEX_OUT_OF_RANGE`,
naming section and entry, counted from 1 as in the file; then `soup` is left as it was
*/
template <typename Point>
Status read_MEDIT(std::istream& is, Tetrahedron_soup_3<Point>& soup) {
  return internal::read_MEDIT<internal::MEDIT_tetrahedra>(is, soup);
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

reads hexahedra and labelled quadrilaterals from an ASCII MEDIT file, as the function above.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
Status read_MEDIT(std::istream& is, Hexahedron_soup_3<Point>& soup) {
  return internal::read_MEDIT<internal::MEDIT_hexahedra>(is, soup);
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

reads the file `filename`, as the functions above.

\tparam Soup `Tetrahedron_soup_3` or `Hexahedron_soup_3`
*/
template <typename Soup>
Status read_MEDIT(const std::string& filename, Soup& soup) {
  return internal::read_file(filename, [&](std::istream& is) { return read_MEDIT(is, soup); });
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes tetrahedra and labelled triangles as an ASCII MEDIT file. Coordinates of type `double` are read back to the bit.

\tparam TetrahedralMesh a model of `TetrahedralMesh_3`

\returns `ERROR_COORDINATE_NOT_FINITE` or `ERROR_CANNOT_WRITE_FILE`
*/
template <typename TetrahedralMesh>
Status write_MEDIT(std::ostream& os, const TetrahedralMesh& mesh) {
  const auto point_of = [&](std::size_t v) -> decltype(auto) { return mesh.point(v); };
  const Status status = internal::check_coordinates(mesh.number_of_vertices(), point_of);
  if (!status.ok()) return status;
  {
    internal::Text_writer out(os);
    internal::write_MEDIT_points(out, mesh.number_of_vertices(), point_of);
    out << "\nTetrahedra\n" << mesh.number_of_cells() << '\n';
    for (std::size_t c = 0; c < mesh.number_of_cells(); ++c)
      internal::write_MEDIT_element(out, internal::vertex_numbers(mesh.cell(c)), 0);
    internal::write_MEDIT_facets(out, "Triangles", mesh.labelled_facets());
  }
  return internal::check_stream(os);
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes hexahedra and labelled quadrilaterals as an ASCII MEDIT file.

\tparam Point a point type of a \cgal kernel

\returns `ERROR_COORDINATE_NOT_FINITE` or `ERROR_CANNOT_WRITE_FILE`
*/
template <typename Point>
Status write_MEDIT(std::ostream& os, const Hexahedron_soup_3<Point>& soup) {
  const auto point_of = [&](std::size_t v) -> const Point& { return soup.points[v]; };
  const Status status = internal::check_coordinates(soup.points.size(), point_of);
  if (!status.ok()) return status;
  {
    internal::Text_writer out(os);
    internal::write_MEDIT_points(out, soup.points.size(), point_of);
    out << "\nHexahedra\n" << soup.hexahedra.size() << '\n';
    for (const auto& hexahedron : soup.hexahedra) internal::write_MEDIT_element(out, hexahedron, 0);
    internal::write_MEDIT_facets(out, "Quadrilaterals", soup.facets);
  }
  return internal::check_stream(os);
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes the file `filename`, as the functions above, under a temporary name first: on failure nothing is changed.

\tparam Mesh a model of `TetrahedralMesh_3`, or `Hexahedron_soup_3`
*/
template <typename Mesh>
Status write_MEDIT(const std::string& filename, const Mesh& mesh) {
  return internal::write_atomically(filename, [&](std::ostream& os) { return write_MEDIT(os, mesh); });
}

} // namespace IO
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_MEDIT_H
