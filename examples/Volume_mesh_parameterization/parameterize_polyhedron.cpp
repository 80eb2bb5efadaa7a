// Maps the solid inside a CGAL::Polyhedron_3, as that inside any other model of FaceListGraph, in a given direction.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Parameterizer = VMP::Direct_product_parameterizer_3<Kernel>;

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char* argv[]) {
  // 1. Read a closed surface.
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/torus_quad.off");
  Polyhedron polyhedron;
  if (!CGAL::IO::read_polygon_mesh(filename, polyhedron))
    return fail({VMP::ERROR_CANNOT_READ_FILE, filename});

  // 2. Its faces must be triangles.
  CGAL::Polygon_mesh_processing::triangulate_faces(polyhedron);

  // 3. Fill it with about 2000 tetrahedra and map them, from the floor below to the ceiling above.
  const auto np = VMP::parameters::combine(VMP::parameters::sweep_direction(Kernel::Vector_3(0, 0, 1)),
                                           VMP::parameters::number_of_cells(2000));
  Parameterizer result;
  const VMP::Status status = VMP::parameterize_surface(polyhedron, result, np);
  if (!status.ok()) return fail(status);

  // 4. Say what it was mapped to.
  const VMP::Prism_3<Kernel>& prism = result.floor_map()->domain();
  std::cout << polyhedron.size_of_facets() << " triangles enclose " << result.mesh().number_of_cells()
            << " tetrahedra, mapped to a prism of " << prism.outer().width() << " x "
            << prism.outer().height() << " x " << prism.height() << " with " << prism.number_of_holes()
            << " hole(s)" << std::endl;
  return EXIT_SUCCESS;
}
