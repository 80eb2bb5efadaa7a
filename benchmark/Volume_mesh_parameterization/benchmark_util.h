#ifndef BENCHMARK_UTIL_H
#define BENCHMARK_UTIL_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Memory_sizer.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Timer.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <fstream>
#include <functional>
#include <string>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point_3>;
using Json = nlohmann::ordered_json;

// The greatest number of bytes that were resident since the last call of reset(): Linux counts them. Elsewhere it is the
// number that is resident now.
class Peak_memory {
public:
  static void reset() { std::ofstream("/proc/self/clear_refs") << "5"; }

  static std::size_t bytes() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
      if (word == "VmHWM:" && status >> word) return 1024 * std::stoul(word);
    return CGAL::Memory_sizer().resident_size();
  }
};

// CPU seconds of all threads, seconds that passed, and bytes at the peak, from the constructor on.
class Meter {
public:
  Meter() {
    Peak_memory::reset();
    m_cpu.start();
    m_wall.start();
  }

  Json measurement() const {
    return {{"cpu_seconds", m_cpu.time()}, {"seconds", m_wall.time()}, {"peak_bytes", Peak_memory::bytes()}};
  }

private:
  CGAL::Timer m_cpu;
  CGAL::Real_timer m_wall;
};

inline Json measure(const std::function<void()>& work) {
  const Meter meter;
  work();
  return meter.measurement();
}

// Reads a solid, and leaves no free memory that would be counted.
inline VMP::Status read_solid(const std::string& file, Soup& soup) {
  VMP::Status status = VMP::IO::read_MEDIT(file, soup);
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  return status;
}

#endif // BENCHMARK_UTIL_H
