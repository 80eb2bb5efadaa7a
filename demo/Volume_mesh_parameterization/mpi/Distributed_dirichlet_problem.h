#ifndef HANDLEBODY_MPI_DISTRIBUTED_DIRICHLET_PROBLEM_H
#define HANDLEBODY_MPI_DISTRIBUTED_DIRICHLET_PROBLEM_H

#include "Distributed_mesh.h"

#include <petscksp.h>

#include <array>
#include <cstddef>
#include <vector>

// Laplace's equation on a weighted graph whose nodes are all vertices, all facets or all cells of a distributed mesh: those
// on the floor are held at 0, those on the ceiling at 1, and at every other node the sum over its edges of
// k_ij (x_i - x_j) vanishes. What the processes contribute is added up.
class Distributed_dirichlet_problem {
public:
  // A larger relative residual means that the solver failed: half of the digits of a double.
  static constexpr double largest_residual = 1e-8;

  // `dimension` is that of the nodes: 0, 2 or 3.
  Distributed_dirichlet_problem(const Distributed_mesh& mesh, PetscInt dimension)
      : m_mesh(&mesh), m_start(MPI_Wtime()) {
    petsc_call(DMClone(mesh.plex(), &m_plex));
    create_section(dimension);
    petsc_call(DMSetLocalSection(m_plex, m_section));
    petsc_call(DMGetGlobalSection(m_plex, &m_numbering));
    petsc_call(DMCreateGlobalVector(m_plex, &m_right));
  }
  ~Distributed_dirichlet_problem() {
    KSPDestroy(&m_solver);
    VecDestroy(&m_right);
    MatDestroy(&m_matrix);
    PetscSectionDestroy(&m_section);
    DMDestroy(&m_plex);
  }
  Distributed_dirichlet_problem(const Distributed_dirichlet_problem&) = delete;
  Distributed_dirichlet_problem& operator=(const Distributed_dirichlet_problem&) = delete;

  // adds an edge between each two of these nodes; of `conductances` the part above the diagonal is read.
  template <std::size_t n>
  void add_conductances(const std::array<PetscInt, n>& nodes,
                        const std::array<std::array<double, n>, n>& conductances) {
    std::array<PetscInt, n> rows;
    std::array<double, n> diagonal{};
    for (std::size_t i = 0; i < n; ++i) rows[i] = unknown(nodes[i]);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        const double k = conductances[i][j];
        diagonal[i] += k;
        diagonal[j] += k;
        add_entry(rows[i], rows[j], -k);
        add_entry(rows[j], rows[i], -k);
        add_to_right(rows[i], k * held_value(nodes[j]));
        add_to_right(rows[j], k * held_value(nodes[i]));
      }
    for (std::size_t i = 0; i < n; ++i) add_entry(rows[i], rows[i], diagonal[i]);
  }

  // adds an edge to a node outside of the mesh, held at `value`.
  void add_conductance_to(double value, PetscInt node, double k) {
    add_entry(unknown(node), unknown(node), k);
    add_to_right(unknown(node), k * value);
  }

  // returns the values of all points of this process, 0 for those that are no nodes.
  std::vector<double> solve() {
    assemble_matrix();
    petsc_call(VecAssemblyBegin(m_right));
    petsc_call(VecAssemblyEnd(m_right));
    Vec solution = nullptr;
    petsc_call(VecDuplicate(m_right, &solution));
    run_solver(solution);
    std::vector<double> result = values_of(solution);
    petsc_call(VecDestroy(&solution));
    return result;
  }

  PetscInt number_of_unknowns() const {
    PetscInt n = 0;
    petsc_call(VecGetSize(m_right, &n));
    return n;
  }
  PetscInt number_of_iterations() const {
    PetscInt n = 0;
    petsc_call(KSPGetIterationNumber(m_solver, &n));
    return n;
  }
  // returns how much time has passed since the constructor.
  double seconds() const { return MPI_Wtime() - m_start; }
  // returns the norm of the residual divided by the norm of the right-hand side.
  double residual() const { return m_residual; }
  bool is_solved() const { return m_residual <= largest_residual; }

