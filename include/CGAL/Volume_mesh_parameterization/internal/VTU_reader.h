// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTU_READER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTU_READER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/VTK_grid.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Reads the XML form of an unstructured grid with its arrays in ASCII.
class VTU_reader {
public:
  VTU_reader(const std::string& text, VTK_grid& grid) : m_text(text), m_grid(grid) {}

  Status read() {
    if (is_encoded())
      return {ERROR_WRONG_FORMAT, "its arrays are binary or appended: convert them to ASCII, in ParaView by "
                                  "File > Save Data with data mode Ascii"};
    if (depth_exceeds(32)) return {ERROR_WRONG_FORMAT, "its elements are nested too deeply"};
    Tree tree;
    try {
      std::istringstream is(m_text);
      boost::property_tree::read_xml(is, tree);
    } catch (const boost::property_tree::xml_parser_error& error) {
      return {ERROR_WRONG_FORMAT, "line " + std::to_string(error.line()) + ": " + error.message()};
    }
    return read_file(tree);
  }

private:
  using Tree = boost::property_tree::ptree;

  // Asked before parsing, as raw appended data are no XML.
  bool is_encoded() const {
    return m_text.find("<AppendedData") != std::string::npos ||
           m_text.find("format=\"binary\"") != std::string::npos ||
           m_text.find("format=\"appended\"") != std::string::npos;
  }

  // The parser is recursive: a hostile file must not exhaust the stack.
  bool depth_exceeds(int limit) const {
    int depth = 0;
    for (std::size_t i = m_text.find('<'); i != std::string::npos && depth <= limit;
         i = m_text.find('<', i + 1)) {
      const std::size_t end = m_text.find('>', i);
      if (end == std::string::npos) break;
      if (m_text[i + 1] == '/')
        --depth;
      else if (m_text[i + 1] != '?' && m_text[i + 1] != '!' && m_text[end - 1] != '/')
        ++depth;
    }
    return depth > limit;
  }

  static std::string attribute(const Tree& element, const std::string& name) {
    return element.get<std::string>("<xmlattr>." + name, "");
  }

  Status read_file(const Tree& tree) {
    const auto file = tree.get_child_optional("VTKFile");
    const auto grid = tree.get_child_optional("VTKFile.UnstructuredGrid");
    if (!file || attribute(*file, "type") != "UnstructuredGrid" || !grid)
      return {ERROR_WRONG_FORMAT, "it is no VTKFile of type UnstructuredGrid"};
    if (grid->count("Piece") != 1)
      return {ERROR_WRONG_FORMAT, "it has not one Piece: merge the pieces first"};
    return read_piece(grid->get_child("Piece"));
  }

  Status read_piece(const Tree& piece) {
    const Tree none;
    const Tree& cells = piece.get_child("Cells", none);
    Status status = read_array(find_array(piece.get_child("Points", none), ""), "Points", m_grid.coordinates);
    if (status.ok())
      status = read_array(find_array(cells, "connectivity"), "connectivity", m_grid.connectivity);
    if (status.ok()) status = read_array(find_array(cells, "offsets"), "offsets", m_grid.offsets);
    if (status.ok()) status = read_array(find_array(cells, "types"), "types", m_grid.types);
    if (status.ok()) status = read_labels(piece.get_child("CellData", none));
    m_grid.offsets.insert(m_grid.offsets.begin(), 0);
    if (status.ok() && (attribute(piece, "NumberOfPoints") != std::to_string(m_grid.number_of_points()) ||
                        attribute(piece, "NumberOfCells") != std::to_string(m_grid.types.size())))
      return {ERROR_WRONG_FORMAT, "NumberOfPoints or NumberOfCells is not what the arrays hold"};
    return status;
  }

  // Any name is found by an empty one.
  static const Tree* find_array(const Tree& parent, const std::string& name) {
    for (const auto& child : parent)
      if (child.first == "DataArray" && (name.empty() || attribute(child.second, "Name") == name))
        return &child.second;
    return nullptr;
  }

  template <typename Number>
  static Status read_array(const Tree* array, const std::string& name, std::vector<Number>& values) {
    if (array == nullptr) return {ERROR_WRONG_FORMAT, "there is no array " + name};
    Text_scanner scanner(array->data());
    while (!scanner.at_end()) {
      Number x;
      if (!scanner.read(x))
        return {ERROR_WRONG_FORMAT,
                "array " + name + ", value " + std::to_string(values.size()) + ": not a number"};
      values.push_back(x);
    }
    return {};
  }

  Status read_labels(const Tree& cell_data) {
    for (const auto& child : cell_data) {
      if (child.first != "DataArray" || attribute(child.second, "type").find("Int") == std::string::npos)
        continue;
      const std::string name = attribute(child.second, "Name"),
                        components = attribute(child.second, "NumberOfComponents");
      if (components != "" && components != "1") continue;
      std::vector<std::int64_t> values;
      const Status status = read_array(&child.second, name, values);
      if (!status.ok()) return status;
      m_grid.offer_labels(name, std::move(values));
    }
    return {};
  }

  const std::string& m_text;
  VTK_grid& m_grid;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTU_READER_H
