#ifndef HANDLEBODY_MPI_DISTRIBUTED_MESH_H
#define HANDLEBODY_MPI_DISTRIBUTED_MESH_H

#include "../types.h"
#include "petsc_call.h"

#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>

#include <petscdmplex.h>
#include <petscsf.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

// A tetrahedral mesh whose cells are divided among the processes of PETSc, each of which also knows the cells behind its
// facets. PETSc's DMPlex numbers cells, vertices, facets and edges of a process as its "points".
class Distributed_mesh {
public:
  struct Cell {
    PetscInt point;
    std::array<PetscInt, 4> vertices;
    std::array<PetscInt, 4> facets; // facet i is opposite to vertex i
    VMP::internal::Cell_gradients gradients;
  };

  // `mesh` is the whole one in the first process, and empty in the others.
  explicit Distributed_mesh(const Mesh& mesh) {
    const DM whole = create(mesh);
    label_bases(mesh, whole);
    distribute(whole);
    mark_ghosts();
    read_cells();
  }
  ~Distributed_mesh() {
    DMDestroy(&m_plex);
    PetscSFDestroy(&m_origin);
  }
  Distributed_mesh(const Distributed_mesh&) = delete;
  Distributed_mesh& operator=(const Distributed_mesh&) = delete;

  static int rank() {
    int result = 0;
    MPI_Comm_rank(PETSC_COMM_WORLD, &result);
    return result;
  }

  DM plex() const { return m_plex; }
  std::size_t number_of_points() const { return m_is_ghost.size(); }
  // The cells of this process and those behind its facets.
  const std::vector<Cell>& cells() const { return m_cells; }
  // Of the processes that know a point, one owns it: for the others it is a ghost.
  bool is_ghost(PetscInt point) const { return m_is_ghost[point]; }
  // FLOOR, CEILING, or INTERIOR for all else, of vertices and facets.
  int base(PetscInt point) const { return m_base[point]; }

  // returns the cells of `cells()` on both sides of a facet, by their places there; -1 for none.
  const std::array<int, 2>& cells_of_facet(PetscInt facet) const { return m_cells_of_facet[facet]; }

  // returns the points of this dimension, 0 for vertices to 3 for cells, as a half-open range.
  std::pair<PetscInt, PetscInt> stratum(PetscInt dimension) const {
    std::pair<PetscInt, PetscInt> range;
    petsc_call(DMPlexGetDepthStratum(m_plex, dimension, &range.first, &range.second));
    return range;
  }

  // returns, in the first process, the values of the points of the whole mesh: its cells first, then its vertices, both in
  // the order of the mesh that was given.
  std::vector<double> gather(const std::vector<double>& values) const {
    if (!m_origin) return values;
    PetscInt number_of_roots = 0;
    petsc_call(PetscSFGetGraph(m_origin, &number_of_roots, nullptr, nullptr, nullptr));
    std::vector<double> result(number_of_roots, 0);
    petsc_call(PetscSFReduceBegin(m_origin, MPIU_SCALAR, values.data(), result.data(), MPI_REPLACE));
    petsc_call(PetscSFReduceEnd(m_origin, MPIU_SCALAR, values.data(), result.data(), MPI_REPLACE));
    return result;
  }

  // returns which cell of the mesh that was given each cell of this process is.
  std::vector<PetscInt> original_cells() const {
    std::vector<PetscInt> result(m_cells.size());
    std::iota(result.begin(), result.end(), 0);
    if (m_origin)
      for_each_remote_cell(m_origin,
                           [&](PetscInt c, const PetscSFNode& original) { result[c] = original.index; });
    return result;
  }

