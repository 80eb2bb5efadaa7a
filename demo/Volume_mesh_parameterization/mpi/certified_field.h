#ifndef HANDLEBODY_MPI_CERTIFIED_FIELD_H
#define HANDLEBODY_MPI_CERTIFIED_FIELD_H

#include "../Result_folder.h"
#include "../types.h"

#include <CGAL/Volume_mesh_parameterization/Curve_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/Flux_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_structure_3.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include <string>
#include <vector>

using Curve_field = VMP::Curve_field_3<Kernel>;

// The order that `handlebody` would find, had it nothing to prepare or to repair.
inline VMP::Status sweep(const Mesh& mesh, const VMP::Harmonic_function_3<Mesh>& harmonic,
                         const VMP::Flux_field_3<Mesh>& flux, std::vector<VMP::Cell_index>& order) {
  VMP::Dual_potential_3<Mesh> potential(mesh);
  VMP::Status status = potential.approximate(harmonic.values());
  if (!status.ok()) return status;
  VMP::Sweep_guide_3 guide(potential.values());
  for (VMP::Cell_index c : mesh.cells()) guide.signs.push_back(flux.signs(c));
  VMP::Product_structure_3<Kernel> structure;
  status = VMP::sweep(mesh, guide, structure);
  if (status.ok()) order = structure.order();
  return status;
}

// The field of `handlebody`, made in one process, so that it does not depend on the number of processes. The order is read
// from `order_file` unless that is empty, and verified.
inline VMP::Status make_certified_field(const Mesh& mesh, const std::string& order_file, Curve_field& field) {
  VMP::Harmonic_function_3<Mesh> harmonic(mesh);
  VMP::Flux_field_3<Mesh> flux(mesh);
  VMP::Status status = harmonic.solve();
  if (!status.ok()) return status;
  flux.equilibrate(harmonic);
  std::vector<VMP::Cell_index> order;
  status = order_file.empty() ? sweep(mesh, harmonic, flux, order) : read_order(order_file, order);
  if (status.ok()) status = VMP::verify_product(mesh, order);
  if (status.ok()) field = Curve_field(mesh, VMP::Product_structure_3<Kernel>(mesh, order), flux, harmonic);
  return status;
}

#endif // HANDLEBODY_MPI_CERTIFIED_FIELD_H
