// Maps points of a solid to the prism and back with exact numbers: they return to where they were, to the last bit.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using FT = Kernel::FT;
using Point_3 = Kernel::Point_3;
using Location = VMP::Location_3<Kernel>;
using Parameterizer = VMP::Direct_product_parameterizer_3<Kernel>;

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char* argv[]) {
  // 1. Read labelled tetrahedra; their coordinates are exact from here on.
  const std::string filename = argc > 1 ? argv[1] : "data/block_with_hole.mesh";
  VMP::Tetrahedron_soup_3<Point_3> soup;
  VMP::Status status = VMP::IO::read_MEDIT(filename, soup);
  if (!status.ok()) return fail(status);

  // 2. Parameterize. Only the linear systems are solved in floating point numbers: they decide which curves the map
  // follows, not whether it is one to one.
  Parameterizer result;
  status = VMP::parameterize(soup, result);
  if (!status.ok()) return fail(status);

  // 3. Take a point of each tetrahedron to the prism. Numbers like 1/7 are no floating point numbers.
  std::vector<Location> places, back;
  for (VMP::Cell_index c : result.mesh().cells())
    places.push_back({c, {FT(1) / 7, FT(3) / 7, FT(1) / 7, FT(2) / 7}});
  std::vector<Point_3> images;
  status = result.product_map()->images(places, images);
  if (!status.ok()) return fail(status);

  // 4. Take the images back, and compare exactly.
  status = result.product_map()->preimages(images, back);
  if (!status.ok()) return fail(status);
  std::size_t returned = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    returned += back[i].point(result.mesh()) == places[i].point(result.mesh());
  std::cout << returned << " of " << places.size() << " points returned exactly" << std::endl;
  return returned == places.size() ? EXIT_SUCCESS : EXIT_FAILURE;
}
