// Maps a solid onto a polycube that is given, with the boundary as it is given.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/Boundary_map_3.h>
#include <CGAL/Volume_mesh_parameterization/label_polycube.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize_polycube.h>

#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Polycube = VMP::Polycube_3<Kernel>;
using Boundary_map = VMP::Boundary_map_3<Polycube>;
using Parameterizer = VMP::Direct_product_parameterizer_3<Kernel, VMP::Default_solver_traits_3, Boundary_map>;

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

// An L seen from the side, with its foot on the plane z = 0: three unit cubes. Common corners may be listed repeatedly.
VMP::Hexahedron_soup_3<Point_3> letter() {
  VMP::Hexahedron_soup_3<Point_3> cubes;
  for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 0, 1)}) {
    cubes.hexahedra.emplace_back();
    for (int corner = 0; corner < 8; ++corner) {
      cubes.hexahedra.back()[corner] = cubes.points.size();
      cubes.points.push_back(p + Kernel::Vector_3(corner % 2, corner / 2 % 2, corner / 4));
    }
  }
  return cubes;
}

int main() {
  // 1. Build the polycube: fill it with tetrahedra, sweep it from its lowest faces to its highest ones.
  Mesh boxes;
  Polycube polycube;
  VMP::Status status = VMP::tetrahedralize_polycube(letter(), boxes);
  if (status.ok()) status = VMP::label_polycube(boxes, 2);
  if (status.ok()) status = polycube.build(boxes);
  if (!status.ok()) return fail(status);

  // 2. Take a solid whose boundary vertices have images on the polycube: here a finer mesh of the letter that was bent,
  // so the images are known; else they come from a method for polycube maps of surfaces.
  Mesh straight, solid;
  status = VMP::tetrahedralize_polycube(letter(), straight, 2000);
  auto bent = VMP::make_soup(straight);
  for (Point_3& p : bent.points) p = Point_3(p.x() + p.z() * p.z() / 4, p.y() + p.x() * p.x() / 8, p.z());
  if (status.ok()) status = solid.assign(bent);
  if (!status.ok()) return fail(status);

  // 3. Check that the boundary map is one to one, and let the solid take the labels of the polycube.
  const Boundary_map boundary_map(polycube, straight.points());
  status = boundary_map.label_boundary(solid);
  if (!status.ok()) return fail(status);

  // 4. Extend the map of the floor to the inside. Vertices keep their numbers, some may be added.
  Parameterizer result(boundary_map);
  status = VMP::parameterize(solid, result);
  if (!status.ok()) return fail(status);
  std::cout << solid.number_of_cells() << " tetrahedra; vertex 100 at " << solid.point(100) << " goes to "
            << result.vertex_images()[100] << ", before the letter was bent it was at " << straight.point(100)
            << std::endl;
  return EXIT_SUCCESS;
}
