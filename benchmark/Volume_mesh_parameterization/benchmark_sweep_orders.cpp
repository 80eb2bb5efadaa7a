// Compares, on one solid, the orders in which a sweep may take the cells, and the curves of Xia et al. 2010 with those of
// the sweep. Only the ratios of what one run prints count.
// usage: benchmark_sweep_orders [FILE], FILE a tetrahedral mesh in MEDIT format with a labelled boundary

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Timer.h>
#include <CGAL/Volume_mesh_parameterization/Averaged_gradient_field_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Product_map_3.h>
#include <CGAL/Volume_mesh_parameterization/sweep_with_repairs.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>

#include "solid_test_util.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Field = VMP::Averaged_gradient_field_3<Mesh>;
using VMP::Status;

// The point (NaN, …) of a vertex whose curve does not arrive.
const double nowhere = std::numeric_limits<double>::quiet_NaN();

Status load(const char* file, Mesh& mesh) {
  VMP::Tetrahedron_soup_3<Point_3> soup = shaped_block<Point_3>(Shape::TWISTED, 2, 6, 12);
  Status status = file ? VMP::IO::read_MEDIT(file, soup) : Status();
  if (!status.ok()) return status;
  VMP::orient_cells(soup);
  VMP::Boundary_partition_3 summary;
  VMP::Preparation counts;
  status = mesh.assign(soup);
  if (status.ok()) status = VMP::check_tetrahedral_mesh(mesh);
  if (status.ok()) status = VMP::validate_partition(mesh, summary);
  if (status.ok()) status = VMP::prepare_patches(mesh, counts);
  return status;
}

// The number of facets that a path from the floor to each cell crosses at least.
std::vector<double> breadth_first_levels(const Mesh& mesh) {
  std::vector<double> level(mesh.number_of_cells(), -1);
  std::vector<VMP::Cell_index> queue;
  const auto reach = [&](VMP::Cell_index c, double l) {
    if (!c.is_valid() || level[c] >= 0) return;
    level[c] = l;
    queue.push_back(c);
  };
  for (VMP::Facet_index f : floor_facets(mesh)) reach(mesh.half_facet(f).cell, 0);
  for (std::size_t k = 0; k < queue.size(); ++k)
    for (int i = 0; i < 4; ++i) reach(mesh.neighbor(queue[k], i), level[queue[k]] + 1);
  return level;
}

std::vector<double> means_in_cells(const Mesh& mesh, const std::vector<double>& values) {
  std::vector<double> means;
  for (VMP::Cell_index c : mesh.cells()) {
    const auto& v = mesh.cell(c);
    means.push_back((values[v[0]] + values[v[1]] + values[v[2]] + values[v[3]]) / 4);
  }
  return means;
}

// How many cells can be swept strictly in the order of their values, before one breaks a rule.
std::size_t swept_in_strict_order(const Mesh& mesh, const VMP::internal::Edge_numbering& edges,
                                  const std::vector<double>& values) {
  std::vector<VMP::Cell_index> cells(mesh.cells().begin(), mesh.cells().end());
  std::stable_sort(cells.begin(), cells.end(), [&](auto c, auto d) { return values[c] < values[d]; });
  VMP::internal::Sweep<Kernel> front(mesh, edges, VMP::FLOOR);
  for (const VMP::Cell_index c : cells) {
    if (!front.is_free(c)) break;
    front.sweep(c);
  }
  return front.order().size();
}

void compare_orders(const Mesh& mesh, const std::vector<double>& f, const VMP::Sweep_guide_3& flux_guide) {
  const std::pair<const char*, VMP::Sweep_guide_3> guides[] = {
      {"dual potential and signs of the flux", flux_guide},
      {"dual potential", flux_guide.potential},
      {"mean of the harmonic function", means_in_cells(mesh, f)},
      {"breadth first", breadth_first_levels(mesh)}};
  const VMP::internal::Edge_numbering edges(mesh);
  std::printf("%-40s %12s %12s %12s\n", "order of the sweep", "cells left", "ns a cell", "strict: swept");
  for (const auto& [name, guide] : guides) {
    CGAL::Timer timer;
    timer.start();
    VMP::internal::Sweep<Kernel> front(mesh, edges, VMP::FLOOR);
    front.run(guide);
    timer.stop();
    const std::size_t swept = front.order().size();
    std::printf("%-40s %12zu %12.0f %12zu\n", name, mesh.number_of_cells() - swept,
                1e9 * timer.time() / swept, swept_in_strict_order(mesh, edges, guide.potential));
  }
}

