#ifndef HANDLEBODY_MPI_DISTRIBUTED_FIELDS_H
#define HANDLEBODY_MPI_DISTRIBUTED_FIELDS_H

#include "Distributed_dirichlet_problem.h"

#include <array>
#include <string>
#include <vector>

// What the solution of one field took.
struct Solution_report {
  std::string name;
  PetscInt unknowns, iterations;
  double residual, seconds;
  bool is_solved;
};

inline Solution_report report_of(const char* name, const Distributed_dirichlet_problem& problem) {
  return {name,
          problem.number_of_unknowns(),
          problem.number_of_iterations(),
          problem.residual(),
          problem.seconds(),
          problem.is_solved()};
}

// k_ij = - factor V grad lambda_i . grad lambda_j, as in the library's fields: factor 1 for vertices, 9 for facets.
inline std::array<std::array<double, 4>, 4> gradient_conductances(const Distributed_mesh::Cell& cell,
                                                                  double factor) {
  std::array<std::array<double, 4>, 4> k{};
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j)
      k[i][j] = -factor * cell.gradients.volume * (cell.gradients.gradients[i] * cell.gradients.gradients[j]);
  return k;
}

// The harmonic function: a value for each vertex.
inline std::vector<double> harmonic_function(const Distributed_mesh& mesh,
                                             std::vector<Solution_report>& reports) {
  Distributed_dirichlet_problem problem(mesh, 0);
  for (const auto& cell : mesh.cells())
    if (!mesh.is_ghost(cell.point)) problem.add_conductances(cell.vertices, gradient_conductances(cell, 1));
  std::vector<double> values = problem.solve();
  reports.push_back(report_of("harmonic function", problem));
  return values;
}

// Adds the edge of the dual graph through facet i of a cell, with the weight area / (sum of the distances of the two
// centroids to the facet). The area is 3 V |grad lambda_i|.
inline void add_dual_edge(const Distributed_mesh& mesh, const Distributed_mesh::Cell& cell, int i,
                          Distributed_dirichlet_problem& problem) {
  const PetscInt facet = cell.facets[i];
  const int other = mesh.cells_of_facet(facet)[1];
  const double volume = cell.gradients.volume,
               squared_area = 9 * volume * volume * cell.gradients.gradients[i].squared_length();
  if (other >= 0) {
    const Distributed_mesh::Cell& neighbor = mesh.cells()[other];
    const double k = squared_area / (0.75 * (volume + neighbor.gradients.volume));
    problem.add_conductances<2>({cell.point, neighbor.point}, {{{0, k}, {k, 0}}});
  } else if (mesh.base(facet) != VMP::INTERIOR)
    problem.add_conductance_to(mesh.base(facet) == VMP::CEILING, cell.point, squared_area / (0.75 * volume));
}

// The potential on the dual graph: a value for each cell. A facet is added by the process that owns it, which knows the
// cells on both sides.
inline std::vector<double> dual_potential(const Distributed_mesh& mesh,
                                          std::vector<Solution_report>& reports) {
  Distributed_dirichlet_problem problem(mesh, 3);
  for (const auto& cell : mesh.cells())
    for (int i = 0; i < 4; ++i) {
      const PetscInt facet = cell.facets[i];
      const bool is_first = &mesh.cells()[mesh.cells_of_facet(facet)[0]] == &cell;
      if (is_first && !mesh.is_ghost(facet)) add_dual_edge(mesh, cell, i, problem);
    }
  std::vector<double> values = problem.solve();
  reports.push_back(report_of("dual potential", problem));
  return values;
}

// The flux: the gradient of the solution of Crouzeix and Raviart, a vector for each cell, by its three coordinates. The
// function with value u_i on facet i is the sum of u_i (1 - 3 lambda_i).
inline std::array<std::vector<double>, 3> flux(const Distributed_mesh& mesh,
                                               std::vector<Solution_report>& reports) {
  Distributed_dirichlet_problem problem(mesh, 2);
  for (const auto& cell : mesh.cells())
    if (!mesh.is_ghost(cell.point)) problem.add_conductances(cell.facets, gradient_conductances(cell, 9));
  const std::vector<double> u = problem.solve();
  reports.push_back(report_of("flux", problem));
  std::array<std::vector<double>, 3> result;
  result.fill(std::vector<double>(mesh.number_of_points(), 0));
  for (const auto& cell : mesh.cells()) {
    const auto& f = cell.facets;
    const auto gradient = -3 * cell.gradients.interpolate({u[f[0]], u[f[1]], u[f[2]], u[f[3]]});
    for (int i = 0; i < 3; ++i) result[i][cell.point] = gradient[i];
  }
  return result;
}

#endif // HANDLEBODY_MPI_DISTRIBUTED_FIELDS_H
