// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_WRITE_ATOMICALLY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_WRITE_ATOMICALLY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <system_error>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

inline std::string reason(int error_number) { return std::generic_category().message(error_number); }

inline Status cannot_write(const std::string& filename, const std::string& why) {
  return {ERROR_CANNOT_WRITE_FILE, filename + ": " + why};
}

// Creates an empty file beside `path` under a name that nobody else has; the name is empty if it cannot.
inline std::string create_temporary_beside(const std::filesystem::path& path) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const std::string name = path.string() + ".part" + std::to_string(attempt);
    if (std::FILE* file = std::fopen(name.c_str(), "wx")) {
      std::fclose(file);
      return name;
    }
    if (errno != EEXIST) break;
  }
  return {};
}

template <typename Write>
Status write_directly(const std::string& name, const std::string& shown_name, const Write& write) {
  errno = 0;
  std::ofstream os(name, std::ios::binary);
  if (!os) return cannot_write(shown_name, reason(errno));
  const Status status = write(os);
  if (!status.ok()) return {status.code(), shown_name + ": " + status.detail()};
  os.close();
  return os ? Status() : cannot_write(shown_name, reason(errno));
}

// Calls write(std::ostream&), which returns a `Status`, on a temporary file and gives it its name when it is complete:
// nobody ever finds half a file under `filename`, and what was there before survives a failure.
template <typename Write>
Status write_atomically(const std::string& filename, const Write& write) {
  std::error_code error;
  const bool exists = std::filesystem::exists(filename, error);
  if (exists &&
      !std::filesystem::is_regular_file(filename, error)) // a terminal or a pipe is not to be replaced
    return write_directly(filename, filename, write);
  const std::filesystem::path target =
      exists ? std::filesystem::canonical(filename, error) // keeps a symbolic link
             : std::filesystem::path(filename);
  const std::string temporary = create_temporary_beside(target);
  if (temporary.empty()) return cannot_write(filename, reason(errno));
  Status status = write_directly(temporary, filename, write);
  if (status.ok()) {
    std::filesystem::rename(temporary, target, error);
    if (error) status = cannot_write(filename, error.message());
  }
  if (!status.ok()) std::filesystem::remove(temporary, error);
  return status;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_WRITE_ATOMICALLY_H
