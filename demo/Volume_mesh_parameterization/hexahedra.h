#ifndef HANDLEBODY_HEXAHEDRA_H
#define HANDLEBODY_HEXAHEDRA_H

#include "Chosen_solver_traits.h"
#include "commands.h"
#include "report.h"
#include "result_files.h"

#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_map_3.h>

using Prism_parameterizer = VMP::Direct_product_parameterizer_3<Kernel, Chosen_solver_traits, Prism_floor_map>;

// Makes and optimizes hexahedra, along curves or, if fewer of them are inverted then, by the piecewise linear map if there is one.
// Reports what was measured. Fails if some are inverted in the end.
VMP::Status make_hexahedra(const Hexahedra_options& options, const Prism_parameterizer& solid,
                           const VMP::Piecewise_linear_map_3<Kernel>& linear_map, Json& report,
                           VMP::Hexahedron_soup_3<Point_3>& hexahedra);

// The same by a piecewise linear map that is known by the images of the vertices of the solid.
VMP::Status make_hexahedra(const Hexahedra_options& options, const Mesh& solid, const VMP::Prism_3<Kernel>& prism,
                           const std::vector<Point_3>& images, Json& report, VMP::Hexahedron_soup_3<Point_3>& hexahedra);

#endif // HANDLEBODY_HEXAHEDRA_H