  // returns the process that owns each cell of this process, and the number of the cell there.
  std::vector<PetscSFNode> owners_of_cells() const {
    std::vector<PetscSFNode> result;
    for (const Cell& cell : m_cells) result.push_back({rank(), cell.point});
    PetscSF owners = nullptr;
    petsc_call(DMGetPointSF(m_plex, &owners));
    for_each_remote_cell(owners, [&](PetscInt c, const PetscSFNode& owner) { result[c] = owner; });
    return result;
  }

private:
  using Vertices = std::vector<PetscInt>;
  using Point = VMP::internal::Cell_gradients::Point_3;

  static DM create(const Mesh& mesh) {
    std::vector<PetscInt> cells;
    std::vector<PetscReal> coordinates;
    for (VMP::Cell_index c : mesh.cells())
      for (VMP::Vertex_index v : mesh.cell(c)) cells.push_back(PetscInt(std::size_t(v)));
    for (VMP::Vertex_index v : mesh.vertices())
      for (int i = 0; i < 3; ++i) coordinates.push_back(mesh.point(v)[i]);
    DM result = nullptr;
    petsc_call(DMPlexCreateFromCellListPetsc(PETSC_COMM_WORLD, 3, PetscInt(mesh.number_of_cells()),
                                             PetscInt(mesh.number_of_vertices()), 4, PETSC_TRUE, cells.data(),
                                             3, coordinates.data(), &result));
    petsc_call(DMCreateLabel(result, "base"));
    // cells are neighbors if they share a facet
    petsc_call(DMSetBasicAdjacency(result, PETSC_TRUE, PETSC_FALSE));
    return result;
  }

  // Before the distribution: a vertex may be on the floor, and its process know no facet of the floor.
  static void label_bases(const Mesh& mesh, DM whole) {
    for (VMP::Facet_index f : mesh.boundary_facets()) {
      const int label = mesh.label(f);
      if (label != VMP::FLOOR && label != VMP::CEILING) continue;
      std::array<PetscInt, 3> vertices;
      for (int i = 0; i < 3; ++i)
        vertices[i] = PetscInt(mesh.number_of_cells() + std::size_t(mesh.vertices(f)[i]));
      for (PetscInt v : vertices) petsc_call(DMSetLabelValue(whole, "base", v, label));
      PetscInt number = 0;
      const PetscInt* facet = nullptr;
      petsc_call(DMPlexGetFullJoin(whole, 3, vertices.data(), &number, &facet));
      petsc_call(DMSetLabelValue(whole, "base", facet[0], label));
      petsc_call(DMPlexRestoreJoin(whole, 3, vertices.data(), &number, &facet));
    }
  }

  // With one process there is nothing to distribute, and PETSc returns nothing.
  void distribute(DM whole) {
    petsc_call(DMPlexDistribute(whole, 1, &m_origin, &m_plex));
    if (m_plex)
      petsc_call(DMDestroy(&whole));
    else
      m_plex = whole;
  }

  // Cells are the first points: their places in cells() are their numbers.
  template <typename Visit>
  void for_each_remote_cell(PetscSF connection, const Visit& visit) const {
    PetscInt number = 0;
    const PetscInt* points = nullptr;
    const PetscSFNode* remote = nullptr;
    petsc_call(PetscSFGetGraph(connection, nullptr, &number, &points, &remote));
    for (PetscInt k = 0; k < number; ++k) {
      const PetscInt point = points ? points[k] : k;
      if (point < PetscInt(m_cells.size())) visit(point, remote[k]);
    }
  }

  void mark_ghosts() {
    PetscInt end = 0;
    petsc_call(DMPlexGetChart(m_plex, nullptr, &end));
    m_is_ghost.assign(end, false);
    m_base.resize(end);
    PetscSF owners = nullptr;
    PetscInt number = 0;
    const PetscInt* points = nullptr;
    petsc_call(DMGetPointSF(m_plex, &owners));
    petsc_call(PetscSFGetGraph(owners, nullptr, &number, &points, nullptr));
    for (PetscInt k = 0; k < number; ++k) m_is_ghost[points ? points[k] : k] = true;
    for (PetscInt p = 0; p < end; ++p) {
      PetscInt label = 0;
      petsc_call(DMGetLabelValue(m_plex, "base", p, &label));
      m_base[p] = label == VMP::FLOOR || label == VMP::CEILING ? int(label) : int(VMP::INTERIOR);
    }
  }