private:
  bool is_held(PetscInt node) const { return m_mesh->base(node) != VMP::INTERIOR; }
  double held_value(PetscInt node) const { return m_mesh->base(node) == VMP::CEILING; }

  // One value for each node; those of held nodes are no unknowns.
  void create_section(PetscInt dimension) {
    const auto [begin, end] = m_mesh->stratum(dimension);
    petsc_call(PetscSectionCreate(PETSC_COMM_WORLD, &m_section));
    petsc_call(PetscSectionSetChart(m_section, 0, PetscInt(m_mesh->number_of_points())));
    for (PetscInt p = begin; p < end; ++p) {
      petsc_call(PetscSectionSetDof(m_section, p, 1));
      if (is_held(p)) petsc_call(PetscSectionSetConstraintDof(m_section, p, 1));
    }
    petsc_call(PetscSectionSetUp(m_section));
    const PetscInt first = 0;
    for (PetscInt p = begin; p < end; ++p)
      if (is_held(p)) petsc_call(PetscSectionSetConstraintIndices(m_section, p, &first));
  }

  // The number of the unknown of a node among those of all processes; -1 if its value is held.
  PetscInt unknown(PetscInt node) const {
    if (is_held(node)) return -1;
    PetscInt number = 0; // of a ghost, PETSc stores -1 - number
    petsc_call(PetscSectionGetOffset(m_numbering, node, &number));
    return number < 0 ? -1 - number : number;
  }

  void add_entry(PetscInt row, PetscInt column, double value) {
    if (row < 0 || column < 0) return;
    m_rows.push_back(row);
    m_columns.push_back(column);
    m_entries.push_back(value);
  }

  void add_to_right(PetscInt row, double value) {
    if (row >= 0 && value != 0) petsc_call(VecSetValue(m_right, row, value, ADD_VALUES));
  }

  // Entries with the same place add up, and those of another process's rows are sent there.
  void assemble_matrix() {
    PetscInt own_rows = 0;
    petsc_call(VecGetLocalSize(m_right, &own_rows));
    petsc_call(MatCreate(PETSC_COMM_WORLD, &m_matrix));
    petsc_call(MatSetSizes(m_matrix, own_rows, own_rows, PETSC_DETERMINE, PETSC_DETERMINE));
    petsc_call(MatSetType(m_matrix, MATAIJ));
    petsc_call(MatSetPreallocationCOO(m_matrix, PetscCount(m_rows.size()), m_rows.data(), m_columns.data()));
    petsc_call(MatSetValuesCOO(m_matrix, m_entries.data(), ADD_VALUES));
    petsc_call(MatSetOption(m_matrix, MAT_SPD, PETSC_TRUE));
    m_rows = m_columns = {};
    m_entries.clear();
    m_entries.shrink_to_fit();
  }

  void run_solver(Vec solution) {
    petsc_call(KSPCreate(PETSC_COMM_WORLD, &m_solver));
    petsc_call(KSPSetOperators(m_solver, m_matrix, m_matrix));
    petsc_call(KSPSetType(m_solver, KSPCG));
    petsc_call(KSPSetNormType(m_solver, KSP_NORM_UNPRECONDITIONED));
    PC preconditioner = nullptr;
    petsc_call(KSPGetPC(m_solver, &preconditioner));
    petsc_call(PCSetType(preconditioner, PCGAMG));
    petsc_call(
        KSPSetTolerances(m_solver, 1e-15, PETSC_DEFAULT, PETSC_DEFAULT, 1000)); // all digits that there are
    petsc_call(KSPSetFromOptions(m_solver));
    petsc_call(KSPSolve(m_solver, m_right, solution));
    compute_residual(solution);
  }

  void compute_residual(Vec solution) {
    Vec difference = nullptr;
    PetscReal right = 0;
    petsc_call(VecDuplicate(m_right, &difference));
    petsc_call(MatMult(m_matrix, solution, difference));
    petsc_call(VecAXPY(difference, -1, m_right));
    petsc_call(VecNorm(difference, NORM_2, &m_residual));
    petsc_call(VecNorm(m_right, NORM_2, &right));
    petsc_call(VecDestroy(&difference));
    if (m_residual != 0) m_residual /= right;
  }

  std::vector<double> values_of(Vec solution) const {
    Vec local = nullptr;
    const PetscScalar* entries = nullptr;
    petsc_call(DMGetLocalVector(m_plex, &local));
    petsc_call(DMGlobalToLocalBegin(m_plex, solution, INSERT_VALUES, local));
    petsc_call(DMGlobalToLocalEnd(m_plex, solution, INSERT_VALUES, local));
    petsc_call(VecGetArrayRead(local, &entries));
    std::vector<double> result(m_mesh->number_of_points(), 0);
    for (PetscInt p = 0; p < PetscInt(result.size()); ++p) {
      PetscInt number_of_values = 0, k = 0;
      petsc_call(PetscSectionGetDof(m_section, p, &number_of_values));
      petsc_call(PetscSectionGetOffset(m_section, p, &k));
      if (number_of_values == 1) result[p] = is_held(p) ? held_value(p) : entries[k];
    }
    petsc_call(VecRestoreArrayRead(local, &entries));
    petsc_call(DMRestoreLocalVector(m_plex, &local));
    return result;
  }

  const Distributed_mesh* m_mesh;
  double m_start;
  DM m_plex = nullptr;
  PetscSection m_section = nullptr;
  PetscSection m_numbering = nullptr;      // of the unknowns of all processes; belongs to m_plex
  std::vector<PetscInt> m_rows, m_columns; // of the entries of the matrix
  std::vector<double> m_entries;
  Mat m_matrix = nullptr;
  Vec m_right = nullptr;
  KSP m_solver = nullptr;
  double m_residual = 0;
};

#endif // HANDLEBODY_MPI_DISTRIBUTED_DIRICHLET_PROBLEM_H
