// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_DATA_ARRAY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_DATA_ARRAY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <string>
#include <variant>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace IO {

/*!
\ingroup PkgVolumeMeshParameterizationIO

is an array of numbers with a name, to be shown on a mesh or on curves.
*/
struct Data_array {
  std::string name;                                           ///< what programs call it
  std::variant<std::vector<double>, std::vector<int>> values; ///< one for each point, or for each cell or curve
};

} // namespace IO
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_DATA_ARRAY_H
