// Maps the solid inside a closed surface onto a prism, and pulls a grid of cubes of the prism back as hexahedra.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/optimize_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Parameterizer = VMP::Direct_product_parameterizer_3<Kernel>;

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char* argv[]) {
  // 1. Read a closed surface.
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Surface_mesh surface;
  if (!CGAL::IO::read_polygon_mesh(filename, surface)) return fail({VMP::ERROR_CANNOT_READ_FILE, filename});

  // 2. Divide it into floor, ceiling and walls, fill it with tetrahedra, and map them.
  Parameterizer result;
  VMP::Status status = VMP::parameterize_surface(surface, result, VMP::parameters::number_of_cells(5000));
  if (!status.ok()) return fail(status);

  // 3. Say what is certified.
  std::cout << "The solid has genus " << result.partition().genus << ". An order of its "
            << result.product_structure()->order().size() << " tetrahedra proves that it is the product of its floor "
            << "and an interval.\n";

  // 4. Write the parameter values (u, v, w) of the vertices, to be looked at in ParaView.
  std::vector<double> u, v, w;
  for (const Point_3& image : result.vertex_images()) {
    u.push_back(image.x());
    v.push_back(image.y());
    w.push_back(image.z());
  }
  VMP::IO::VTU_content content;
  content.point_data = {{"u", u}, {"v", v}, {"w", w}};
  status = VMP::IO::write_VTU("parameter_values.vtu", result.mesh(), content);
  if (!status.ok()) return fail(status);

  // 5. Make hexahedra, move their nodes, and write them if all are valid.
  const VMP::Prism_3<Kernel>& prism = result.floor_map()->domain();
  const auto column = [&](const Point_2& uv, const std::vector<double>& levels, std::vector<Point_3>& points) {
    return result.product_map()->column(uv, levels, points);
  };
  VMP::Hexahedron_soup_3<Point_3> hexahedra;
  status = VMP::hexahedral_mesh(prism, VMP::prism_grid_of_size(prism, 1000), column, hexahedra);
  if (status.ok()) status = VMP::optimize_hexahedra(result.mesh(), hexahedra);
  if (!status.ok()) return fail(status);
  const VMP::Hexahedra_report report = VMP::verify_hexahedra(hexahedra);
  std::cout << hexahedra.hexahedra.size() << " hexahedra, " << report.inverted << " of them inverted, least scaled Jacobian "
            << report.minimum_scaled_jacobian << ", mean " << report.mean_scaled_jacobian << "\n";
  status = report.is_valid() ? VMP::IO::write_MEDIT("hexahedra.mesh", hexahedra) : report.status;
  return status.ok() ? EXIT_SUCCESS : fail(status);
}
