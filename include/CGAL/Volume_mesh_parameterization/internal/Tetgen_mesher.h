// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TETGEN_MESHER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TETGEN_MESHER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_writer.h>
#include <CGAL/Volume_mesh_parameterization/internal/run_in_child_process.h>

#ifndef TETLIBRARY
#define TETLIBRARY
#endif
#include <tetgen.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Meshes the inside of a surface by TetGen 1.5 (H. Si, ACM TOMS 41(2), 2015). Facet marker i + 1 stands for triangle i,
// so that TetGen neither merges facets nor takes a marker for "none". Where the surface may be meshed anew it stands for label
// i: TetGen merges coplanar triangles with the same label.
//
// TetGen runs in a process of its own: Debian's 1.5.0 frees its memory twice whenever it gives up, and has assertions.
template <typename Point>
class Tetgen_mesher {
public:
  explicit Tetgen_mesher(const Triangle_soup_3<Point>& surface) : m_surface(surface) {}

  // Keeps the surface. A volume of 0 does not bound the cells.
  Status mesh(double maximal_volume, Tetrahedron_soup_3<Point>& soup) const {
    std::ostringstream os;
    {
      Text_writer text(os);
      text << "pq1.4YQ";
      if (maximal_volume > 0) text << 'a' << maximal_volume;
    }
    std::vector<int> markers(m_surface.triangles.size());
    std::iota(markers.begin(), markers.end(), 1);
    Output output;
    const Status status = run(os.str(), markers, output);
    if (status.ok()) soup = make_soup(output);
    return status;
  }

  // Cuts the triangles into parts, those with the same label and in the same plane together, so that none is long and thin. A
  // tighter bound than this makes many more of them.
  Status remesh(Triangle_soup_3<Point>& remeshed) const {
    std::vector<int> markers;
    for (int label : m_surface.labels) markers.push_back(label + 1);
    Output output;
    const Status status = run("pq3Q", markers, output);
    if (!status.ok()) return status;
    remeshed = {};
    remeshed.points = points(output);
    for (std::size_t f = 0; f < output.markers.size(); ++f)
      if (output.markers[f] > 0) {
        std::copy_n(&output.facets[3 * f], 3, remeshed.triangles.emplace_back().begin());
        remeshed.labels.push_back(output.markers[f] - 1);
      }
    return {};
  }

private:
  struct Output {
    std::vector<int> error = {0};
    std::vector<double> coordinates;
    std::vector<int> cells, facets, markers; // 4, 3 and 1 numbers for each
  };

  // p: a piecewise linear complex, q: bound on the radius-edge ratio, Y: the surface stays as it is, a: bound on volumes,
  // Q: silent
  Status run(const std::string& switches, const std::vector<int>& markers, Output& output) const {
    const bool has_ended = run_in_child_process(
        [&](Byte_writer& bytes) {
          const Output found = tetrahedralize(switches, markers);
          bytes << found.error << found.coordinates << found.cells << found.facets << found.markers;
        },
        [&](Byte_reader& bytes) {
          bytes >> output.error >> output.coordinates >> output.cells >> output.facets >> output.markers;
        });
    if (!has_ended) return {ERROR_TETRAHEDRALIZATION, "TetGen crashed, or its process could not be started"};
    if (output.error[0] != 0)
      return {ERROR_TETRAHEDRALIZATION, "TetGen says that " + meaning(output.error[0])};
    return {};
  }

  Output tetrahedralize(std::string switches, const std::vector<int>& markers) const {
    tetgenio in, out;
    Output output;
    fill(markers, in);
    try {
      ::tetrahedralize(switches.data(), &in, &out);
    } catch (int code) {
      output.error = {code};
      return output;
    }
    output.coordinates.assign(out.pointlist, out.pointlist + 3 * out.numberofpoints);
    output.cells.assign(out.tetrahedronlist, out.tetrahedronlist + 4 * out.numberoftetrahedra);
    output.facets.assign(out.trifacelist, out.trifacelist + 3 * out.numberoftrifaces);
    output.markers.assign(out.trifacemarkerlist, out.trifacemarkerlist + out.numberoftrifaces);
    return output;
  }

  static std::string meaning(int code) {
    switch (code) {
    case 1:
      return "it ran out of memory";
    case 3:
      return "the surface intersects itself";
    case 4:
      return "a feature of the surface is too small";
    case 5:
      return "two facets of the surface are too close";
    case 10:
      return "its input is wrong";
    default:
      return "it has an internal error, number " + std::to_string(code);
    }
  }

  // The destructor of tetgenio deletes what is allocated here.
  void fill(const std::vector<int>& markers, tetgenio& in) const {
    in.firstnumber = 0;
    in.numberofpoints = int(m_surface.points.size());
    in.pointlist = new double[3 * m_surface.points.size()];
    double* coordinate = in.pointlist;
    for (const Point& point : m_surface.points) {
      const auto p = approximate(point);
      coordinate = std::copy(p.cartesian_begin(), p.cartesian_end(), coordinate);
    }
    in.numberoffacets = int(m_surface.triangles.size());
    in.facetlist = new tetgenio::facet[m_surface.triangles.size()];
    in.facetmarkerlist = new int[m_surface.triangles.size()];
    std::copy(markers.begin(), markers.end(), in.facetmarkerlist);
    for (int t = 0; t < in.numberoffacets; ++t) fill(in.facetlist[t], m_surface.triangles[std::size_t(t)]);
  }

  static void fill(tetgenio::facet& facet, const std::array<std::size_t, 3>& triangle) {
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::polygon& polygon = facet.polygonlist[0];
    tetgenio::init(&polygon);
    polygon.numberofvertices = 3;
    polygon.vertexlist = new int[3];
    std::copy(triangle.begin(), triangle.end(), polygon.vertexlist);
  }

  std::vector<Point> points(const Output& output) const {
    std::vector<Point> all = m_surface.points; // TetGen appends its points to these
    for (std::size_t i = 3 * all.size(); i < output.coordinates.size(); i += 3)
      all.emplace_back(output.coordinates[i], output.coordinates[i + 1], output.coordinates[i + 2]);
    return all;
  }

  Tetrahedron_soup_3<Point> make_soup(const Output& output) const {
    Tetrahedron_soup_3<Point> soup;
    soup.points = points(output);
    for (std::size_t i = 0; i < output.cells.size(); i += 4)
      std::copy_n(&output.cells[i], 4, soup.cells.emplace_back().begin());
    for (std::size_t f = 0; f < output.markers.size(); ++f) {
      if (output.markers[f] <= 0) continue;
      Labelled_facet& facet = soup.facets.emplace_back();
      std::copy_n(&output.facets[3 * f], 3, facet.vertices.begin());
      const int triangle = output.markers[f] - 1;
      facet.label = m_surface.labels.empty() ? triangle : m_surface.labels[std::size_t(triangle)];
    }
    orient_cells(soup);
    return soup;
  }

  const Triangle_soup_3<Point>& m_surface;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TETGEN_MESHER_H
