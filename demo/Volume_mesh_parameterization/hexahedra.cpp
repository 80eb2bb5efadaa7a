#include "hexahedra.h"

#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_inverse_3.h>
#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>
#include <CGAL/Volume_mesh_parameterization/measure_hexahedral_fit.h>
#include <CGAL/Volume_mesh_parameterization/optimize_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/pillow_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#include <CGAL/centroid.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

using VMP::Status;
using Hexahedra = VMP::Hexahedron_soup_3<Point_3>;
using Tag = CGAL::Parallel_if_available_tag;

namespace {

VMP::Prism_grid choose_grid(const Hexahedra_options& options, const VMP::Prism_3<Kernel>& prism, const Mesh& solid) {
  const std::vector<double> volumes = VMP::measure_volumes(solid, solid.points());
  const double volume = std::accumulate(volumes.begin(), volumes.end(), 0.);
  VMP::Prism_grid grid;
  if (options.cells) {
    const auto& n = *options.cells;
    grid = VMP::prism_grid(prism, {prism.outer().width() / double(n[0]), prism.outer().height() / double(n[1]), prism.height() / double(n[2])});
  } else {
    const double number = options.edge > 0 ? volume / std::pow(options.edge, 3) : double(options.number);
    grid = VMP::prism_grid_of_size(prism, std::size_t(std::ceil(number)), options.has_pillow && options.edge <= 0);
  }
  grid.levels = VMP::graded_levels(grid.layers(), options.grading);
  return grid;
}

Status extract_along_curves(const Prism_parameterizer& solid, const VMP::Prism_grid& grid, Hexahedra& hexahedra) {
  const auto column = [&](const auto& foot, const std::vector<double>& levels, std::vector<Point_3>& points) {
    return solid.product_map()->column(foot, levels, points);
  };
  return VMP::hexahedral_mesh<Tag>(solid.floor_map()->domain(), grid, column, hexahedra);
}

Status extract_linearly(const Mesh& solid, const VMP::Prism_3<Kernel>& prism, const std::vector<Point_3>& images,
                        const VMP::Prism_grid& grid, Hexahedra& hexahedra) {
  VMP::Piecewise_linear_inverse_3<Kernel> inverse;
  const Status status = inverse.build(solid, images);
  const auto column = [&](const auto& foot, const std::vector<double>& levels, std::vector<Point_3>& points) {
    return inverse.column(foot, prism.height(), levels, points);
  };
  return status.ok() ? VMP::hexahedral_mesh<Tag>(prism, grid, column, hexahedra) : status;
}

// The mesh with fewer inverted hexahedra, or with better ones.
Status extract(const Prism_parameterizer& solid, const VMP::Piecewise_linear_map_3<Kernel>& linear_map, const VMP::Prism_grid& grid, Hexahedra& hexahedra) {
  Status status = extract_along_curves(solid, grid, hexahedra);
  if (!status.ok() || !linear_map.is_valid()) return status;
  Hexahedra others;
  status = extract_linearly(linear_map.mesh(), solid.floor_map()->domain(), linear_map.images(), grid, others);
  if (!status.ok()) return status;
  const auto badness = [](const Hexahedra& h) {
    const VMP::Hexahedra_report report = VMP::verify_hexahedra(h);
    return std::make_pair(report.inverted, -report.mean_scaled_jacobian);
  };
  if (badness(others) < badness(hexahedra)) hexahedra = std::move(others);
  return status;
}

// A pillow makes good corners possible along smooth rims, where these need not be kept.
VMP::Hexahedra_optimization optimization(bool has_pillow) {
  VMP::Hexahedra_optimization result;
  result.slides_over_smooth_rims = has_pillow;
  return result;
}

Json report_fit(const VMP::Hexahedral_fit& fit) {
  return {{"mean_edge_of_boundary", fit.edge},
          {"distance_to_solid", fit.distance_to_solid},
          {"distance_from_solid", fit.distance_from_solid},
          {"greatest_distance_by_mean_edge", (std::max)(fit.distance_to_solid, fit.distance_from_solid) / fit.edge},
          {"volume", fit.volume},
          {"volume_of_solid", fit.solid_volume}};
}

// The number of hexahedra with a scaled Jacobian in each twentieth from 0 to 1; what is less than 0 counts as 0.
Json report_histogram(const std::vector<double>& qualities) {
  constexpr int bars = 20;
  std::vector<std::size_t> counts(bars, 0);
  for (double q : qualities) ++counts[std::size_t((std::max)(0, (std::min)(bars - 1, int(std::floor(q * bars)))))];
  return counts;
}

Json report_worst(const Hexahedra& hexahedra, const std::vector<double>& qualities) {
  constexpr std::size_t most = 10;
  std::vector<std::size_t> numbers(qualities.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  const std::size_t n = (std::min)(most, numbers.size());
  std::partial_sort(numbers.begin(), numbers.begin() + std::ptrdiff_t(n), numbers.end(),
                    [&](std::size_t a, std::size_t b) { return std::make_pair(qualities[a], a) < std::make_pair(qualities[b], b); });
  Json worst = Json::array();
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<Point_3> corners;
    for (std::size_t v : hexahedra.hexahedra[numbers[k]]) corners.push_back(hexahedra.points[v]);
    const Point_3 centre = CGAL::centroid(corners.begin(), corners.end());
    worst.push_back({{"hexahedron", numbers[k]}, {"scaled_jacobian", qualities[numbers[k]]}, {"centre", {centre.x(), centre.y(), centre.z()}}});
  }
  return worst;
}

Status improve(const Hexahedra_options& options, const Mesh& solid, Json& report, Hexahedra& hexahedra) {
  Status status = options.has_pillow ? VMP::pillow_hexahedra(hexahedra) : Status();
  if (!status.ok()) return status;
  report["hexahedra_before_optimization"] = report_hexahedra(VMP::verify_hexahedra(hexahedra), hexahedra.hexahedra.size(), options.has_pillow);
  status = VMP::optimize_hexahedra<Tag>(solid, hexahedra, optimization(options.has_pillow));
  if (!status.ok()) return status;
  const VMP::Hexahedra_report quality = VMP::verify_hexahedra(hexahedra);
  const std::vector<double> scaled_jacobians = VMP::scaled_jacobians(hexahedra);
  Json& result = report["hexahedra"] = report_hexahedra(quality, hexahedra.hexahedra.size(), options.has_pillow);
  result["fit"] = report_fit(VMP::measure_hexahedral_fit(solid, hexahedra));
  result["scaled_jacobian_in_twentieths"] = report_histogram(scaled_jacobians);
  result["worst"] = report_worst(hexahedra, scaled_jacobians);
  return quality.status;
}

} // namespace

Status make_hexahedra(const Hexahedra_options& options, const Prism_parameterizer& solid,
                      const VMP::Piecewise_linear_map_3<Kernel>& linear_map, Json& report,
                      Hexahedra& hexahedra) {
  const VMP::Prism_grid grid = choose_grid(options, solid.floor_map()->domain(), solid.mesh());
  const Status status = extract(solid, linear_map, grid, hexahedra);
  return status.ok() ? improve(options, solid.mesh(), report, hexahedra) : status;
}

Status make_hexahedra(const Hexahedra_options& options, const Mesh& solid, const VMP::Prism_3<Kernel>& prism,
                      const std::vector<Point_3>& images, Json& report, Hexahedra& hexahedra) {
  const Status status = extract_linearly(solid, prism, images, choose_grid(options, prism, solid), hexahedra);
  return status.ok() ? improve(options, solid, report, hexahedra) : status;
}
