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
#include <CGAL/Volume_mesh_parameterization/internal/Foldover_free_energy.h>
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
A map of the vertices of a solid, with the boundary fixed, that is to have no flipped tetrahedron. Edges may be bisected on
the way; the sweep order goes along.
*/
template <typename GeomTraits>
class Interior_mapper {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Position = Eigen::Vector3d;

  Interior_mapper(const Mesh& mesh, const std::vector<Cell_index>& order) : m_refinable(mesh, order) {
    for (const auto& p : mesh.points()) m_points.push_back(position(p));
    m_images.assign(m_points.size(), Position::Zero());
    m_is_fixed.assign(m_points.size(), 0);
    for (Facet_index f : mesh.boundary_facets())
      for (Vertex_index v : mesh.vertices(f)) m_is_fixed[v] = 1;
  }

  const Splittable_mesh<GeomTraits>& mesh() const { return m_refinable.mesh(); }
  const std::vector<Position>& images() const { return m_images; }
  const std::vector<std::array<Vertex_index, 2>>& bisected_edges() const { return m_bisected_edges; }
  // Newton steps of cells so far.
  double work() const { return m_work; }
  bool is_fixed(std::size_t v) const { return m_is_fixed[v] != 0; }
  void set_image(std::size_t v, const Position& image) { m_images[v] = image; }

  // The midpoint is fixed if the edge is on the boundary.
  Status bisect(Vertex_index a, Vertex_index b) {
    const bool on_boundary = is_boundary_edge(a, b);
    const Status status = m_refinable.bisect(a, b);
    if (!status.ok()) return status;
    m_points.push_back((m_points[a] + m_points[b]) / 2);
    m_images.push_back((m_images[a] + m_images[b]) / 2);
    m_is_fixed.push_back(on_boundary);
    m_bisected_edges.push_back({a, b});
    return status;
  }

  // Cells whose image is flipped or flat, by exact signs.
  std::vector<Cell_index> find_flipped() const {
    std::vector<Cell_index> flipped;
    for (std::size_t c = 0; c < mesh().number_of_cells(); ++c)
      if (!is_positive(Cell_index(c))) flipped.emplace_back(c);
    return flipped;
  }

  bool is_positive(Cell_index c) const {
    using Kernel = Exact_predicates_inexact_constructions_kernel;
    const auto& v = mesh().cell(c);
    const auto at = [&](int i) {
      return Kernel::Point_3(m_images[v[i]][0], m_images[v[i]][1], m_images[v[i]][2]);
    };
    return CGAL::orientation(at(0), at(1), at(2), at(3)) == POSITIVE;
  }

