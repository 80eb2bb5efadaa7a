#include "Result_folder.h"

#include <CGAL/Volume_mesh_parameterization/internal/write_atomically.h>

#include <filesystem>
#include <fstream>
#include <limits>

namespace VMP = CGAL::Volume_mesh_parameterization;
using VMP::Status;

bool Result_folder::has(const char* name) const { return std::filesystem::exists(file(name)); }

Status Result_folder::create(const std::string& input) const {
  constexpr const char* names[] = {object, order, domain, domain_order, parameter, hexahedra, gmsh_hexahedra, abaqus_hexahedra, vtu_hexahedra, result, curves, report};
  std::error_code error;
  for (const char* name : names)
    if (std::filesystem::equivalent(file(name), input, error))
      return {VMP::ERROR_CANNOT_WRITE_FILE, file(name) + ": it is the input"};
  std::filesystem::create_directories(m_path, error);
  if (error) return {VMP::ERROR_CANNOT_WRITE_FILE, m_path + ": " + error.message()};
  for (const char* name : names) {
    std::filesystem::remove(file(name), error);
    if (error) return {VMP::ERROR_CANNOT_WRITE_FILE, file(name) + ": " + error.message()};
  }
  return write_text(report, "{}\n"); // shows now, not after the work, whether the folder can be written
}

Status Result_folder::write_text(const char* name, const std::string& text) const {
  return VMP::internal::write_atomically(file(name), [&](std::ostream& os) {
    os << text;
    return os ? Status() : Status(VMP::ERROR_CANNOT_WRITE_FILE);
  });
}

Status Result_folder::write_order(const char* name, const std::vector<VMP::Cell_index>& cells) const {
  std::string text;
  for (VMP::Cell_index c : cells) text += std::to_string(c) + '\n';
  return write_text(name, text);
}

Status read_order(const std::string& file, std::vector<VMP::Cell_index>& cells) {
  std::ifstream in(file);
  if (!in) return {VMP::ERROR_CANNOT_READ_FILE, file};
  cells.clear();
  for (long c; in >> c;) {
    if (c < 0 || c >= std::numeric_limits<std::uint32_t>::max())
      return {VMP::ERROR_INDEX_OUT_OF_RANGE, file + ": line " + std::to_string(cells.size() + 1)};
    cells.emplace_back(c);
  }
  return in.eof() ? Status() : Status(VMP::ERROR_WRONG_FORMAT, file + ": line " + std::to_string(cells.size() + 1));
}
