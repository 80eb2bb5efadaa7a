// Maps a solid torus, meshed by the package Mesh_3, onto a prism with one hole.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangulation_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>
#include <CGAL/make_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using C3t3 = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

// Negative inside.
double torus(const Point_3& p) {
  const double distance_to_circle = std::sqrt(p.x() * p.x() + p.y() * p.y()) - 2;
  return distance_to_circle * distance_to_circle + p.z() * p.z() - 1;
}

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main() {
  // 1. Mesh the domain.
  const Domain domain = Domain::create_implicit_mesh_domain(torus, Kernel::Sphere_3(CGAL::ORIGIN, 16));
  const Criteria criteria(Criteria::Facet_criteria(25, .4, .05), Criteria::Cell_criteria(2, .5));
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria);

  // 2. Copy the cells inside, and divide their boundary along the z-axis.
  const auto cells = VMP::make_triangulation_cells(c3t3);
  VMP::Compact_tetrahedral_mesh_3<Kernel> mesh;
  VMP::Status status = mesh.assign(cells);
  VMP::Partition_options options;
  options.directions = {VMP::Sweep_direction_3(0, 0, 1)};
  if (status.ok()) status = VMP::partition_boundary(mesh, options);
  if (!status.ok()) return fail(status);

  // 3. Parameterize.
  VMP::Direct_product_parameterizer_3<Kernel> result;
  status = VMP::parameterize(mesh, result);
  if (!status.ok()) return fail(status);

  // 4. Print the parameters of the lowest vertex of the complex: vertices keep their numbers.
  std::size_t lowest = 0;
  for (std::size_t v = 0; v < cells.number_of_vertices(); ++v)
    if (cells.point(v).z() < cells.point(lowest).z()) lowest = v;
  std::cout << cells.number_of_cells() << " cells, genus " << result.partition().genus << "\n"
            << cells.point(lowest) << " has the parameters " << result.vertex_images()[lowest] << std::endl;
  return EXIT_SUCCESS;
}
