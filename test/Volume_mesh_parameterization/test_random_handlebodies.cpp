#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/sweep_with_repairs.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "solid_test_util.h"

#include <cassert>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;

// A block with holes, jittered, waved, blown up and twisted, all as far as no tetrahedron is inverted.
Soup random_handlebody(Random& random) {
  const int holes = int(random.below(9)), per_unit = holes > 4 ? 1 : 1 + int(random.below(2));
  const int layers = 1 + int(random.below(3));
  const Soup soup =
      shaped_block<Point>(Shape::JITTERED, holes, per_unit, layers, unsigned(random.below(1000)));
  const double bulge = random.in(0, 0.4), wave = random.in(0, 0.5), frequency = random.in(0.5, 2),
               turn = random.in(0, 2);
  for (double amount = 1;; amount /= 2) {
    const Soup warped = transformed(soup, [=](const Point& p) {
      const double width = 1 + amount * bulge * std::sin(frequency * p.x()), angle = amount * turn * p.z();
      const double x = p.x(), y = p.y() * width, z = p.z() * width + amount * wave * std::sin(frequency * x);
      return Point(std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y,
                   3 * z);
    });
    Mesh mesh;
    VMP::Status status = mesh.assign(warped);
    if (status.ok()) status = VMP::check_tetrahedral_mesh(mesh);
    if (status.ok()) return warped;
  }
}

VMP::Status validate(const Mesh& mesh) {
  VMP::Boundary_partition_3 summary;
  VMP::Handlebody_certificate certificate;
  VMP::Status status = VMP::validate_partition(mesh, summary);
  if (status.ok()) status = VMP::certify_handlebody(mesh, certificate);
  return status.ok() ? VMP::validate_fundamental_group(mesh, certificate) : status;
}

VMP::Status certify(Mesh& mesh, VMP::Product_structure_3<Kernel>& structure) {
  VMP::Preparation counts;
  VMP::Sweep_report report;
  VMP::Status status = validate(mesh);
  if (status.ok()) status = VMP::prepare_patches(mesh, counts);
  if (status.ok()) status = VMP::sweep_with_repairs(mesh, flux_guide<Mesh>, structure, report);
  return status.ok() ? VMP::verify_product(mesh, structure.order()) : status;
}

VMP::Facet_index random_facet(const Mesh& mesh, int label, Random& random) {
  std::vector<VMP::Facet_index> facets;
  for (VMP::Facet_index f : mesh.boundary_facets())
    if (mesh.label(f) == label) facets.push_back(f);
  return facets[random.below(facets.size())];
}

// Breaks the labels in one of several ways and tells what should be found.
VMP::Error_code break_partition(Mesh& mesh, int way, Random& random) {
  const int walls = int(std::max_element(mesh.labelled_facets().begin(), mesh.labelled_facets().end(),
                                         [](const auto& a, const auto& b) { return a.label < b.label; })
                            ->label) -
                    2;
  const auto rename = [&](int from, int to) {
    for (VMP::Facet_index f : mesh.boundary_facets())
      if (mesh.label(f) == from) mesh.set_label(f, to);
  };
  switch (way) {
  case 0:
    mesh.set_label(VMP::Facet_index(random.below(mesh.number_of_boundary_facets())), VMP::INTERIOR);
    return VMP::ERROR_UNLABELLED_FACET;
  case 1:
    rename(VMP::FIRST_WALL + walls - 1, VMP::FIRST_WALL + walls);
    return VMP::ERROR_NUMBER_OF_PATCHES;
  case 2:
    mesh.set_label(random_facet(mesh, VMP::FLOOR, random), VMP::CEILING);
    return VMP::ERROR_PATCH_NOT_CONNECTED;
  case 3:
    rename(VMP::FLOOR, 1000);
    rename(VMP::FIRST_WALL, VMP::FLOOR);
    rename(1000, VMP::FIRST_WALL);
    return VMP::ERROR_FLOOR_MEETS_CEILING;
  default:
    rename(VMP::CEILING, VMP::FLOOR);
    return VMP::ERROR_NUMBER_OF_PATCHES;
  }
}

// An order with one entry changed is none.
void test_mutations(const Mesh& mesh, const std::vector<VMP::Cell_index>& order, Random& random) {
  for (int trial = 0; trial < 1000; ++trial) {
    std::vector<VMP::Cell_index> mutated = order;
    VMP::Cell_index& entry = mutated[random.below(order.size())];
    entry = VMP::Cell_index((entry + 1 + random.below(order.size() - 1)) % order.size());
    assert(!VMP::verify_product(mesh, mutated).ok());
  }
}

int main() {
  Random random(2026);
  for (int trial = 0; trial < 200; ++trial) {
    const Soup soup = random_handlebody(random);
    Mesh mesh, broken;
    VMP::Product_structure_3<Kernel> structure;
    VMP::Status status = mesh.assign(soup);
    if (status.ok()) status = broken.assign(soup);
    if (status.ok()) status = VMP::check_tetrahedral_mesh(mesh);
    if (status.ok()) status = certify(mesh, structure);
    if (!status.ok()) std::cerr << "trial " << trial << ": " << status.message() << std::endl;
    assert(status.ok());

    const VMP::Error_code expected = break_partition(broken, trial % 5, random);
    const VMP::Error_code found = validate(broken).code();
    if (found != expected)
      std::cerr << "trial " << trial << ": " << found << " for " << expected << std::endl;
    assert(found == expected);
    if (trial == 0) test_mutations(mesh, structure.order(), random);
  }
  std::cout << "200 handlebodies certified, 200 broken partitions refused, 1000 mutated orders refused"
            << std::endl;
  return EXIT_SUCCESS;
}
