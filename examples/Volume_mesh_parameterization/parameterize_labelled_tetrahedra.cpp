// Maps tetrahedra with a labelled boundary onto a prism, and takes points there and back again.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Parameterizer = VMP::Direct_product_parameterizer_3<Kernel>;

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char* argv[]) {
  // 1. Read tetrahedra, and triangles with the labels 1 floor, 2 ceiling, 3 + k wall k.
  const std::string filename = argc > 1 ? argv[1] : "data/block_with_hole.mesh";
  VMP::Tetrahedron_soup_3<Point_3> soup;
  VMP::Status status = VMP::IO::read_MEDIT(filename, soup);
  if (!status.ok()) return fail(status);

  // 2. Parameterize. The third coordinate is to grow like the length of the curves.
  Parameterizer result;
  status = VMP::parameterize(soup, result, VMP::parameters::level_function(VMP::ARC_LENGTH_LEVEL));
  if (!status.ok()) return fail(status);

  // 3. Take the middle of a tetrahedron to the prism and back.
  const VMP::Location_3<Kernel> middle = {VMP::Cell_index(0), {.25, .25, .25, .25}};
  VMP::Location_3<Kernel> back;
  Point_3 image;
  status = result.product_map()->image(middle, image);
  if (status.ok()) status = result.product_map()->preimage(image, back);
  if (!status.ok()) return fail(status);
  std::cout << "(" << middle.point(result.mesh()) << ") has the parameters (" << image << "), which belong to ("
            << back.point(result.mesh()) << ")\n";

  // 4. Write the solid in parameter space, if what is linear on its tetrahedra is one to one as well.
  const VMP::Map_report report = VMP::verify_map(result.mesh(), result.vertex_images());
  std::cout << report.flipped << " of " << result.mesh().number_of_cells() << " tetrahedra are inverted\n";
  if (!report.is_bijective()) return EXIT_SUCCESS;
  auto parameters = VMP::make_soup(result.mesh());
  parameters.points = result.vertex_images();
  status = VMP::IO::write_MEDIT("parameters.mesh", parameters);
  return status.ok() ? EXIT_SUCCESS : fail(status);
}
