// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INDICES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INDICES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cstdint>
#include <functional>
#include <limits>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMesh

is the number of an element of a mesh: a 32-bit integer with a type of its own, so that a cell is not taken for a
vertex. It converts implicitly to an integer, to look up arrays; the way back is explicit.

\tparam Tag tells what is numbered
*/
template <typename Tag>
class Index {
public:
  constexpr Index() = default;
  template <typename Integer>
  explicit constexpr Index(Integer i) : m_value(static_cast<std::uint32_t>(i)) {}

  /// returns the number.
  constexpr operator std::uint32_t() const { return m_value; }
  /// returns whether it numbers anything: a default constructed one does not.
  constexpr bool is_valid() const { return m_value != std::numeric_limits<std::uint32_t>::max(); }
  /// goes to the next number.
  Index& operator++() {
    ++m_value;
    return *this;
  }

private:
  std::uint32_t m_value = std::numeric_limits<std::uint32_t>::max();
};

/// \ingroup PkgVolumeMeshParameterizationMesh
/// is the number of a vertex.
using Vertex_index = Index<struct Vertex_tag>;
/// \ingroup PkgVolumeMeshParameterizationMesh
/// is the number of an edge.
using Edge_index = Index<struct Edge_tag>;
/// \ingroup PkgVolumeMeshParameterizationMesh
/// is the number of a facet.
using Facet_index = Index<struct Facet_tag>;
/// \ingroup PkgVolumeMeshParameterizationMesh
/// is the number of a cell.
using Cell_index = Index<struct Cell_tag>;

/*!
\ingroup PkgVolumeMeshParameterizationMesh

is the facet opposite to vertex `index` of `cell`, seen from `cell`.
*/
struct Half_facet {
  Cell_index cell; ///< a cell
  int index = 0;   ///< the vertex of the cell that is opposite to the facet, from 0 to 3
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INDICES_H
