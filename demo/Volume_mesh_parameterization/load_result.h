#ifndef HANDLEBODY_LOAD_RESULT_H
#define HANDLEBODY_LOAD_RESULT_H

#include "Result_folder.h"
#include "types.h"

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>

#include <vector>

// Reads a solid, and checks that it is a handlebody with a legal partition.
VMP::Status load_solid(const Result_folder& folder, const char* file, Mesh& mesh, VMP::Boundary_partition_3& partition);

// Reads the images of the vertices of the solid, and checks that they belong to it and make a piecewise linear bijection.
VMP::Status load_images(const Result_folder& folder, const Mesh& solid, std::vector<Point_3>& images);

// Finds the prism whose sides are the images of the patches of the solid.
VMP::Status find_prism(const Mesh& solid, const std::vector<Point_3>& images, VMP::Prism_3<Kernel>& prism);

#endif // HANDLEBODY_LOAD_RESULT_H
