// Measures how far points end up from where they began after the map to the prism and its inverse: with doubles, where
// the map's distortion magnifies rounding, and with rational numbers, where they must come back exactly.
// usage: benchmark_round_trips DIR..., each DIR a result of `handlebody parameterize FILE -o DIR`

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Product_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Weighted_statistics.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "solid_test_util.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using VMP::Status;

// The map of a result, computed again from its mesh and its order. The parts refer to each other.
template <typename Kernel>
class Result {
  using FT = typename Kernel::FT;
  using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
  using Location = VMP::Location_3<Kernel>;

public:
  Result() = default;
  Result(const Result&) = delete;
  Result& operator=(const Result&) = delete;

  Status build(const std::string& folder) {
    std::vector<VMP::Cell_index> order;
    Status status = read_mesh(folder + "/object.mesh");
    if (status.ok()) status = read_order(folder + "/order.txt", order);
    if (status.ok()) status = verify_product(m_mesh, order);
    if (status.ok()) status = choose_curves({m_mesh, order});
    if (status.ok()) status = m_floor_map.build(m_mesh);
    if (status.ok()) m_map.emplace(VMP::Integral_curves_3<Kernel>(m_mesh, m_field), m_floor_map);
    return status;
  }

  std::size_t number_of_cells() const { return m_mesh.number_of_cells(); }

  // Of the bounding box.
  double diameter() const {
    CGAL::Bbox_3 box;
    for (VMP::Vertex_index v : m_mesh.vertices()) box += m_mesh.point(v).bbox();
    return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  }

  // Calls `visit` with n points and with what the map and its inverse make of them. Every second point is inside of a
  // tetrahedron, the others may be on its facets, edges and vertices.
  template <typename Visit>
  Status for_each_round_trip(std::size_t n, const Visit& visit) const {
    Random random(1);
    for (std::size_t k = 0; k < n; ++k) {
      const unsigned vertices = k % 2 ? 15 : 1 + unsigned(random.below(15));
      const VMP::Cell_index cell(random.below(m_mesh.number_of_cells()));
      const Location start{cell, random.weights<FT, 4>(vertices)};
      typename Kernel::Point_3 image;
      Location end;
      Status status = m_map->image(start, image);
      if (status.ok()) status = m_map->preimage(image, end);
      if (!status.ok()) return status;
      visit(start.point(m_mesh), end.point(m_mesh));
    }
    return {};
  }

private:
  Status read_mesh(const std::string& file) {
    VMP::Tetrahedron_soup_3<typename Kernel::Point_3> soup;
    VMP::Boundary_partition_3 summary;
    Status status = VMP::IO::read_MEDIT(file, soup);
    if (status.ok()) status = m_mesh.assign(soup);
    if (status.ok()) status = check_tetrahedral_mesh(m_mesh);
    if (status.ok()) status = validate_partition(m_mesh, summary);
    return status;
  }

  // What is no index ends the order, which then is too short to be verified.
  static Status read_order(const std::string& file, std::vector<VMP::Cell_index>& order) {
    std::ifstream in(file);
    for (std::uint32_t c; in >> c;) order.emplace_back(c);
    return order.empty() ? Status(VMP::ERROR_CANNOT_READ_FILE, file) : Status();
  }

  Status choose_curves(const VMP::Product_structure_3<Kernel>& structure) {
    VMP::Harmonic_function_3<Mesh> harmonic(m_mesh);
    VMP::Flux_field_3<Mesh> flux(m_mesh);
    Status status = harmonic.solve();
    if (status.ok()) status = flux.solve();
    if (status.ok()) m_field = {m_mesh, structure, flux, harmonic};
    return status;
  }

  Mesh m_mesh;
  VMP::Curve_field_3<Kernel> m_field;
  VMP::Floor_map_2<Kernel> m_floor_map;
  std::optional<VMP::Product_map_3<Kernel>> m_map;
};

// Prints one line for one result.
Status measure(const char* folder) {
  constexpr std::size_t number_of_points = 100000, number_of_exact_points = 1000;
  Result<Inexact> inexact;
  Result<Exact> exact;
  std::vector<double> distances;
  std::size_t equal = 0;
  Status status = inexact.build(folder);
  if (status.ok())
    status = inexact.for_each_round_trip(number_of_points, [&](const auto& p, const auto& q) {
      distances.push_back(std::sqrt(CGAL::squared_distance(p, q)));
    });
  if (status.ok()) status = exact.build(folder);
  if (status.ok())
    status = exact.for_each_round_trip(number_of_exact_points,
                                       [&](const auto& p, const auto& q) { equal += p == q; });
  if (!status.ok()) return status;
  const VMP::Weighted_statistics statistics(distances, std::vector<double>(distances.size(), 1));
  const double diameter = inexact.diameter();
  std::printf("%-40s %10zu %10.1e %10.1e %10.1e %7zu of %zu\n", folder, inexact.number_of_cells(),
              statistics.median() / diameter, statistics.quantile(0.999) / diameter,
              statistics.maximum() / diameter, equal, number_of_exact_points);
  return status;
}

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: benchmark_round_trips DIR..." << std::endl;
    return EXIT_FAILURE;
  }
  std::printf("%-40s %10s %10s %10s %10s %15s\n", "distance / diameter", "tetrahedra", "median", "99.9 %",
              "largest", "rational: equal");
  for (int i = 1; i < argc; ++i) {
    const Status status = measure(argv[i]);
    if (status.ok()) continue;
    std::cerr << argv[i] << ": " << status.message() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
