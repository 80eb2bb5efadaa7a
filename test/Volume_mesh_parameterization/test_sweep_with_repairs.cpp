#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/prepare_patches.h>
#include <CGAL/Volume_mesh_parameterization/sweep_with_repairs.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "test_util.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <iostream>
#include <random>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;

Mesh prepared_block(int holes, int per_unit, int layers) {
  Mesh mesh;
  VMP::Preparation counts;
  VMP::Status status = mesh.assign(Block_with_holes<Kernel::Point_3>(holes, per_unit, layers).soup());
  if (status.ok()) status = VMP::prepare_patches(mesh, counts);
  assert(status.ok());
  return mesh;
}

VMP::Status harmonic_guide(const Mesh& mesh, VMP::Sweep_guide_3& guide) {
  VMP::Dual_potential_3<Mesh> dual(mesh);
  const VMP::Status status = dual.solve();
  if (status.ok()) guide = dual.values();
  return status;
}

// A legal order stays legal whatever edges, facets and cells are split, also if it is not complete.
void test_lemma(int holes, unsigned seed) {
  std::mt19937 random(seed);
  Mesh mesh = prepared_block(holes, 2, 2);
  VMP::Sweep_guide_3 guide;
  VMP::Status status = harmonic_guide(mesh, guide);
  VMP::Product_structure_3<Kernel> structure;
  if (status.ok()) status = VMP::sweep(mesh, guide, structure);
  assert(status.ok());
  const bool complete = seed % 2 == 0;
  std::vector<VMP::Cell_index> order = structure.order();
  if (!complete) order.resize(order.size() / 2);
  const std::size_t before = mesh.number_of_cells();

  VMP::internal::Refinable_order<Kernel> refinable(mesh, order);
  for (int k = 0; k < 200; ++k) {
    auto cell = refinable.mesh().cell(VMP::Cell_index(random() % refinable.mesh().number_of_cells()));
    std::shuffle(cell.begin(), cell.end(), random);
    status = refinable.insert_barycentre({cell.begin(), cell.begin() + 2 + random() % 3});
    assert(status.ok());
  }
  status = std::move(refinable).write_to(mesh, order);
  assert(status.ok() && mesh.number_of_cells() > before + 200);

  const VMP::internal::Edge_numbering edges(mesh);
  VMP::internal::Sweep<Kernel> front(mesh, edges, VMP::FLOOR);
  for (VMP::Cell_index c : order) {
    assert(front.is_free(c));
    front.sweep(c);
  }
  if (complete) {
    status = VMP::verify_product(mesh, order);
    assert(status.ok());
  }
}

// A mesh without the regular structure of a grid.
Mesh bisected_at_random(const Mesh& mesh, std::size_t bisections, std::mt19937& random) {
  VMP::internal::Splittable_mesh<Kernel> splittable(mesh);
  for (std::size_t k = 0; k < bisections; ++k) {
    const auto& cell = splittable.cell(VMP::Cell_index(random() % splittable.number_of_cells()));
    const int i = int(random() % 4), j = (i + 1 + int(random() % 3)) % 4;
    const VMP::Status status = splittable.insert_barycentre({cell[i], cell[j]});
    assert(status.ok());
  }
  Mesh result;
  VMP::Preparation counts;
  VMP::Status status = std::move(splittable).write_to(result);
  if (status.ok()) status = VMP::prepare_patches(result, counts);
  assert(status.ok());
  return result;
}

// Fingers that run up to the ceiling and then grow sideways close pockets; the repairs get out of them, by the harmonic
// potential after a refinement.
void test_repairs(int holes, unsigned seed, VMP::Sweep_report& report) {
  std::mt19937 random(seed);
  Mesh mesh = bisected_at_random(prepared_block(holes, 2, 3), 2000, random);
  bool first = true;
  const auto misleading_guide = [&](const Mesh& m, VMP::Sweep_guide_3& guide) {
    if (!first) return harmonic_guide(m, guide);
    first = false;
    const VMP::Status status = harmonic_guide(m, guide);
    for (double& v : guide.potential) v = -v;
    return status;
  };
  VMP::Product_structure_3<Kernel> structure;
  VMP::Status status = VMP::sweep_with_repairs(mesh, misleading_guide, structure, report);
  std::cout << holes << " holes, " << mesh.number_of_cells() << " cells: left at first " << report.left_at_first
            << ", from ceiling " << report.from_ceiling << ", restarts " << report.restarts << ", refinements "
            << report.refinements << ", " << status.message() << std::endl;
  assert(status.ok());
  status = VMP::verify_product(mesh, structure.order());
  assert(status.ok());
}

void test_guide_may_fail() {
  Mesh mesh = prepared_block(0, 1, 1);
  VMP::Product_structure_3<Kernel> structure;
  VMP::Sweep_report report;
  const auto failing = [](const Mesh&, VMP::Sweep_guide_3&) { return VMP::Status(VMP::ERROR_CANNOT_SOLVE); };
  assert(VMP::sweep_with_repairs(mesh, failing, structure, report).code() == VMP::ERROR_CANNOT_SOLVE);
  assert(structure.order().empty());
}

int main() {
  for (unsigned seed = 0; seed < 10; ++seed) test_lemma(int(seed % 3), seed);
  std::size_t restarts = 0, refinements = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    VMP::Sweep_report report;
    test_repairs(int(seed % 3), seed, report);
    restarts += report.restarts;
    refinements += report.refinements;
  }
  assert(restarts > 0 && refinements > 0);
  test_guide_may_fail();
  return EXIT_SUCCESS;
}
