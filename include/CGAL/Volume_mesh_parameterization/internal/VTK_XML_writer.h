// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTK_XML_WRITER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTK_XML_WRITER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/IO/Data_array.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_writer.h>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// `of` says in the message what has the values.
inline Status check_data_arrays(const std::vector<IO::Data_array>& arrays, std::size_t n,
                                const std::string& of) {
  for (const IO::Data_array& array : arrays) {
    const std::size_t size = std::visit([](const auto& values) { return values.size(); }, array.values);
    if (size != n)
      return {ERROR_WRONG_PARAMETER, "array " + array.name + " has " + std::to_string(size) + " values for " +
                                         std::to_string(n) + " " + of};
    if (const auto* values = std::get_if<std::vector<double>>(&array.values))
      for (std::size_t i = 0; i < n; ++i)
        if (!std::isfinite((*values)[i]))
          return {ERROR_WRONG_PARAMETER,
                  "array " + array.name + ": value " + std::to_string(i) + " is not finite"};
  }
  return {};
}

// Writes the elements of VTK's XML files, in ASCII.
class VTK_XML_writer {
public:
  VTK_XML_writer(std::ostream& os, const char* type) : m_out(os), m_type(type) {
    m_out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type
          << "\" version=\"0.1\" byte_order=\"LittleEndian\">\n<" << type << ">\n";
  }
  ~VTK_XML_writer() { m_out << "</" << m_type << ">\n</VTKFile>\n"; }

  Text_writer& text() { return m_out; }

  // write_content() writes what is inside of the element.
  template <typename Write>
  void element(const char* name, const Write& write_content) {
    m_out << '<' << name << ">\n";
    write_content();
    m_out << "</" << name << ">\n";
  }

  // write_values(Text_writer&) writes the numbers.
  template <typename Write>
  void array(const std::string& name, const char* type, int components, const Write& write_values) {
    m_out << "<DataArray type=\"" << type << "\" Name=\"" << escape(name) << "\" NumberOfComponents=\""
          << components << "\" format=\"ascii\">\n";
    write_values(m_out);
    m_out << "</DataArray>\n";
  }

  void data_arrays(const char* element_name, const std::vector<IO::Data_array>& arrays) {
    element(element_name, [&] {
      for (const IO::Data_array& a : arrays)
        std::visit([&](const auto& values) { scalars(a.name, values); }, a.values);
    });
  }

  template <typename Number>
  void scalars(const std::string& name, const std::vector<Number>& values) {
    array(name, std::is_same_v<Number, double> ? "Float64" : "Int32", 1, [&](Text_writer& out) {
      for (Number x : values) out << x << '\n';
    });
  }

  template <typename Point>
  static void write_point(Text_writer& out, const Point& p) {
    out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }

private:
  static std::string escape(const std::string& text) {
    std::string result;
    for (char c : text) {
      if (c == '&')
        result += "&amp;";
      else if (c == '<')
        result += "&lt;";
      else if (c == '"')
        result += "&quot;";
      else
        result += c;
    }
    return result;
  }

  Text_writer m_out;
  const char* m_type;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTK_XML_WRITER_H
