#ifndef HANDLEBODY_RESULT_FILES_H
#define HANDLEBODY_RESULT_FILES_H

#include "Chosen_solver_traits.h"
#include "Result_folder.h"
#include "types.h"

#include <CGAL/Volume_mesh_parameterization/Boundary_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Floor_map_2.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/critical_points.h>
#include <CGAL/Volume_mesh_parameterization/irregular_edges.h>

using Product = VMP::Direct_product_3<Kernel, Chosen_solver_traits>;
using Polycube = VMP::Polycube_3<Kernel, Chosen_solver_traits>;
using Prism_floor_map = VMP::Floor_map_2<Kernel>;
using Given_boundary_map = VMP::Boundary_map_3<Polycube>;

// Where the fields are no product.
struct Singularities {
  std::vector<VMP::Critical_vertex> critical_vertices; // of f
  std::vector<VMP::Irregular_edge> irregular_edges;    // of the flux
};

// What result.vtu tells about the mesh that is written.
struct Result_fields {
  std::vector<double> f;
  std::vector<Point_3> images;  // along curves: (u, v, w times the height)
  std::vector<int> positions;   // of cells in the sweep
  std::vector<double> angles;   // of cells
};

// result.vtu: the object mesh with f, u, v, w, labels, sweep positions, angles, critical points and irregular edges.
VMP::Status write_result(const Result_folder& folder, const Mesh& mesh, const Result_fields& fields, double height,
                         const Singularities& singularities);

// curves.vtp: some integral curves in M and their images in P.
VMP::Status write_curves(const Result_folder& folder, const VMP::Product_map_3<Kernel, Prism_floor_map>& map);
VMP::Status write_curves(const Result_folder& folder, const VMP::Product_map_3<Kernel, Given_boundary_map>& map);

// hex.mesh, hex.msh, hex.inp or hex.vtu for "medit", "gmsh", "abaqus" or "vtu".
VMP::Status write_hexahedra_files(const Result_folder& folder, const VMP::Hexahedron_soup_3<Point_3>& hexahedra,
                                  const std::vector<std::string>& formats);

#endif // HANDLEBODY_RESULT_FILES_H
