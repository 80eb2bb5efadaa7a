// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_ERROR_CODE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_ERROR_CODE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <string>
#include <utility>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationRef

lists why a stage refused its input or could not finish.
*/
enum Error_code {
  OK,                              ///< the stage is done
  ERROR_CANNOT_READ_FILE,          ///< the file does not exist or cannot be read
  ERROR_WRONG_FORMAT,              ///< the file is truncated or not in the format that its name promises
  ERROR_CANNOT_WRITE_FILE,         ///< the folder or the file cannot be written
  ERROR_WRONG_PARAMETER,           ///< a parameter is outside its range
  ERROR_MISSING_LIBRARY,           ///< the program was built without the library that this needs
  ERROR_EMPTY_MESH,                ///< there are no elements
  ERROR_INDEX_OUT_OF_RANGE,        ///< an element names a vertex that does not exist, or one vertex twice
  ERROR_COORDINATE_NOT_FINITE,     ///< a coordinate is infinite or not a number
  ERROR_NOT_TRIANGULATED,          ///< a face of the surface is not a triangle
  ERROR_OPEN_SURFACE,              ///< the surface has a border
  ERROR_NON_MANIFOLD,              ///< around an edge or a vertex the mesh is not a manifold
  ERROR_SEVERAL_COMPONENTS,        ///< the mesh or its boundary is not connected
  ERROR_DEGENERATE_TRIANGLE,       ///< three vertices of a triangle of the surface are collinear
  ERROR_SELF_INTERSECTION,         ///< facets of the surface intersect
  ERROR_FLAT_TETRAHEDRON,          ///< four vertices of a tetrahedron are coplanar
  ERROR_INVERTED_TETRAHEDRON,      ///< a tetrahedron is oriented against the others
  ERROR_TETRAHEDRALIZATION,        ///< the mesher failed
  ERROR_LABEL_NOT_ON_BOUNDARY,     ///< a labelled triangle is no boundary facet, or has two labels
  ERROR_UNLABELLED_FACET,          ///< a boundary facet has no label
  ERROR_NUMBER_OF_PATCHES,         ///< not one floor, one ceiling and genus + 1 walls
  ERROR_PATCH_NOT_CONNECTED,       ///< a patch is not connected through edges
  ERROR_PATCH_NOT_A_SURFACE,       ///< a patch touches itself at a vertex
  ERROR_PATCH_TOPOLOGY,            ///< floor or ceiling is no disk with genus holes, or a wall no annulus
  ERROR_FLOOR_MEETS_CEILING,       ///< floor and ceiling share a vertex
  ERROR_WALLS_MEET,                ///< two walls share a vertex
  ERROR_WALL_RIMS,                 ///< a wall does not meet the floor in one loop and the ceiling in one
  ERROR_FLOOR_NOT_ONTO,            ///< the floor does not carry the fundamental group of the solid
  ERROR_NOT_A_HANDLEBODY,          ///< no handlebody certificate was found
  ERROR_NO_PARTITION,              ///< no legal partition was found
  ERROR_PICKED_FACET,              ///< no legal partition gives a picked facet its label
  ERROR_CANNOT_SPLIT,              ///< a split falls on a neighbour when rounded to the number type
  ERROR_CANNOT_SOLVE,              ///< the linear solver failed
  ERROR_SWEEP_STOPPED,             ///< the sweep did not reach all tetrahedra
  ERROR_SWEEP_RULE,                ///< an order of tetrahedra breaks a rule of the sweep
  ERROR_CURVE_LOST,                ///< an integral curve did not arrive
  ERROR_FLOOR_MAP,                 ///< the floor could not be mapped one to one
  ERROR_NOT_A_POLYCUBE,            ///< a boundary facet of the given domain is orthogonal to no axis, or it meets itself
  ERROR_BOUNDARY_MAP,              ///< the given boundary map is not one to one onto the boundary of the domain
  ERROR_MAP_NOT_BIJECTIVE,         ///< the piecewise linear map flips a tetrahedron or does not cover its image once
  ERROR_INVERTED_HEXAHEDRON,       ///< a hexahedron has a corner that is not positive
  ERROR_OUTSIDE,                   ///< a point lies outside of the domain
  ERROR_CANCELLED                  ///< the callback asked to stop
};

