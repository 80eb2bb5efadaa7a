// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INTERIOR_MAPPER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INTERIOR_MAPPER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>
#include <CGAL/Volume_mesh_parameterization/internal/Map_part.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinable_order.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
A map of the vertices of a solid, with the boundary given, that is to have no flipped tetrahedron. Edges and
facets may be split on the way; the sweep order goes along.
*/
template <typename GeomTraits>
class Interior_mapper {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Position = Eigen::Vector3d;
  using Freedom = Foldover_free_energy::Freedom;
  using Part = Map_part<GeomTraits>;
  using Boundary = typename Part::Boundary;

  Interior_mapper(const Mesh& mesh, const std::vector<Cell_index>& order) : m_refinable(mesh, order) {
    for (const auto& p : mesh.points()) m_points.push_back(position(p));
    m_images.assign(m_points.size(), Position::Zero());
    m_freedoms.assign(m_points.size(), Foldover_free_energy::free);
    for (Facet_index f : mesh.boundary_facets())
      for (Vertex_index v : mesh.vertices(f)) m_freedoms[v] = Foldover_free_energy::fixed;
  }

  const Splittable_mesh<GeomTraits>& mesh() const { return m_refinable.mesh(); }
  const std::vector<Position>& images() const { return m_images; }
  // Newton steps of cells so far.
  double work() const { return m_work; }
  bool is_inside(std::size_t v) const { return m_freedoms[v] == Foldover_free_energy::free; }
  bool may_slide() const { return m_may_slide; }
  void set_image(std::size_t v, const Position& image) { m_images[v] = image; }

  // Lets the vertices of the walls and of the ceiling slide in the planes where their images are, but for those on creases: then
  // the map of the boundary stays one to one as long as no tetrahedron is flipped.
  void release_boundary() {
    m_may_slide = true;
    for (std::size_t v = 0; v < m_freedoms.size(); ++v)
      if (!is_inside(v)) m_freedoms[v] = Foldover_free_energy::free;
    for (std::size_t c = 0; c < mesh().number_of_cells(); ++c)
      for (int i = 0; i < 4; ++i) hold_facet(Cell_index(c), i);
    for (Freedom& freedom : m_freedoms)
      if ((freedom & (freedom - 1)) == 0) freedom = Foldover_free_energy::fixed;
  }

  // The midpoint is fixed if the edge is on the boundary.
  Status bisect(Vertex_index a, Vertex_index b) {
    return insert_barycentre({a, b}, is_boundary_edge(a, b) ? Foldover_free_energy::fixed : Foldover_free_energy::free);
  }
  // Of an edge, a facet or a cell that is not on the boundary.
  Status insert_inside(const std::vector<Vertex_index>& simplex) {
    return insert_barycentre(simplex, Foldover_free_energy::free);
  }

  static Position mean(const std::vector<Position>& positions, const std::vector<Vertex_index>& simplex) {
    Position sum = Position::Zero();
    for (Vertex_index v : simplex) sum += positions[v];
    return sum / double(simplex.size());
  }

  static Orientation orientation(const std::array<Position, 4>& p) {
    using Kernel = Exact_predicates_inexact_constructions_kernel;
    const auto at = [&](int i) { return Kernel::Point_3(p[i][0], p[i][1], p[i][2]); };
    return CGAL::orientation(at(0), at(1), at(2), at(3));
  }

  std::array<Position, 4> images(Cell_index c) const {
    const auto& v = mesh().cell(c);
    return {m_images[v[0]], m_images[v[1]], m_images[v[2]], m_images[v[3]]};
  }

  Position middle(Cell_index c) const {
    const auto& v = mesh().cell(c);
    return mean(m_images, {v.begin(), v.end()});
  }

  // Cells whose image is flipped or flat, by exact signs.
  std::vector<Cell_index> find_flipped() const {
    std::vector<Cell_index> flipped;
    for (std::size_t c = 0; c < mesh().number_of_cells(); ++c)
      if (!is_positive(Cell_index(c))) flipped.emplace_back(c);
    return flipped;
  }

  bool is_positive(Cell_index c) const { return orientation(images(c)) == POSITIVE; }

