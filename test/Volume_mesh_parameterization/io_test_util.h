#ifndef VOLUME_MESH_PARAMETERIZATION_IO_TEST_UTIL_H
#define VOLUME_MESH_PARAMETERIZATION_IO_TEST_UTIL_H

#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <cassert>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

// Asserts that the status is `code` and that its message contains `culprit`.
inline void expect(const CGAL::Volume_mesh_parameterization::Status& status,
                   CGAL::Volume_mesh_parameterization::Error_code code, const std::string& culprit = "") {
  const bool as_expected = status.code() == code && status.message().find(culprit) != std::string::npos;
  if (!as_expected) std::cerr << "expected '" << culprit << "', got '" << status.message() << "'" << std::endl;
  assert(as_expected);
}

inline std::string replaced(std::string text, const std::string& old_part, const std::string& new_part) {
  const std::size_t position = text.find(old_part);
  assert(position != std::string::npos);
  return text.replace(position, old_part.size(), new_part);
}

inline void write_text(const std::string& filename, const std::string& text) {
  std::ofstream(filename, std::ios::binary) << text;
}

// A folder of its own for a test, removed at the end.
class Temporary_folder {
public:
  explicit Temporary_folder(const std::string& name) : m_path(std::filesystem::absolute("folder_of_" + name)) {
    std::filesystem::remove_all(m_path);
    std::filesystem::create_directory(m_path);
  }
  ~Temporary_folder() { std::filesystem::remove_all(m_path); }

  std::string file(const std::string& name) const { return (m_path / name).string(); }
  std::size_t number_of_files() const {
    return std::size_t(std::distance(std::filesystem::directory_iterator(m_path), {}));
  }

private:
  std::filesystem::path m_path;
};

#endif // VOLUME_MESH_PARAMETERIZATION_IO_TEST_UTIL_H