/*!
\ingroup PkgVolumeMeshParameterizationRef

returns a sentence for `code`.
*/
inline const char* get_error_message(Error_code code) {
  // no default: the compiler names a forgotten code
  switch (code) {
  case OK: return "success";
  case ERROR_CANNOT_READ_FILE: return "the file cannot be read";
  case ERROR_WRONG_FORMAT: return "the file is truncated or malformed";
  case ERROR_CANNOT_WRITE_FILE: return "cannot write";
  case ERROR_WRONG_PARAMETER: return "a parameter is outside its range";
  case ERROR_MISSING_LIBRARY: return "this program was built without a library that is needed here";
  case ERROR_EMPTY_MESH: return "the mesh is empty";
  case ERROR_INDEX_OUT_OF_RANGE: return "an element names a vertex that does not exist, or one vertex twice";
  case ERROR_COORDINATE_NOT_FINITE: return "a coordinate is not finite";
  case ERROR_NOT_TRIANGULATED: return "a face is not a triangle";
  case ERROR_OPEN_SURFACE: return "the surface is not closed";
  case ERROR_NON_MANIFOLD: return "the mesh is not manifold";
  case ERROR_SEVERAL_COMPONENTS: return "the mesh or its boundary is not connected";
  case ERROR_DEGENERATE_TRIANGLE: return "a triangle has no area";
  case ERROR_SELF_INTERSECTION: return "the surface intersects itself";
  case ERROR_FLAT_TETRAHEDRON: return "a tetrahedron is flat";
  case ERROR_INVERTED_TETRAHEDRON: return "a tetrahedron is inverted";
  case ERROR_TETRAHEDRALIZATION: return "the surface could not be tetrahedralized";
  case ERROR_LABEL_NOT_ON_BOUNDARY: return "a labelled triangle is no boundary facet, or has two labels";
  case ERROR_UNLABELLED_FACET: return "a boundary facet has no label";
  case ERROR_NUMBER_OF_PATCHES: return "the labels are not one floor, one ceiling and genus + 1 walls";
  case ERROR_PATCH_NOT_CONNECTED: return "a patch is not connected";
  case ERROR_PATCH_NOT_A_SURFACE: return "a patch touches itself at a vertex";
  case ERROR_PATCH_TOPOLOGY: return "a patch has the wrong topology";
  case ERROR_FLOOR_MEETS_CEILING: return "floor and ceiling share a vertex";
  case ERROR_WALLS_MEET: return "two walls share a vertex";
  case ERROR_WALL_RIMS: return "a wall does not join one loop of the floor to one loop of the ceiling";
  case ERROR_FLOOR_NOT_ONTO: return "the floor does not carry the fundamental group of the solid";
  case ERROR_NOT_A_HANDLEBODY: return "the solid is not certified as a handlebody";
  case ERROR_NO_PARTITION: return "no legal partition into floor, ceiling and walls was found";
  case ERROR_PICKED_FACET: return "no legal partition that was found gives a picked facet its label";
  case ERROR_CANNOT_SPLIT: return "the mesh is too fine for its number type: a split degenerates";
  case ERROR_CANNOT_SOLVE: return "the linear solver failed";
  case ERROR_SWEEP_STOPPED: return "the sweep did not reach all tetrahedra";
  case ERROR_SWEEP_RULE: return "the order of tetrahedra breaks a rule of the sweep";
  case ERROR_CURVE_LOST: return "an integral curve did not arrive";
  case ERROR_FLOOR_MAP: return "the floor could not be mapped one to one";
  case ERROR_NOT_A_POLYCUBE: return "the domain is not a polycube";
  case ERROR_BOUNDARY_MAP: return "the boundary map is not one to one onto the boundary of the domain";
  case ERROR_MAP_NOT_BIJECTIVE: return "the piecewise linear map is not bijective";
  case ERROR_INVERTED_HEXAHEDRON: return "a hexahedron is inverted";
  case ERROR_OUTSIDE: return "a point lies outside of the domain";
  case ERROR_CANCELLED: return "cancelled";
  }
  return "unknown error code";
}

/*!
\ingroup PkgVolumeMeshParameterizationRef

is what every stage returns: an error code, and where and what precisely, for a person to read.
*/
class [[nodiscard]] Status {
public:
  Status() = default;
  /// constructs the status `code`; `detail` names the element and the violated condition.
  Status(Error_code code, std::string detail = {}) : m_code(code), m_detail(std::move(detail)) {}

  /// returns whether the stage is done.
  bool ok() const { return m_code == OK; }
  /// returns the code.
  Error_code code() const { return m_code; }
  /// returns which element is at fault and the like.
  const std::string& detail() const { return m_detail; }

  /// returns the sentence for the code, followed by the detail.
  std::string message() const {
    return m_detail.empty() ? get_error_message(m_code) : std::string(get_error_message(m_code)) + ": " + m_detail;
  }

private:
  Error_code m_code = OK;
  std::string m_detail;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_ERROR_CODE_H
