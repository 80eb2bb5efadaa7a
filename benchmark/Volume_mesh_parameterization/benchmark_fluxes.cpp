// Compares, on one solid, the two fluxes that Flux_field_3 computes: time, conservation, direction, and how much of the sweep
// they agree with. Only the ratios of what one run prints count.
// usage: benchmark_fluxes [FILE], FILE a tetrahedral mesh in MEDIT format with a labelled boundary

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Timer.h>
#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/Flux_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/prepare_patches.h>
#include <CGAL/Volume_mesh_parameterization/sweep_with_repairs.h>

#include "solid_test_util.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Harmonic_function = VMP::Harmonic_function_3<Mesh>;
using Flux_field = VMP::Flux_field_3<Mesh>;
using VMP::Status;

Status load(const char* file, Mesh& mesh) {
  VMP::Tetrahedron_soup_3<Kernel::Point_3> soup = shaped_block<Kernel::Point_3>(Shape::TWISTED, 2, 6, 12);
  Status status = file ? VMP::IO::read_MEDIT(file, soup) : Status();
  VMP::Preparation counts;
  if (status.ok()) status = mesh.assign(soup);
  if (status.ok()) status = VMP::prepare_patches(mesh, counts);
  return status;
}

template <typename Function>
Status time(const char* name, const Function& function) {
  CGAL::Timer timer;
  timer.start();
  const Status status = function();
  std::printf("%-40s %12.2f seconds\n", name, timer.time());
  return status;
}

// `mesh` is a copy, since the sweep may refine it; then the signs no longer fit, and the cells it has left are named.
void judge(const char* name, Mesh mesh, const Harmonic_function& harmonic, const VMP::Dual_potential_3<Mesh>& potential,
           const Flux_field& flux) {
  VMP::Sweep_guide_3 guide(potential.values());
  for (VMP::Cell_index c : mesh.cells()) guide.signs.push_back(flux.signs(c));
  const auto give_once = [&](const Mesh& swept, VMP::Sweep_guide_3& result) {
    result = guide;
    return swept.number_of_cells() == guide.signs.size() ? Status() : Status(VMP::ERROR_SWEEP_STOPPED, "refinement is needed");
  };
  VMP::Product_structure_3<Kernel> structure;
  VMP::Sweep_report report;
  const Status status = VMP::sweep_with_repairs(mesh, give_once, structure, report);
  double volume = 0, angle = 0, volume_that_agrees = 0;
  for (VMP::Cell_index c : mesh.cells()) {
    const double v = VMP::internal::Cell_gradients(mesh, c).volume;
    const auto field = flux.vector(c), gradient = harmonic.gradient(c);
    const double cosine = field * gradient / std::sqrt(field.squared_length() * gradient.squared_length());
    volume += v;
    angle += v * std::acos(std::clamp(cosine, -1., 1.));
    if (status.ok() && flux.signs(c) == structure.signs(c)) volume_that_agrees += v;
  }
  std::printf("%-20s %12.1e %12.2f %12.2f %12zu\n", name, flux.largest_divergence(), angle / volume * 180 / CGAL_PI,
              100 * volume_that_agrees / volume, report.left_at_first);
}

Status compare(const Mesh& mesh) {
  Harmonic_function harmonic(mesh);
  VMP::Dual_potential_3<Mesh> potential(mesh);
  Flux_field equilibrated(mesh), non_conforming(mesh);
  Status status = time("harmonic function", [&] { return harmonic.solve(); });
  if (status.ok()) status = time("potential on the dual graph", [&] { return potential.solve(); });
  if (!status.ok()) return status;
  status = time("equilibrated flux", [&] {
    equilibrated.equilibrate(harmonic);
    return Status();
  });
  status = time("non-conforming flux", [&] { return non_conforming.solve(); });
  if (!status.ok()) return status;
  std::printf("\n%-20s %12s %12s %12s %12s\n", "flux", "divergence", "angle", "% as swept", "left at first");
  judge("equilibrated", mesh, harmonic, potential, equilibrated);
  judge("non-conforming", mesh, harmonic, potential, non_conforming);
  return {};
}

int main(int argc, char** argv) {
  Mesh mesh;
  Status status = load(argc > 1 ? argv[1] : nullptr, mesh);
  if (status.ok()) {
    std::printf("%s, %zu cells\n\n", argc > 1 ? argv[1] : "twisted block with two holes", mesh.number_of_cells());
    status = compare(mesh);
  }
  if (!status.ok()) std::cerr << status.message() << std::endl;
  return status.ok() ? EXIT_SUCCESS : EXIT_FAILURE;
}
