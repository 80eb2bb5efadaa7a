#ifndef HANDLEBODY_RESULT_FILES_H
#define HANDLEBODY_RESULT_FILES_H

#include "Chosen_solver_traits.h"
#include "Result_folder.h"
#include "types.h"

#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>

using Parameterizer = VMP::Direct_product_parameterizer_3<Kernel, Chosen_solver_traits>;

// result.vtu: the object mesh with f, u, v, w, labels, sweep positions, angles and critical points.
VMP::Status write_result(const Result_folder& folder, const Parameterizer& parameterizer, const std::vector<double>& angles,
                         const std::vector<std::size_t>& critical_vertices);

// curves.vtp: some integral curves in M and their images in P.
VMP::Status write_curves(const Result_folder& folder, const Parameterizer& parameterizer);

#endif // HANDLEBODY_RESULT_FILES_H
