// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_ABAQUS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_ABAQUS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_patches.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_writer.h>
#include <CGAL/Volume_mesh_parameterization/internal/write_atomically.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

inline bool is_upper_case_or_digit(char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

inline std::string upper_case(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = char(c - 'a' + 'A');
  return text;
}

template <typename Point>
class Abaqus_writer {
public:
  Abaqus_writer(std::ostream& os, const Hexahedron_soup_3<Point>& soup, const Hexahedron_patches& patches)
      : m_out(os), m_soup(soup), m_patches(patches) {}

  void write(const std::string& element_type) {
    const std::string solid = upper_case(solid_identifier);
    m_out << "*NODE, NSET=" << solid << '\n';
    for (std::size_t v = 0; v < m_soup.points.size(); ++v) write_node(v + 1, m_soup.points[v]);
    m_out << "*ELEMENT, TYPE=" << element_type << ", ELSET=" << solid << '\n';
    for (std::size_t h = 0; h < m_soup.hexahedra.size(); ++h) write_element(h + 1, m_soup.hexahedra[h]);
    for (const auto& [label, sides] : m_patches) {
      const std::string name = upper_case(patch_identifier(label));
      write_node_set(name, sides);
      write_surface(name, sides);
    }
  }

private:
  void write_node(std::size_t number, const Point& p) {
    m_out << number;
    for (int axis = 0; axis < 3; ++axis) write_coordinate(CGAL::to_double(p[axis]));
    m_out << '\n';
  }

  // As exactly as the 20 characters allow that Abaqus and CalculiX read of a number.
  void write_coordinate(double x) {
    constexpr std::size_t most_characters = 20;
    constexpr int always_fitting_digits = 13; // besides them a sign, a point and e-308
    char text[32];
    char* end = std::to_chars(text, text + sizeof(text), x).ptr;
    if (std::size_t(end - text) > most_characters)
      end =
          std::to_chars(text, text + sizeof(text), x, std::chars_format::general, always_fitting_digits).ptr;
    m_out << ", " << std::string(text, end);
  }

  void write_element(std::size_t number, const std::array<std::size_t, 8>& vertices) {
    m_out << number;
    for (std::size_t v : vertices) m_out << ", " << v + 1;
    m_out << '\n';
  }

  void write_node_set(const std::string& name, const std::vector<Hexahedron_side>& sides) {
    std::vector<std::size_t> nodes;
    for (const Hexahedron_side& side : sides)
      nodes.insert(nodes.end(), side.vertices.begin(), side.vertices.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    m_out << "*NSET, NSET=" << name << '\n';
    for (std::size_t v : nodes) m_out << v + 1 << '\n';
  }

  void write_surface(const std::string& name, const std::vector<Hexahedron_side>& sides) {
    m_out << "*SURFACE, TYPE=ELEMENT, NAME=" << name << '\n';
    for (const Hexahedron_side& side : sides) m_out << side.hexahedron + 1 << ", S" << side.facet + 1 << '\n';
  }

  Text_writer m_out;
  const Hexahedron_soup_3<Point>& m_soup;
  const Hexahedron_patches& m_patches;
};

} // namespace internal

namespace IO {

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes hexahedra and labelled quadrilaterals as an input file of Abaqus and of <a href="http://www.calculix.de">CalculiX</a>:
the mesh only, to be included by a file with material, conditions and steps.

All nodes are in the node set `SOLID` and all hexahedra in the element set `SOLID`. For each label there is a node set and a
surface of faces of elements, both named `FLOOR`, `CEILING`, `WALL_0`, ... Nodes and hexahedra keep their order and are
counted from 1. Quadrilaterals with the label 0 are left out. A coordinate has at most 20 characters, as these programs
demand: it is exact if its digits fit, else it has 13 of them.

The function takes \f$ O(n \log n) \f$ time.

\tparam Point a point type of a \cgal kernel

\param os the stream
\param soup the hexahedra
\param element_type the name of an element with eight nodes: `C3D8` for mechanics, `DC3D8` for heat conduction, ...

\returns `ERROR_EMPTY_MESH`, `ERROR_INDEX_OUT_OF_RANGE`, `ERROR_COORDINATE_NOT_FINITE`, `ERROR_WRONG_PARAMETER` (a negative
label, or an `element_type` not of capital letters and digits), `ERROR_LABEL_NOT_ON_BOUNDARY` (also for a quadrilateral that is
labelled twice) or `ERROR_CANNOT_WRITE_FILE`
*/
template <typename Point>
Status write_Abaqus(std::ostream& os, const Hexahedron_soup_3<Point>& soup,
                    const std::string& element_type = "C3D8") {
  if (element_type.empty() ||
      !std::all_of(element_type.begin(), element_type.end(), internal::is_upper_case_or_digit))
    return {ERROR_WRONG_PARAMETER, "the element type '" + element_type + "'"};
  internal::Hexahedron_patches patches;
  const Status status = internal::find_patches(soup, patches);
  if (!status.ok()) return status;
  internal::Abaqus_writer<Point>(os, soup, patches).write(element_type);
  return internal::check_stream(os);
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes the file `filename`, as the function above, under a temporary name first: on failure nothing is changed.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
Status write_Abaqus(const std::string& filename, const Hexahedron_soup_3<Point>& soup,
                    const std::string& element_type = "C3D8") {
  return internal::write_atomically(filename,
                                    [&](std::ostream& os) { return write_Abaqus(os, soup, element_type); });
}

} // namespace IO
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_ABAQUS_H
