// Makes a map that is linear on each tetrahedron, and verifies that it is one to one.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_map_3.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char* argv[]) {
  // 1. Read labelled tetrahedra and parameterize them.
  const std::string filename = argc > 1 ? argv[1] : "data/block_with_hole.mesh";
  VMP::Tetrahedron_soup_3<Point_3> soup;
  VMP::Direct_product_parameterizer_3<Kernel> result;
  VMP::Status status = VMP::IO::read_MEDIT(filename, soup);
  if (status.ok()) status = VMP::parameterize(soup, result);
  if (!status.ok()) return fail(status);

  // 2. The map along curves is one to one, but what is linear between the images of the vertices need not be.
  const VMP::Map_report before = VMP::verify_map(result.mesh(), result.vertex_images());
  std::cout << "along curves: " << before.flipped << " tetrahedra flipped, " << before.flat << " flat, "
            << before.off_axis << " boundary triangles across a rim\n";

  // 3. Map the boundary to that of the prism, and move the images of inner vertices until no tetrahedron is flipped. Some
  // edges may be bisected: the map has a mesh of its own.
  VMP::Piecewise_linear_map_3<Kernel> linear;
  status = VMP::make_piecewise_linear(result, linear);
  if (!status.ok()) return fail(status);

  // 4. Verify by exact signs what the map promises: all tetrahedra positive, the boundary once around a polycube, and
  // still an order in which the tetrahedra are swept.
  const VMP::Map_report after = VMP::verify_map(linear.mesh(), linear.images());
  std::cout << "piecewise linear: " << after.flipped << " of " << linear.mesh().number_of_cells()
            << " tetrahedra flipped, " << after.flat << " flat, " << after.off_axis
            << " boundary triangles across a rim, " << after.overlaps << " overlaps\n";
  if (!after.is_polycube_map()) return fail(after.status);
  status = VMP::verify_product(linear.mesh(), linear.order());
  if (!status.ok()) return fail(status);

  // 5. Write both meshes: they have the same tetrahedra.
  VMP::Tetrahedron_soup_3<Point_3> solid = VMP::make_soup(linear.mesh()), image = solid;
  image.points = linear.images();
  status = VMP::IO::write_MEDIT("solid.mesh", solid);
  if (status.ok()) status = VMP::IO::write_MEDIT("image.mesh", image);
  return status.ok() ? EXIT_SUCCESS : fail(status);
}