  // The vertices among the points that a point consists of.
  Vertices vertices_of(PetscInt point) const {
    const auto [begin, end] = stratum(0);
    Vertices result;
    PetscInt number = 0;
    PetscInt* closure = nullptr; // pairs of a point and its orientation
    petsc_call(DMPlexGetTransitiveClosure(m_plex, point, PETSC_TRUE, &number, &closure));
    for (PetscInt k = 0; k < number; ++k)
      if (closure[2 * k] >= begin && closure[2 * k] < end) result.push_back(closure[2 * k]);
    petsc_call(DMPlexRestoreTransitiveClosure(m_plex, point, PETSC_TRUE, &number, &closure));
    return result;
  }

  void read_cells() {
    const auto [first_facet, last_facet] = stratum(2);
    std::vector<Vertices> vertices_of_facet(number_of_points());
    for (PetscInt f = first_facet; f < last_facet; ++f) vertices_of_facet[f] = vertices_of(f);
    m_cells_of_facet.assign(number_of_points(), {-1, -1});
    const std::vector<Point> points = read_points();
    const auto [first_cell, last_cell] = stratum(3);
    for (PetscInt c = first_cell; c < last_cell; ++c) add_cell(c, points, vertices_of_facet);
  }

  void add_cell(PetscInt point, const std::vector<Point>& points,
                const std::vector<Vertices>& vertices_of_facet) {
    const Vertices given = vertices_of(point);
    std::array<PetscInt, 4> v = {given[0], given[1], given[2], given[3]}, facets;
    if (CGAL::orientation(points[v[0]], points[v[1]], points[v[2]], points[v[3]]) == CGAL::NEGATIVE)
      std::swap(v[0], v[1]);
    const PetscInt* cone = nullptr;
    petsc_call(DMPlexGetCone(m_plex, point, &cone));
    for (int k = 0; k < 4; ++k) {
      const Vertices& w = vertices_of_facet[cone[k]];
      const auto is_opposite = [&](PetscInt u) { return std::find(w.begin(), w.end(), u) == w.end(); };
      facets[std::find_if(v.begin(), v.end(), is_opposite) - v.begin()] = cone[k];
      auto& sides = m_cells_of_facet[cone[k]];
      sides[sides[0] < 0 ? 0 : 1] = int(m_cells.size());
    }
    m_cells.push_back(
        {point, v, facets,
         VMP::internal::Cell_gradients({points[v[0]], points[v[1]], points[v[2]], points[v[3]]})});
  }

  // The coordinates of the vertices, by their numbers as points.
  std::vector<Point> read_points() const {
    std::vector<Point> result(number_of_points());
    Vec coordinates = nullptr;
    PetscSection section = nullptr;
    const PetscScalar* values = nullptr;
    petsc_call(DMGetCoordinatesLocal(m_plex, &coordinates));
    petsc_call(DMGetCoordinateSection(m_plex, &section));
    petsc_call(VecGetArrayRead(coordinates, &values));
    const auto [begin, end] = stratum(0);
    for (PetscInt v = begin; v < end; ++v) {
      PetscInt k = 0;
      petsc_call(PetscSectionGetOffset(section, v, &k));
      result[v] = Point(values[k], values[k + 1], values[k + 2]);
    }
    petsc_call(VecRestoreArrayRead(coordinates, &values));
    return result;
  }

  DM m_plex = nullptr;
  PetscSF m_origin = nullptr; // which point of the whole mesh a point is
  std::vector<char> m_is_ghost;
  std::vector<int> m_base;
  std::vector<Cell> m_cells;
  std::vector<std::array<int, 2>> m_cells_of_facet;
};

#endif // HANDLEBODY_MPI_DISTRIBUTED_MESH_H
