// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_GMSH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_GMSH_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_patches.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_writer.h>
#include <CGAL/Volume_mesh_parameterization/internal/write_atomically.h>

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Each patch is a discrete surface of Gmsh and a physical group, both with the number of its label; the solid is volume 1.
template <typename Point>
class Gmsh_writer {
public:
  Gmsh_writer(std::ostream& os, const Hexahedron_soup_3<Point>& soup, const Hexahedron_patches& patches)
      : m_out(os), m_soup(soup), m_patches(patches) {}

  void write() {
    m_out << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    write_physical_names();
    write_entities();
    write_nodes();
    write_elements();
  }

private:
  enum Element_type { QUADRANGLE = 3, HEXAHEDRON = 5 };

  void write_physical_names() {
    m_out << "$PhysicalNames\n" << m_patches.size() + 1 << '\n';
    for (const auto& [label, sides] : m_patches)
      m_out << "2 " << label << " \"" << patch_identifier(label) << "\"\n";
    m_out << "3 1 \"" << solid_identifier << "\"\n$EndPhysicalNames\n";
  }

  void write_entities() {
    m_out << "$Entities\n0 0 " << m_patches.size() << " 1\n";
    for (const auto& [label, sides] : m_patches) {
      Bbox_3 box;
      for (const Hexahedron_side& side : sides)
        for (std::size_t v : side.vertices) box += m_soup.points[v].bbox();
      write_entity(label, box);
      m_out << " 0\n"; // without bounding curves
    }
    Bbox_3 box;
    for (const Point& p : m_soup.points) box += p.bbox();
    write_entity(1, box);
    m_out << ' ' << m_patches.size();
    for (const auto& [label, sides] : m_patches) m_out << ' ' << label;
    m_out << "\n$EndEntities\n";
  }

  // An entity in the physical group of the same number.
  void write_entity(int number, const Bbox_3& box) {
    m_out << number;
    for (double x : {box.xmin(), box.ymin(), box.zmin(), box.xmax(), box.ymax(), box.zmax()})
      m_out << ' ' << x;
    m_out << " 1 " << number;
  }

  void write_nodes() {
    const std::size_t n = m_soup.points.size();
    m_out << "$Nodes\n1 " << n << " 1 " << n << "\n3 1 0 " << n << '\n';
    for (std::size_t v = 1; v <= n; ++v) m_out << v << '\n';
    for (const Point& p : m_soup.points) m_out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    m_out << "$EndNodes\n";
  }

  void write_elements() {
    std::size_t n = m_soup.hexahedra.size();
    for (const auto& [label, sides] : m_patches) n += sides.size();
    m_out << "$Elements\n" << m_patches.size() + 1 << ' ' << n << " 1 " << n << '\n';
    write_block(3, 1, HEXAHEDRON, m_soup.hexahedra.size());
    for (const auto& hexahedron : m_soup.hexahedra) write_element(hexahedron);
    for (const auto& [label, sides] : m_patches) {
      write_block(2, label, QUADRANGLE, sides.size());
      for (const Hexahedron_side& side : sides) write_element(side.vertices);
    }
    m_out << "$EndElements\n";
  }

  void write_block(int dimension, int entity, Element_type type, std::size_t size) {
    m_out << dimension << ' ' << entity << ' ' << int(type) << ' ' << size << '\n';
  }

  template <typename Vertices>
  void write_element(const Vertices& vertices) {
    m_out << ++m_last_element;
    for (std::size_t v : vertices) m_out << ' ' << v + 1;
    m_out << '\n';
  }

  Text_writer m_out;
  const Hexahedron_soup_3<Point>& m_soup;
  const Hexahedron_patches& m_patches;
  std::size_t m_last_element = 0;
};

} // namespace internal

namespace IO {

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes hexahedra and labelled quadrilaterals as an ASCII file of <a href="https://gmsh.info">Gmsh</a>, in version 4.1 of its
format, for finite element programs that read it.

The physical groups are `solid`, which has all hexahedra, and `floor`, `ceiling`, `wall_0`, ... with the quadrilaterals that
are labelled so, turned counterclockwise seen from outside. Nodes and hexahedra keep their order and are counted from 1.
Quadrilaterals with the label 0 are left out. Coordinates of type `double` are read back to the bit.

The function takes \f$ O(n \log n) \f$ time.

\tparam Point a point type of a \cgal kernel

\returns `ERROR_EMPTY_MESH`, `ERROR_INDEX_OUT_OF_RANGE`, `ERROR_COORDINATE_NOT_FINITE`, `ERROR_WRONG_PARAMETER` (a negative
label), `ERROR_LABEL_NOT_ON_BOUNDARY` (also for a quadrilateral that is labelled twice) or `ERROR_CANNOT_WRITE_FILE`
*/
template <typename Point>
Status write_Gmsh(std::ostream& os, const Hexahedron_soup_3<Point>& soup) {
  internal::Hexahedron_patches patches;
  const Status status = internal::find_patches(soup, patches);
  if (!status.ok()) return status;
  internal::Gmsh_writer<Point>(os, soup, patches).write();
  return internal::check_stream(os);
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes the file `filename`, as the function above, under a temporary name first: on failure nothing is changed.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
Status write_Gmsh(const std::string& filename, const Hexahedron_soup_3<Point>& soup) {
  return internal::write_atomically(filename, [&](std::ostream& os) { return write_Gmsh(os, soup); });
}

} // namespace IO
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_GMSH_H
