#ifndef HANDLEBODY_MPI_ARRIVALS_H
#define HANDLEBODY_MPI_ARRIVALS_H

#include "Distributed_curves.h"

#include <CGAL/Volume_mesh_parameterization/internal/Text_writer.h>
#include <CGAL/Volume_mesh_parameterization/internal/write_atomically.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

using Integral_curves = VMP::Integral_curves_3<Kernel>;
using Base_point = VMP::Base_point_3<Kernel>;

// Where a curve ends, and what it took to get there.
struct Arrival {
  Base_point end;
  double level;
  std::uint32_t cells;
};

inline bool operator==(const Arrival& a, const Arrival& b) {
  return a.end.facet == b.end.facet && a.end.barycentric == b.end.barycentric && a.level == b.level &&
         a.cells == b.cells;
}

// The centroid of every `step`-th triangle of the floor.
inline std::vector<Base_point> floor_centroids(const Mesh& mesh, std::size_t step) {
  std::vector<Base_point> result;
  std::size_t k = 0;
  for (VMP::Facet_index f : mesh.boundary_facets())
    if (mesh.label(f) == VMP::FLOOR && k++ % step == 0) result.push_back({f, {1. / 3, 1. / 3, 1. / 3}});
  return result;
}

// In the first process, of all curves.
inline std::vector<Arrival> trace_arrivals(const Integral_curves& whole, const std::vector<Base_point>& seeds,
                                           Distributed_curves& distributed) {
  std::vector<VMP::Location_3<Kernel>> starts;
  for (const Base_point& seed : seeds) starts.push_back(whole.locate(seed));
  std::vector<Arrival> result;
  for (const Distributed_curves::Curve& c : distributed.trace(starts))
    result.push_back({whole.base_point(c.at, {c.at.cell, c.arrival}), c.level, c.cells});
  return result;
}

// The same by the library, in one process.
inline VMP::Status trace_alone(const Integral_curves& curves, const Base_point& seed, Arrival& arrival) {
  auto at = curves.locate(seed);
  VMP::Half_facet facet;
  arrival.cells = 0;
  const auto count = [&](const auto&, const auto&, double) { ++arrival.cells; };
  const VMP::Status status = curves.trace(at, VMP::UP, -1., facet, arrival.level, count);
  if (status.ok()) arrival.end = curves.base_point(at, facet);
  return status;
}

// To the bit.
inline VMP::Status compare_arrivals(const Integral_curves& curves, const std::vector<Base_point>& seeds,
                                    const std::vector<Arrival>& arrivals) {
  VMP::Status status;
  for (std::size_t k = 0; k < seeds.size() && status.ok(); ++k) {
    Arrival alone;
    status = trace_alone(curves, seeds[k], alone);
    if (status.ok() && !(alone == arrivals[k]))
      status = {VMP::ERROR_CURVE_LOST,
                "triangle " + std::to_string(seeds[k].facet) + ": not as in one process"};
  }
  return status;
}

inline VMP::Status write_arrivals(const std::string& file, const std::vector<Base_point>& seeds,
                                  const std::vector<Arrival>& arrivals) {
  return VMP::internal::write_atomically(file, [&](std::ostream& os) {
    {
      VMP::internal::Text_writer out(os);
      out << "# seed facet b0 b1 b2 level cells\n";
      for (std::size_t k = 0; k < seeds.size(); ++k) {
        const Arrival& a = arrivals[k];
        out << std::uint32_t(seeds[k].facet) << ' ' << std::uint32_t(a.end.facet) << ' ';
        for (double b : a.end.barycentric) out << b << ' ';
        out << a.level << ' ' << a.cells << '\n';
      }
    }
    return VMP::internal::check_stream(os);
  });
}

#endif // HANDLEBODY_MPI_ARRIVALS_H