  // Moves the vertices inside to where the harmonic map takes them. Returns false if its equations cannot be solved.
  bool start_harmonically() {
    std::vector<std::uint32_t> row(m_points.size());
    std::uint32_t n = 0;
    for (std::size_t v = 0; v < row.size(); ++v) row[v] = is_inside(v) ? n++ : 0;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n, 3), start(n, 3);
    for (std::size_t c = 0; c < mesh().number_of_cells(); ++c) {
      const auto& cell = mesh().cell(Cell_index(c));
      const Cell_gradients g({point(cell[0]), point(cell[1]), point(cell[2]), point(cell[3])});
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
          if (!is_inside(cell[i])) continue;
          const double k = g.volume * (g.gradients[i] * g.gradients[j]);
          if (!is_inside(cell[j]))
            right.row(row[cell[i]]) -= k * m_images[cell[j]].transpose();
          else
            entries.emplace_back(row[cell[i]], row[cell[j]], k);
        }
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(matrix);
    const Eigen::MatrixX3d x = solver.solve(right);
    if (solver.info() != Eigen::Success) return false;
    for (std::size_t v = 0; v < row.size(); ++v)
      if (is_inside(v)) m_images[v] = x.row(row[v]).transpose();
    return true;
  }

  bool is_boundary_edge(Vertex_index a, Vertex_index b) const {
    if (is_inside(a) || is_inside(b)) return false;
    for (Cell_index c : mesh().star(a))
      for (int i = 0; i < 4; ++i) {
        const auto& cell = mesh().cell(c);
        const bool has_b = std::find(cell.begin(), cell.end(), b) != cell.end();
        if (has_b && mesh().labels(c)[i] != INTERIOR && cell[i] != a && cell[i] != b) return true;
      }
    return false;
  }

  // The cells around the vertices of the given ones are added `rings` times.
  std::vector<Cell_index> neighborhood(std::vector<Cell_index> cells, int rings) {
    m_is_in.resize(mesh().number_of_cells(), 0);
    for (Cell_index c : cells) m_is_in[c] = 1;
    for (int r = 0; r < rings; ++r) {
      const std::size_t size = cells.size();
      for (std::size_t i = 0; i < size; ++i)
        for (Vertex_index v : mesh().cell(cells[i]))
          for (Cell_index d : mesh().star(v))
            if (!m_is_in[d]) {
              m_is_in[d] = 1;
              cells.push_back(d);
            }
    }
    for (Cell_index c : cells) m_is_in[c] = 0;
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  enum Start { AS_IT_IS, SMOOTHED };

  // Moves the vertices of some cells so that fewer of these are flipped; returns how many are left.
  std::size_t untangle(const std::vector<Cell_index>& cells, Start start, Boundary boundary) {
    Part tangled = part(cells, boundary);
    const std::size_t before = count_flipped(cells);
    if (start == SMOOTHED) tangled.smooth();
    untangle(tangled);
    tangled.swap(m_images);
    const std::size_t after = count_flipped(cells);
    if (after < before) return after;
    tangled.swap(m_images);
    return before;
  }

  // Moves the vertices of some cells, also on the boundary if that may slide, to where they are less squeezed. More cells may be
  // flipped then.
  void relax(const std::vector<Cell_index>& cells) {
    constexpr int most_steps = 20;
    Part squeezed = part(cells, Part::SLIDING);
    Foldover_free_energy energy = squeezed.energy(Model_shape::AS_AROUND);
    energy.relax(first_epsilon, most_steps);
    add_work(energy, squeezed);
    squeezed.swap(m_images);
  }

  std::size_t count_flipped(const std::vector<Cell_index>& cells) const {
    return std::count_if(cells.begin(), cells.end(), [this](Cell_index c) { return !is_positive(c); });
  }

  // Less distortion of some cells, all positive, which they stay.
  void polish(const std::vector<Cell_index>& cells, int most_steps) {
    Part distorted = part(cells, Part::SLIDING);
    distorted.energy(Model_shape::AT_REST).polish(most_steps);
    distorted.swap(m_images);
    if (count_flipped(cells) > 0) distorted.swap(m_images);
  }

  // The energy of each cell: 3.2 without distortion, infinite if flipped.
  std::vector<double> energies() const {
    std::vector<Cell_index> cells;
    for (std::size_t c = 0; c < mesh().number_of_cells(); ++c) cells.emplace_back(c);
    Part whole = part(cells, Part::SLIDING);
    Foldover_free_energy energy = whole.energy(Model_shape::AT_REST);
    energy.polish(0);
    std::vector<double> result;
    for (Cell_index c : cells) result.push_back(energy.value(c));
    return result;
  }

  Status write_to(Mesh& mesh, std::vector<Cell_index>& order) && {
    return std::move(m_refinable).write_to(mesh, order);
  }

private:
  static constexpr double first_epsilon = 0.3; // of the foldover-free energy

  Status insert_barycentre(const std::vector<Vertex_index>& simplex, Freedom freedom) {
    const Status status = m_refinable.insert_barycentre(simplex);
    if (!status.ok()) return status;
    m_points.push_back(mean(m_points, simplex));
    m_images.push_back(mean(m_images, simplex));
    m_freedoms.push_back(freedom);
    return status;
  }

  void hold_facet(Cell_index c, int i) {
    const int label = mesh().labels(c)[i];
    if (label == INTERIOR) return;
    const auto& cell = mesh().cell(c);
    const std::array<Vertex_index, 3> v{cell[(i + 1) % 4], cell[(i + 2) % 4], cell[(i + 3) % 4]};
    for (int k = 0; k < 3; ++k)
      if (label == FLOOR ||
          (m_images[v[0]][k] == m_images[v[1]][k] && m_images[v[1]][k] == m_images[v[2]][k]))
        for (Vertex_index w : v) m_freedoms[w] &= Freedom(~(1 << k));
  }

  Part part(const std::vector<Cell_index>& cells, Boundary boundary) const {
    return {mesh(), cells, m_points, m_images, m_freedoms, boundary};
  }

  void untangle(Part& part) {
    constexpr int most_rounds = 40;
    Foldover_free_energy energy = part.energy(Model_shape::AS_AROUND);
    energy.untangle(first_epsilon, most_rounds);
    add_work(energy, part);
  }

  void add_work(const Foldover_free_energy& energy, const Part& part) {
    m_work += double(energy.number_of_steps()) * double(part.cells().size());
  }

  template <typename Point>
  static Position position(const Point& p) {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }
  Double_kernel::Point_3 point(Vertex_index v) const {
    return {m_points[v][0], m_points[v][1], m_points[v][2]};
  }

  Refinable_order<GeomTraits> m_refinable;
  std::vector<Position> m_points, m_images; // of the vertices
  std::vector<Freedom> m_freedoms;          // of the vertices
  bool m_may_slide = false;                 // on the boundary
  double m_work = 0;
  std::vector<char> m_is_in; // cells, scratch
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INTERIOR_MAPPER_H
