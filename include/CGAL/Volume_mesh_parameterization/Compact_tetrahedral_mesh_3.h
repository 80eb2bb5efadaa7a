// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPACT_TETRAHEDRAL_MESH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_COMPACT_TETRAHEDRAL_MESH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Facet_numbering.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/range/irange.hpp>
#include <boost/range/adaptor/transformed.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMesh

is the mesh that all stages work on: flat arrays with 32-bit indices, facets numbered once, the facets of the
boundary first, each with a label.

Facet `i` of a cell is the one opposite to its vertex `i`. Cells are positively oriented.

\cgalModels{TetrahedralMesh_3}

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Compact_tetrahedral_mesh_3 {
public:
  using Geom_traits = GeomTraits;               ///< a model of `VolumeParameterizationTraits_3`
  using FT = typename GeomTraits::FT;           ///< the number type
  using Point_3 = typename GeomTraits::Point_3; ///< the point type

  /// The most cells that there may be: 32 bits number the six edges of each.
  static constexpr std::size_t most_cells = std::numeric_limits<std::uint32_t>::max() / 6;
  /// The vertices of the facet opposite to vertex `i`, counterclockwise seen from outside of a positive cell.
  static constexpr int facet_vertices[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  /// The two ends of each of the six edges of a cell.
  static constexpr int edge_vertices[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

  using Cell_vertices = std::array<Vertex_index, 4>; ///< the vertices of a cell
  using Cell_labels = std::array<int, 4>;            ///< the labels of the facets of a cell
  /// An edge, a facet or a cell: two to four vertices, then invalid ones.
  using Simplex = std::array<Vertex_index, 4>;

  /// \name Construction
  /// @{

  /// copies `mesh` and its labels, in linear time for vertices of bounded degree. Indices are checked, geometry and
  /// topology are not: see `check_tetrahedral_mesh()`. The numbers of facets do not depend on whether `mesh` knows neighbors.
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it
  /// \tparam TetrahedralMesh a model of `TetrahedralMesh_3`
  /// \returns `ERROR_EMPTY_MESH`, `ERROR_WRONG_PARAMETER` (more than `most_cells`, or as many vertices; a neighbor that is
  /// none), `ERROR_INDEX_OUT_OF_RANGE`, `ERROR_NON_MANIFOLD` (a facet in three cells, or in two that are no neighbors) or
  /// `ERROR_LABEL_NOT_ON_BOUNDARY`; then the mesh is left empty
  template <typename ConcurrencyTag = Sequential_tag, typename TetrahedralMesh>
  Status assign(const TetrahedralMesh& mesh) {
    std::vector<std::uint32_t> opposites;
    Status status = copy(mesh);
    if constexpr (internal::Knows_neighbors<TetrahedralMesh>::value) // an optional operation of the concept
      if (status.ok()) status = read_neighbors(mesh, opposites);
    if (status.ok()) status = number_facets<ConcurrencyTag>(opposites);
    if (status.ok()) status = read_labels(mesh.labelled_facets());
    if (!status.ok()) *this = Compact_tetrahedral_mesh_3();
    return status;
  }

  /// copies a mesh of the same type, facets and all; its vertices count as given.
  /// \tparam ConcurrencyTag as above
  template <typename ConcurrencyTag = Sequential_tag>
  Status assign(const Compact_tetrahedral_mesh_3& mesh) {
    *this = mesh;
    m_split_simplices.clear();
    return m_cells.empty() ? Status(ERROR_EMPTY_MESH, "it has no tetrahedra") : Status();
  }

  /// takes points, cells, the label of each facet of each cell (0 in the interior) and the simplices whose barycentres
  /// the last points are.
  /// \tparam ConcurrencyTag as above
  /// \pre the four vertices of a cell are different, and less than the number of points
  /// \returns `ERROR_WRONG_PARAMETER` (more than `most_cells`, or as many vertices) or `ERROR_NON_MANIFOLD`; then the mesh is
  /// left empty
  template <typename ConcurrencyTag = Sequential_tag>
  Status assign(std::vector<Point_3> points, std::vector<Cell_vertices> cells, const std::vector<Cell_labels>& labels,
                std::vector<Simplex> split_simplices = {}) {
    m_points = std::move(points);
    m_cells = std::move(cells);
    m_split_simplices = std::move(split_simplices);
    Status status = check_size(m_points.size(), m_cells.size());
    if (status.ok()) status = number_facets<ConcurrencyTag>({});
    if (status.ok())
      for (Facet_index f : boundary_facets()) set_label(f, labels[half_facet(f).cell][half_facet(f).index]);
    else
      *this = Compact_tetrahedral_mesh_3();
    return status;
  }

  /// labels a facet of the boundary: 1 floor, 2 ceiling, 3 + k wall k, 0 none.
  void set_label(Facet_index boundary_facet, int label) { m_labels[boundary_facet] = label; }

  /// @}
  /// \name Elements
  /// @{

  /// returns the number of vertices.
  std::size_t number_of_vertices() const { return m_points.size(); }
  /// returns the number of tetrahedra.
  std::size_t number_of_cells() const { return m_cells.size(); }
  /// returns the number of triangles, those inside included.
  std::size_t number_of_facets() const { return m_half_facets.size(); }
  /// returns the number of triangles on the boundary.
  std::size_t number_of_boundary_facets() const { return m_labels.size(); }

  /// returns the range of all vertices.
  auto vertices() const { return indices<Vertex_index>(number_of_vertices()); }
  /// returns the range of all cells.
  auto cells() const { return indices<Cell_index>(number_of_cells()); }
  /// returns the range of all facets, those of the boundary first.
  auto facets() const { return indices<Facet_index>(number_of_facets()); }
  /// returns the range of the facets of the boundary.
  auto boundary_facets() const { return indices<Facet_index>(number_of_boundary_facets()); }

  /// returns the position of a vertex.
  const Point_3& point(std::size_t vertex) const { return m_points[vertex]; }
  /// returns the positions of all vertices.
  const std::vector<Point_3>& points() const { return m_points; }
  /// returns the simplices that refinement has split. Their barycentres are the last vertices, in the same order.
  const std::vector<Simplex>& split_simplices() const { return m_split_simplices; }
  /// returns the vertices of a cell.
  const Cell_vertices& cell(std::size_t c) const { return m_cells[c]; }
  /// returns vertex `i` of `c`.
  Vertex_index vertex(Cell_index c, int i) const { return m_cells[c][i]; }
  /// returns the facet of `c` opposite to its vertex `i`.
  Facet_index facet(Cell_index c, int i) const { return m_cell_facets[c][i]; }

  /// @}
  /// \name Adjacency
  /// @{

  /// returns whether `f` is a facet of one cell only.
  bool is_boundary(Facet_index f) const { return f < m_labels.size(); }

  /// returns the facet `f` seen from one of its cells; `side` 1 exists for interior facets only.
  Half_facet half_facet(Facet_index f, int side = 0) const { return unpack(m_half_facets[f][side]); }

  /// returns the same facet seen from the other cell, whose index is invalid on the boundary.
  Half_facet opposite(Half_facet h) const {
    const Half_facets& sides = m_half_facets[m_cell_facets[h.cell][h.index]];
    return unpack(sides[0] == pack(h) ? sides[1] : sides[0]);
  }

  /// returns the cell behind facet `i` of `c`, an invalid one on the boundary.
  Cell_index neighbor(Cell_index c, int i) const { return opposite({c, i}).cell; }
  /// returns the same as a number.
  std::size_t neighbor(std::size_t c, int i) const { return neighbor(Cell_index(c), i); }

  /// returns the vertices of `f`, counterclockwise seen from outside of the cell of `half_facet(f)`.
  std::array<Vertex_index, 3> vertices(Facet_index f) const { return vertices(half_facet(f)); }
  /// returns the vertices of the facet, counterclockwise seen from outside of the cell of `h`.
  std::array<Vertex_index, 3> vertices(Half_facet h) const {
    const int* v = facet_vertices[h.index];
    return {m_cells[h.cell][v[0]], m_cells[h.cell][v[1]], m_cells[h.cell][v[2]]};
  }

  /// returns which vertex of `c` is `v`, or -1.
  int index(Cell_index c, Vertex_index v) const {
    for (int i = 0; i < 4; ++i)
      if (m_cells[c][i] == v) return i;
    return -1;
  }

  /// @}
  /// \name Labels
  /// @{

  /// returns the label of a facet, `INTERIOR` if it is not on the boundary.
  int label(Facet_index f) const { return is_boundary(f) ? m_labels[f] : int(INTERIOR); }
  /// returns the label of facet `i` of `c`.
  int label(Cell_index c, int i) const { return label(facet(c, i)); }

  /// returns a range of `Labelled_facet`, one for each boundary facet.
  auto labelled_facets() const {
    return boundary_facets() | boost::adaptors::transformed([this](Facet_index f) {
             const auto v = vertices(f);
             return Labelled_facet{{v[0], v[1], v[2]}, label(f)};
           });
  }
  /// @}

private:
  static constexpr std::uint32_t none = internal::Facet_numbering::none;
  using Half_facets = std::array<std::uint32_t, 2>;  // both sides of a facet, packed; on the boundary the second is `none`
  using Sorted_facet = std::array<std::uint32_t, 4>; // three vertices in increasing order, and the facet

  static std::uint32_t pack(Half_facet h) { return 4 * h.cell + h.index; }
  static Half_facet unpack(std::uint32_t h) {
    return h == none ? Half_facet{} : Half_facet{Cell_index(h / 4), int(h % 4)};
  }

  template <typename Index>
  static auto indices(std::size_t n) {
    return boost::irange(std::size_t(0), n) |
           boost::adaptors::transformed([](std::size_t i) { return Index(i); });
  }

  static Status check_size(std::size_t number_of_vertices, std::size_t number_of_cells) {
    const std::size_t size = (std::max)(number_of_vertices, number_of_cells);
    if (size <= most_cells) return {};
    return {ERROR_WRONG_PARAMETER, std::to_string(size) + " vertices or tetrahedra, more than " + std::to_string(most_cells)};
  }

  template <typename TetrahedralMesh>
  Status copy(const TetrahedralMesh& mesh) {
    const std::size_t nv = mesh.number_of_vertices(), nc = mesh.number_of_cells();
    if (nc == 0) return {ERROR_EMPTY_MESH, "it has no tetrahedra"};
    const Status status = check_size(nv, nc);
    if (!status.ok()) return status;
    m_split_simplices.clear();
    m_points.clear();
    m_points.reserve(nv);
    for (std::size_t v = 0; v < nv; ++v) m_points.push_back(mesh.point(v));
    m_cells.resize(nc);
    for (std::size_t c = 0; c < nc; ++c)
      for (int i = 0; i < 4; ++i) {
        const std::size_t v = mesh.cell(c)[i];
        if (v >= nv || std::find(m_cells[c].begin(), m_cells[c].begin() + i, Vertex_index(v)) != m_cells[c].begin() + i)
          return {ERROR_INDEX_OUT_OF_RANGE, "tetrahedron " + std::to_string(c) + " names vertex " + std::to_string(v)};
        m_cells[c][i] = Vertex_index(v);
      }
    return {};
  }

  static Sorted_facet sorted(std::array<Vertex_index, 3> v, std::uint32_t facet) {
    std::sort(v.begin(), v.end());
    return {v[0], v[1], v[2], facet};
  }

  static bool same_facet(const Sorted_facet& a, const Sorted_facet& b) {
    return std::equal(a.begin(), a.begin() + 3, b.begin());
  }

  // The other side of each half-facet as the mesh tells it; checked.
  template <typename TetrahedralMesh>
  Status read_neighbors(const TetrahedralMesh& mesh, std::vector<std::uint32_t>& opposites) const {
    opposites.assign(4 * number_of_cells(), none);
    for (Cell_index c : cells())
      for (int i = 0; i < 4; ++i) {
        const std::size_t n = mesh.neighbor(std::size_t(c), i);
        if (n < number_of_cells()) opposites[pack({c, i})] = half_facet_behind({c, i}, Cell_index(n));
      }
    for (std::uint32_t h = 0; h < opposites.size(); ++h)
      if (opposites[h] != none && (opposites[h] == h || opposites[opposites[h]] != h))
        return {ERROR_WRONG_PARAMETER, "the neighbor of tetrahedron " + std::to_string(h / 4) + " opposite to its vertex " +
                                           std::to_string(h % 4) + " does not share that facet with it"};
    return {};
  }

  // The facet of `cell` with the vertices of `h`; `h` itself if there is none.
  std::uint32_t half_facet_behind(Half_facet h, Cell_index cell) const {
    const auto v = vertices(h);
    std::uint32_t result = pack(h);
    int number_of_others = 0;
    for (int j = 0; j < 4; ++j) {
      if (std::find(v.begin(), v.end(), m_cells[cell][j]) != v.end()) continue;
      result = pack({cell, j});
      ++number_of_others;
    }
    return number_of_others == 1 ? result : pack(h);
  }

  // `opposites` is empty if unknown.
  template <typename ConcurrencyTag>
  Status number_facets(const std::vector<std::uint32_t>& opposites) {
    internal::Facet_numbering numbering(m_cells, number_of_vertices(), opposites, ConcurrencyTag());
    if (!numbering.status().ok()) return numbering.status();
    m_labels.assign(numbering.number_of_boundary_facets(), INTERIOR);
    m_half_facets = std::move(numbering).take_sides();
    m_cell_facets.resize(m_cells.size());
    const auto number_sides = [this](std::size_t f) {
      for (std::uint32_t h : m_half_facets[f])
        if (h != none) m_cell_facets[h / 4][h % 4] = Facet_index(f);
    };
    internal::for_each_index<ConcurrencyTag>(m_half_facets.size(), number_sides, 8192);
    return {};
  }

  template <typename Range>
  Status read_labels(const Range& labelled_facets) {
    std::vector<Sorted_facet> boundary;
    for (Facet_index f : boundary_facets()) boundary.push_back(sorted(vertices(f), f));
    std::size_t k = 0;
    for (const Labelled_facet& given : labelled_facets) {
      const auto& v = given.vertices;
      const Sorted_facet key = sorted({Vertex_index(v[0]), Vertex_index(v[1]), Vertex_index(v[2])}, 0);
      const auto found = std::lower_bound(boundary.begin(), boundary.end(), key);
      const bool exists = (std::max)({v[0], v[1], v[2]}) < number_of_vertices() && found != boundary.end() && same_facet(*found, key);
      if (!exists || (m_labels[(*found)[3]] != INTERIOR && m_labels[(*found)[3]] != given.label))
        return {ERROR_LABEL_NOT_ON_BOUNDARY, "triangle " + std::to_string(k) + " with vertices " + std::to_string(v[0]) +
                                                 ", " + std::to_string(v[1]) + ", " + std::to_string(v[2])};
      m_labels[(*found)[3]] = given.label;
      ++k;
    }
    return {};
  }

  std::vector<Point_3> m_points;
  std::vector<Simplex> m_split_simplices;
  std::vector<Cell_vertices> m_cells;
  std::vector<std::array<Facet_index, 4>> m_cell_facets;
  std::vector<Half_facets> m_half_facets;
  std::vector<int> m_labels;                               // of the boundary facets
};

/*!
\ingroup PkgVolumeMeshParameterizationMesh

returns `mesh` as a soup with the label of every boundary facet.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
Tetrahedron_soup_3<typename GeomTraits::Point_3> make_soup(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  Tetrahedron_soup_3<typename GeomTraits::Point_3> soup;
  soup.points = mesh.points();
  for (Cell_index c : mesh.cells()) {
    const auto& v = mesh.cell(c);
    soup.cells.push_back({v[0], v[1], v[2], v[3]});
  }
  for (const Labelled_facet& f : mesh.labelled_facets()) soup.facets.push_back(f);
  return soup;
}

namespace internal {

using Double_kernel = Simple_cartesian<double>;

template <typename Point>
Double_kernel::Point_3 approximate(const Point& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_COMPACT_TETRAHEDRAL_MESH_3_H