  // Moves the vertices inside to where the harmonic map takes them.
  Status start_harmonically() {
    std::vector<std::uint32_t> row(m_points.size());
    std::uint32_t n = 0;
    for (std::size_t v = 0; v < row.size(); ++v) row[v] = m_is_fixed[v] ? 0 : n++;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n, 3), start(n, 3);
    for (std::size_t c = 0; c < mesh().number_of_cells(); ++c) {
      const auto& cell = mesh().cell(Cell_index(c));
      const Cell_gradients g({point(cell[0]), point(cell[1]), point(cell[2]), point(cell[3])});
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
          if (m_is_fixed[cell[i]]) continue;
          const double k = g.volume * (g.gradients[i] * g.gradients[j]);
          if (m_is_fixed[cell[j]])
            right.row(row[cell[i]]) -= k * m_images[cell[j]].transpose();
          else
            entries.emplace_back(row[cell[i]], row[cell[j]], k);
        }
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(matrix);
    const Eigen::MatrixX3d x = solver.solve(right);
    if (solver.info() != Eigen::Success) return {ERROR_CANNOT_SOLVE, "harmonic map of the interior"};
    for (std::size_t v = 0; v < row.size(); ++v)
      if (!m_is_fixed[v]) m_images[v] = x.row(row[v]).transpose();
    return {};
  }

  bool is_boundary_edge(Vertex_index a, Vertex_index b) const {
    if (!m_is_fixed[a] || !m_is_fixed[b]) return false;
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

  // Moves the vertices inside of some cells so that fewer of these are flipped; returns how many are left.
  std::size_t untangle(const std::vector<Cell_index>& cells, Start start, int most_rounds) {
    constexpr double epsilon = 0.3; // at first
    Part part(*this, cells);
    const std::size_t before = count_flipped(cells);
    if (part.number_of_free() == 0) return before;
    if (start == SMOOTHED) part.smooth();
    Foldover_free_energy energy = part.energy();
    energy.untangle(epsilon, most_rounds);
    m_work += double(energy.number_of_steps()) * double(cells.size());
    const std::vector<Position> old = part.swap_images(*this);
    const std::size_t after = count_flipped(cells);
    if (after < before) return after;
    part.restore(*this, old);
    return before;
  }

  std::size_t count_flipped(const std::vector<Cell_index>& cells) const {
    return std::count_if(cells.begin(), cells.end(), [this](Cell_index c) { return !is_positive(c); });
  }

  // Less distortion of some cells, all positive, which they stay.
  void polish(const std::vector<Cell_index>& cells, int most_steps) {
    Part part(*this, cells);
    if (part.number_of_free() == 0) return;
    part.energy().polish(most_steps);
    const std::vector<Position> old = part.swap_images(*this);
    if (count_flipped(cells) > 0) part.restore(*this, old);
  }

  // The energy of each cell: 3.2 without distortion, infinite if flipped.
  std::vector<double> energies() const {
    std::vector<Cell_index> cells;
    for (std::size_t c = 0; c < mesh().number_of_cells(); ++c) cells.emplace_back(c);
    Part part(*this, cells);
    Foldover_free_energy energy = part.energy();
    energy.polish(0);
    std::vector<double> result;
    for (Cell_index c : cells) result.push_back(energy.value(c));
    return result;
  }

  Status write_to(Mesh& mesh, std::vector<Cell_index>& order) && {
    return std::move(m_refinable).write_to(mesh, order);
  }

private:
  // Some cells with their own numbers.
  class Part {
  public:
    Part(const Interior_mapper& mapper, const std::vector<Cell_index>& cells) {
      for (Cell_index c : cells)
        for (Vertex_index v : mapper.mesh().cell(c)) m_vertices.push_back(v);
      std::sort(m_vertices.begin(), m_vertices.end());
      m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());
      for (Vertex_index v : m_vertices) {
        m_rest.push_back(mapper.m_points[v]);
        m_positions.push_back(mapper.m_images[v]);
      }
      std::vector<std::size_t> degree(m_vertices.size(), 0);
      for (Cell_index c : cells) {
        m_cells.emplace_back();
        for (int i = 0; i < 4; ++i) ++degree[m_cells.back()[i] = number(mapper.mesh().cell(c)[i])];
      }
      for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        const Vertex_index v = m_vertices[i];
        m_is_free.push_back(!mapper.is_fixed(v) && degree[i] == mapper.mesh().star(v).size());
      }
    }

    std::size_t number_of_free() const { return std::count(m_is_free.begin(), m_is_free.end(), 1); }
    Foldover_free_energy energy() { return {m_cells, m_rest, m_is_free, m_positions}; }

    // Moves each free vertex to the mean of its neighbors, again and again: far from where it was tangled.
    void smooth() {
      constexpr int sweeps = 50;
      std::vector<Position> sums(m_vertices.size());
      std::vector<int> counts(m_vertices.size());
      for (int k = 0; k < sweeps; ++k) {
        std::fill(sums.begin(), sums.end(), Position::Zero());
        std::fill(counts.begin(), counts.end(), 0);
        for (const auto& cell : m_cells)
          for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
              if (i == j) continue;
              sums[cell[i]] += m_positions[cell[j]];
              ++counts[cell[i]];
            }
        for (std::size_t v = 0; v < m_vertices.size(); ++v)
          if (m_is_free[v]) m_positions[v] = sums[v] / counts[v];
      }
    }

    // Writes the positions to the map; returns the old ones.
    std::vector<Position> swap_images(Interior_mapper& mapper) const {
      std::vector<Position> old;
      for (std::size_t i = 0; i < m_vertices.size(); ++i) {
        old.push_back(mapper.m_images[m_vertices[i]]);
        mapper.m_images[m_vertices[i]] = m_positions[i];
      }
      return old;
    }

    void restore(Interior_mapper& mapper, const std::vector<Position>& old) const {
      for (std::size_t i = 0; i < m_vertices.size(); ++i) mapper.m_images[m_vertices[i]] = old[i];
    }

  private:
    std::uint32_t number(Vertex_index v) const {
      return std::uint32_t(std::lower_bound(m_vertices.begin(), m_vertices.end(), v) - m_vertices.begin());
    }

    std::vector<Vertex_index> m_vertices;
    std::vector<Position> m_rest, m_positions;
    std::vector<Foldover_free_energy::Cell> m_cells;
    std::vector<char> m_is_free;
  };

  template <typename Point>
  static Position position(const Point& p) {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }
  Double_kernel::Point_3 point(Vertex_index v) const {
    return {m_points[v][0], m_points[v][1], m_points[v][2]};
  }

  Refinable_order<GeomTraits> m_refinable;
  std::vector<Position> m_points, m_images; // of the vertices
  std::vector<char> m_is_fixed;             // vertices on the boundary
  std::vector<std::array<Vertex_index, 2>> m_bisected_edges;
  double m_work = 0;
  std::vector<char> m_is_in; // cells, scratch
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INTERIOR_MAPPER_H