// The image of the vertices by the paper's curves: the floor map of where they begin, and the harmonic function as height.
std::vector<Point_3> averaged_images(const Mesh& mesh, const std::vector<double>& f, const Field& field,
                                     const VMP::Floor_map_2<Kernel>& floor_map) {
  std::vector<Point_3> images;
  for (VMP::Vertex_index v : mesh.vertices()) {
    const Field::Curve curve = field.trace(v, VMP::FLOOR);
    const bool arrives = curve.end == Field::Curve::ARRIVED;
    const Point_2 uv = arrives ? floor_map.image(curve.facet, curve.weights) : Point_2(nowhere, nowhere);
    images.push_back(Point_3(uv.x(), uv.y(), f[v] * floor_map.domain().height()));
  }
  return images;
}

void print_curves(const char* name, double floor, double ceiling, const Mesh& mesh,
                  const std::vector<Point_3>& images) {
  std::size_t flipped = 0, without_image = 0;
  for (VMP::Cell_index c : mesh.cells()) {
    const auto& v = mesh.cell(c);
    const auto is_nowhere = [&](VMP::Vertex_index u) { return images[u].x() != images[u].x(); };
    if (std::any_of(v.begin(), v.end(), is_nowhere))
      ++without_image;
    else if (CGAL::orientation(images[v[0]], images[v[1]], images[v[2]], images[v[3]]) != CGAL::POSITIVE)
      ++flipped;
  }
  const double percent = 100. / mesh.number_of_cells();
  std::printf("%-40s %12.2f %12.2f %12.2f %12.2f\n", name, 100 * floor, 100 * ceiling,
              percent * without_image, percent * flipped);
}

Status compare_curves(Mesh& mesh) {
  VMP::Product_structure_3<Kernel> structure;
  VMP::Sweep_report report;
  Status status = VMP::sweep_with_repairs(mesh, flux_guide<Mesh>, structure, report); // may refine
  VMP::Harmonic_function_3<Mesh> harmonic(mesh);
  VMP::Flux_field_3<Mesh> flux(mesh);
  VMP::Floor_map_2<Kernel> floor_map;
  if (status.ok()) status = harmonic.solve();
  if (status.ok()) status = flux.solve();
  if (status.ok()) status = floor_map.build(mesh);
  if (!status.ok()) return status;

  const VMP::Curve_field_3<Kernel> curve_field(mesh, structure, flux, harmonic);
  const VMP::Integral_curves_3<Kernel> curves(mesh, curve_field);
  std::vector<Point_3> images;
  status = VMP::Product_map_3<Kernel>(curves, floor_map).vertex_images(images);
  if (!status.ok()) return status;
  std::printf("\n%-40s %12s %12s %12s %12s\n", "% that arrive, or cells of vertex map", "floor", "ceiling",
              "no image", "flipped");
  print_curves("curves of the sweep", 1, 1, mesh, images); // otherwise vertex_images() fails

  const Field field(mesh, harmonic.values());
  print_curves("averaged gradients (Xia et al. 2010)", field.arrivals(VMP::FLOOR).share(),
               field.arrivals(VMP::CEILING).share(), mesh,
               averaged_images(mesh, harmonic.values(), field, floor_map));
  return status;
}

int main(int argc, char** argv) {
  Mesh mesh;
  Status status = load(argc > 1 ? argv[1] : nullptr, mesh);
  VMP::Harmonic_function_3<Mesh> f(mesh);
  VMP::Sweep_guide_3 guide;
  if (status.ok()) status = f.solve();
  if (status.ok()) status = flux_guide(mesh, guide);
  if (status.ok()) {
    std::printf("%s, %zu cells\n\n", argc > 1 ? argv[1] : "twisted block with two holes",
                mesh.number_of_cells());
    compare_orders(mesh, f.values(), guide);
    status = compare_curves(mesh);
  }
  if (!status.ok()) std::cerr << status.message() << std::endl;
  return status.ok() ? EXIT_SUCCESS : EXIT_FAILURE;
}
