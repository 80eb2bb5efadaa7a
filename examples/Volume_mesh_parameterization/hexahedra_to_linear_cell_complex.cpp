// Turns hexahedra into a linear cell complex of CGAL, and walks through it from the floor to the ceiling.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/make_linear_cell_complex.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Linear_cell_complex_traits<3, Kernel>;
using Complex = CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, Traits>;
using Dart = Complex::Dart_handle;

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char* argv[]) {
  // 1. Read hexahedra.
  const std::string filename = argc > 1 ? argv[1] : "data/hexahedra_with_hole.mesh";
  VMP::Hexahedron_soup_3<Kernel::Point_3> hexahedra;
  VMP::Status status = VMP::IO::read_MEDIT(filename, hexahedra);
  if (!status.ok()) return fail(status);

  // 2. Sew them to a complex, and keep a dart of each.
  Complex complex;
  std::vector<Dart> darts;
  status = VMP::make_linear_cell_complex(hexahedra, complex, std::back_inserter(darts));
  if (!status.ok()) return fail(status);

  // 3. Count its cells, and the facets on the boundary: those that are not sewn.
  complex.display_characteristics(std::cout) << ", " << (complex.is_valid() ? "valid" : "not valid") << "\n";
  std::size_t on_boundary = 0;
  for (auto facet = complex.one_dart_per_cell<2>().begin(); facet.cont(); ++facet) on_boundary += complex.is_free<3>(facet);
  std::cout << on_boundary << " facets are on the boundary.\n";

  // 4. Walk upwards from the first hexahedron through the middles of all over it.
  std::size_t layers = 0;
  Dart bottom = complex.beta(darts.front(), 0, 2);
  for (bool is_inside = true; is_inside; ++layers) {
    const Dart top = complex.beta(bottom, 2, 1, 1, 2);
    is_inside = !complex.is_free<3>(top);
    std::cout << complex.barycenter<3>(bottom) << "\n";
    bottom = complex.beta(top, 3);
  }
  std::cout << "The walk went through " << layers << " hexahedra." << std::endl;
  return EXIT_SUCCESS;
}
