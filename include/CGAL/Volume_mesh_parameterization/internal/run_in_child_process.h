// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RUN_IN_CHILD_PROCESS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RUN_IN_CHILD_PROCESS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#define CGAL_VOLUME_MESH_PARAMETERIZATION_HAS_FORK
#endif

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Turns arrays into bytes, to be read again by the same program.
class Byte_writer {
public:
  template <typename T>
  Byte_writer& operator<<(const std::vector<T>& values) {
    const std::size_t n = values.size();
    m_bytes.append(reinterpret_cast<const char*>(&n), sizeof(n));
    m_bytes.append(reinterpret_cast<const char*>(values.data()), n * sizeof(T));
    return *this;
  }
  const std::string& bytes() const { return m_bytes; }

private:
  std::string m_bytes;
};

class Byte_reader {
public:
  explicit Byte_reader(const std::string& bytes) : m_next(bytes.data()) {}

  template <typename T>
  Byte_reader& operator>>(std::vector<T>& values) {
    std::size_t n;
    take(&n, sizeof(n));
    values.resize(n);
    take(values.data(), n * sizeof(T));
    return *this;
  }

private:
  void take(void* target, std::size_t size) {
    if (size > 0) std::memcpy(target, m_next, size);
    m_next += size;
  }
  const char* m_next;
};

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_HAS_FORK

inline bool write_all(int file, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(file, bytes.data() + done, bytes.size() - done);
    if (n > 0)
      done += std::size_t(n);
    else if (errno != EINTR)
      return false;
  }
  return true;
}

inline std::string read_all(int file) {
  std::string bytes;
  char block[1 << 16];
  for (;;) {
    const ssize_t n = ::read(file, block, sizeof(block));
    if (n > 0)
      bytes.append(block, std::size_t(n));
    else if (n == 0 || errno != EINTR)
      return bytes;
  }
}

template <typename Work>
[[noreturn]] void be_child(int file, const Work& work) {
  const int nowhere = ::open("/dev/null", O_WRONLY); // messages of a crash are nothing for the user
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  try {
    Byte_writer writer;
    work(writer);
    ::_exit(write_all(file, writer.bytes()) ? 0 : 1);
  } catch (...) {
    ::_exit(1);
  }
}

inline bool has_succeeded(pid_t child) {
  int result = 0;
  while (::waitpid(child, &result, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(result) && WEXITSTATUS(result) == 0;
}

// Calls work(Byte_writer&) in a copy of this process and receive(Byte_reader&) here; returns false if the copy crashed
// or could not be made.
template <typename Work, typename Receive>
bool run_in_child_process(const Work& work, const Receive& receive) {
  int pipe_ends[2];
  if (::pipe(pipe_ends) != 0) return false;
  const pid_t child = ::fork();
  if (child == 0) be_child(pipe_ends[1], work);
  ::close(pipe_ends[1]);
  const std::string bytes = child > 0 ? read_all(pipe_ends[0]) : std::string();
  ::close(pipe_ends[0]);
  if (child < 0 || !has_succeeded(child)) return false;
  Byte_reader reader(bytes);
  receive(reader);
  return true;
}

#else

template <typename Work, typename Receive>
bool run_in_child_process(const Work& work, const Receive& receive) {
  Byte_writer writer;
  work(writer);
  Byte_reader reader(writer.bytes());
  receive(reader);
  return true;
}

#endif

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RUN_IN_CHILD_PROCESS_H
