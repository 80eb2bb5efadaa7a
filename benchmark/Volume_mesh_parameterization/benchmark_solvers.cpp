// Computes one field of a solid with one solver, and prints as JSON what assembly and solution cost.
// benchmark.py runs it and makes tables.
// usage: benchmark_solvers FILE FIELD SOLVER
//   FILE    tetrahedra in MEDIT format with a labelled boundary
//   FIELD   harmonic, dual or flux
//   SOLVER  default, the library's, or the name of another one that handlebody takes

#include "benchmark_util.h"

#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/Flux_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>

#include "Chosen_solver_traits.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

using VMP::Status;

// A solver that adds up the CPU seconds it takes: what else a field takes is its assembly.
template <typename Solver>
class Timed_solver_traits : public Solver {
public:
  using NT = typename Solver::NT;
  using Matrix = typename Solver::Matrix;
  using Vector = typename Solver::Vector;

  static CGAL::Timer& timer() {
    static CGAL::Timer the_timer;
    return the_timer;
  }

  bool factor(const Matrix& matrix, NT& denominator) {
    return timed([&] { return Solver::factor(matrix, denominator); });
  }
  bool linear_solver(const Vector& right, Vector& solution) {
    return timed([&] { return Solver::linear_solver(right, solution); });
  }

private:
  template <typename Function>
  static bool timed(const Function& function) {
    timer().start();
    const bool result = function();
    timer().stop();
    return result;
  }
};

template <typename Solver, template <typename, typename> class Field>
Status solve(const Mesh& mesh, Json& result) {
  using Timed = Timed_solver_traits<Solver>;
  Field<Mesh, Timed> field(mesh);
  Status status;
  result = measure([&] { status = field.solve(); });
  result["solver_cpu_seconds"] = Timed::timer().time();
  result["residual"] = field.residual();
  return status;
}

// What the flux costs beyond the harmonic function, which it is made from.
template <typename Solver>
Status equilibrate(const Mesh& mesh, Json& result) {
  VMP::Harmonic_function_3<Mesh, Solver> harmonic(mesh);
  VMP::Flux_field_3<Mesh, Solver> flux(mesh);
  const Status status = harmonic.solve();
  if (!status.ok()) return status;
  result = measure([&] { flux.equilibrate(harmonic); });
  result["solver_cpu_seconds"] = 0.;
  result["residual"] = flux.residual();
  return status;
}

template <typename Solver>
Status solve(const std::string& field, const Mesh& mesh, Json& result) {
  if (field == "harmonic") return solve<Solver, VMP::Harmonic_function_3>(mesh, result);
  if (field == "dual") return solve<Solver, VMP::Dual_potential_3>(mesh, result);
  if (field == "flux") return solve<Solver, VMP::Flux_field_3>(mesh, result);
  if (field == "equilibrated flux") return equilibrate<Solver>(mesh, result);
  return {VMP::ERROR_WRONG_PARAMETER, "there is no field " + field};
}

Status solve(const std::string& field, const std::string& solver, const Mesh& mesh, Json& result) {
  if (solver == "default") return solve<VMP::Default_solver_traits_3>(field, mesh, result);
  const auto names = Chosen_solver_traits::names();
  if (std::find(names.begin(), names.end(), solver) == names.end())
    return {VMP::ERROR_WRONG_PARAMETER, "this program was built without the solver " + solver};
  Chosen_solver_traits::choose(solver);
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_PETSC
  if (solver == "petsc")
    VMP::internal::Petsc_session::is_running(); // the start of MPI is no part of a solution
#endif
  return solve<Chosen_solver_traits>(field, mesh, result);
}

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: benchmark_solvers FILE FIELD SOLVER\n";
    return 2;
  }
  Mesh mesh;
  Json result;
  Soup soup;
  Status status = read_solid(argv[1], soup);
  if (status.ok()) status = mesh.assign(soup);
  const std::size_t base = CGAL::Memory_sizer().resident_size();
  if (status.ok()) status = solve(argv[2], argv[3], mesh, result);
  if (!status.ok()) {
    std::cerr << status.message() << std::endl;
    return EXIT_FAILURE;
  }
  result["cells"] = mesh.number_of_cells();
  result["base_bytes"] = base;
  std::cout << result.dump(2) << std::endl;
  return EXIT_SUCCESS;
}
