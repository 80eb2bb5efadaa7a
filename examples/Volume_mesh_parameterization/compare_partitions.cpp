// Maps the solid inside a closed surface over several partitions of the surface, and keeps the best piecewise linear map.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_search_3.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Search = VMP::Parameterization_search_3<Kernel>;

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char* argv[]) {
  // 1. Read a closed surface.
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/pipe.off");
  CGAL::Surface_mesh<Point_3> surface;
  if (!CGAL::IO::read_polygon_mesh(filename, surface)) return fail({VMP::ERROR_CANNOT_READ_FILE, filename});

  // 2. Ask for more than the default: 4 is the energy of an isometry, so three partitions are tried.
  VMP::Parameterization_search_options options;
  options.good_energy = 4;
  options.most_partitions = 3;
  Search search(options);
  VMP::Status status = VMP::parameterize_surface(surface, search, VMP::parameters::number_of_cells(2000));
  if (!status.ok()) return fail(status);

  // 3. Say what was tried.
  for (const VMP::Parameterization_trial_3& trial : search.trials())
    std::cout << "by " << VMP::method_name(trial.partition->method) << ", from floor to ceiling along ("
              << trial.partition->direction << "): energy " << trial.boundary_energy << "\n";
  std::cout << "The best has energy " << search.chosen().boundary_energy << ".\n";

  // 4. The piecewise linear map has a mesh of its own. Write both meshes: they have the same tetrahedra.
  const Search::Linear_map& linear = search.linear_map();
  if (!linear.is_valid()) return fail(search.linear_status());
  VMP::Tetrahedron_soup_3<Point_3> solid = VMP::make_soup(linear.mesh()), image = solid;
  image.points = linear.images();
  status = VMP::IO::write_MEDIT("best_solid.mesh", solid);
  if (status.ok()) status = VMP::IO::write_MEDIT("best_image.mesh", image);
  return status.ok() ? EXIT_SUCCESS : fail(status);
}
