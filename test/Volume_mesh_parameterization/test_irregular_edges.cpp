#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/irregular_edges.h>

#include "solid_test_util.h"

#include <cassert>
#include <cstdlib>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;

// The signs of a linear function: cells are entered through the facets where it is less than on the other side.
struct Parallel_flux {
  std::vector<std::array<std::int8_t, 4>> values;

  Parallel_flux(const Mesh& mesh, const Kernel::Vector_3& direction) {
    for (VMP::Cell_index c : mesh.cells()) {
      values.emplace_back();
      for (int i = 0; i < 4; ++i) {
        const auto v = mesh.vertices(VMP::Half_facet{c, i});
        const double outflow = direction * CGAL::normal(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
        values.back()[i] = outflow < 0 ? 1 : outflow > 0 ? -1 : 0;
      }
    }
  }
  const std::array<std::int8_t, 4>& signs(VMP::Cell_index c) const { return values[c]; }
};

// Along an axis or a diagonal it does not cross many facets of the plain block.
void test_parallel_flux() {
  for (Shape shape : {Shape::JITTERED, Shape::PLAIN}) {
    Mesh mesh;
    const VMP::Status status = mesh.assign(shaped_block<Kernel::Point_3>(shape, 1, 3, 3));
    assert(status.ok());
    for (const Kernel::Vector_3& direction :
         {Kernel::Vector_3(0.3, 0.2, 0.9), {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}})
      assert(VMP::irregular_edges(mesh, Parallel_flux(mesh, direction)).empty());
  }
}

// A turn around the axis of a regular double pyramid circles around the edge on the axis.
void test_vortex() {
  VMP::Tetrahedron_soup_3<Kernel::Point_3> soup;
  constexpr std::size_t n = 6;
  soup.points = {{0, 0, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * double(i) / double(n);
    soup.points.emplace_back(std::cos(angle), std::sin(angle), 0.5);
    soup.cells.push_back({0, 2 + i, 2 + (i + 1) % n, 1});
  }
  Mesh mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  Parallel_flux flux(mesh, {0, 0, 1});
  // the flux enters each cell through the facet at vertex 2 + i, opposite to the next one
  for (auto& signs : flux.values) signs = {0, -1, 1, 0};
  const auto edges = VMP::irregular_edges(mesh, flux);
  assert(edges.size() == 1 && edges[0].sign_changes == 0);
  assert(edges[0].vertices[0] == 0 && edges[0].vertices[1] == 1);
  // it cannot circle past a facet that it does not cross
  flux.values[0] = {0, 0, 1, 0}, flux.values[1] = {0, -1, 0, 0};
  assert(VMP::irregular_edges(mesh, flux).empty());
  // in every second cell against the turn: as many changes as cells
  for (std::size_t c = 0; c < n; ++c)
    flux.values[c] =
        c % 2 == 0 ? std::array<std::int8_t, 4>{0, 1, 1, -1} : std::array<std::int8_t, 4>{1, -1, -1, 0};
  const auto saddles = VMP::irregular_edges(mesh, flux);
  assert(saddles.size() == 1 && saddles[0].sign_changes == int(n));
}

// Nothing circles in a sweep, wherever the harmonic flux may.
void test_sweep() {
  for (Shape shape : {Shape::JITTERED, Shape::BENT, Shape::TWISTED}) {
    const Swept_solid<Kernel> solid(shaped_block<Kernel::Point_3>(shape, 1, 3, 4));
    for (const VMP::Irregular_edge& e : VMP::irregular_edges(solid.mesh, solid.structure))
      assert(e.sign_changes >= 4);
  }
}

int main() {
  test_parallel_flux();
  test_vortex();
  test_sweep();
  return EXIT_SUCCESS;
}
