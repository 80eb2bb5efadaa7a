// Computes the three fields of a solid that is distributed over the processes of MPI, and traces curves through it.

#include "Distributed_curves.h"
#include "arrivals.h"
#include "certified_field.h"
#include "distributed_fields.h"

#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/Flux_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using Json = nlohmann::ordered_json;
using VMP::Status;

namespace {

constexpr int refused = 1, wrong_usage = 2, not_certified = 3; // as of handlebody
constexpr double largest_difference = 1e-10;

struct Options {
  std::string input, output, order, curves;
  std::size_t step = 1; // from seed to seed
  bool checks = false;
};

// The values of vertices or cells of the whole mesh, in its order.
struct Fields {
  std::vector<double> f, potential;
  std::array<std::vector<double>, 3> flux;
};

bool is_first() { return Distributed_mesh::rank() == 0; }

// The first process has the mesh, and tells the others whether it is good.
bool succeeds(const Status& status) {
  int is_ok = status.ok();
  MPI_Bcast(&is_ok, 1, MPI_INT, 0, PETSC_COMM_WORLD);
  if (!status.ok()) std::cerr << "error: " << status.message() << std::endl;
  return is_ok;
}

Status read(const std::string& file, Mesh& mesh) {
  Soup soup;
  VMP::Boundary_partition_3 partition;
  Status status = VMP::IO::read_MEDIT(file, soup);
  if (status.ok()) status = mesh.assign(soup);
  if (status.ok()) status = VMP::check_tetrahedral_mesh(mesh);
  if (status.ok()) status = VMP::validate_partition(mesh, partition);
  return status;
}

std::vector<double> part(const std::vector<double>& values, std::size_t begin, std::size_t size) {
  return {values.begin() + begin, values.begin() + begin + size};
}

// `mesh` is the whole one in the first process, and empty in the others, which get no fields.
Fields gather(const Distributed_mesh& distributed, const Mesh& mesh, const Fields& local) {
  const std::size_t cells = mesh.number_of_cells(), vertices = mesh.number_of_vertices();
  const auto f = distributed.gather(local.f), potential = distributed.gather(local.potential);
  std::array<std::vector<double>, 3> flux;
  for (int i = 0; i < 3; ++i) flux[i] = distributed.gather(local.flux[i]);
  if (!is_first()) return {};
  for (auto& coordinate : flux) coordinate = part(coordinate, 0, cells);
  return {part(f, cells, vertices), part(potential, 0, cells), flux};
}

Status write(const std::string& file, const Mesh& mesh, const Fields& fields) {
  VMP::IO::VTU_content content;
  content.with_facets = false;
  content.point_data = {{"f", fields.f}};
  content.cell_data = {{"potential", fields.potential},
                       {"flux_x", fields.flux[0]},
                       {"flux_y", fields.flux[1]},
                       {"flux_z", fields.flux[2]}};
  return VMP::IO::write_VTU(file, mesh, content);
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) result = std::max(result, std::abs(a[i] - b[i]));
  return result;
}

// The greatest differences from what the library computes alone, with its own solver; that of the flux relative to the
// greatest one.
Status compare(const Mesh& mesh, const Fields& fields, Json& differences) {
  VMP::Harmonic_function_3<Mesh> f(mesh);
  VMP::Dual_potential_3<Mesh> potential(mesh);
  VMP::Flux_field_3<Mesh> flux(mesh);
  Status status = f.solve();
  if (status.ok()) status = potential.solve();
  if (status.ok()) status = flux.solve();
  if (!status.ok()) return status;
  double greatest = 0, difference = 0;
  for (VMP::Cell_index c : mesh.cells())
    for (int i = 0; i < 3; ++i) {
      greatest = std::max(greatest, std::abs(flux.vector(c)[i]));
      difference = std::max(difference, std::abs(flux.vector(c)[i] - fields.flux[i][c]));
    }
  differences = {{"harmonic function", distance(f.values(), fields.f)},
                 {"dual potential", distance(potential.values(), fields.potential)},
                 {"flux", difference / greatest}};
  return status;
}

// Sums over all processes, of what PETSc has sent and of the cells that two of them know.
Json report_distribution(const Distributed_mesh& mesh) {
  int processes = 0;
  MPI_Comm_size(PETSC_COMM_WORLD, &processes);
  double local[] = {double(mesh.cells().size()), 0, petsc_isend_ct + petsc_send_ct,
                    petsc_isend_len + petsc_send_len, petsc_allreduce_ct};
  for (const auto& cell : mesh.cells()) local[1] += mesh.is_ghost(cell.point);
  double sum[5];
  MPI_Reduce(local, sum, 5, MPI_DOUBLE, MPI_SUM, 0, PETSC_COMM_WORLD);
  return {{"processes", processes}, {"cells", sum[0] - sum[1]}, {"ghost_cells", sum[1]},
          {"messages", sum[2]},     {"bytes_sent", sum[3]},     {"reductions", sum[4] / processes}};
}

Json report_solution(const Solution_report& report) {
  return {{"unknowns", report.unknowns},
          {"iterations", report.iterations},
          {"residual", report.residual},
          {"seconds", report.seconds}};
}

Status check_solutions(const std::vector<Solution_report>& reports) {
  for (const Solution_report& r : reports)
    if (!r.is_solved)
      return {VMP::ERROR_CANNOT_SOLVE, r.name + ": relative residual " + std::to_string(r.residual)};
  return {};
}

Status check_differences(const Json& differences) {
  for (const auto& [name, difference] : differences.items())
    if (!(difference <= largest_difference))
      return {VMP::ERROR_CANNOT_SOLVE, name + ": differs from that of one process by " + difference.dump()};
  return {};
}

// In the first process, which has all fields.
Status finish(const Options& options, const Mesh& mesh, const Fields& fields, Json& report) {
  Status status;
  if (!options.output.empty()) status = write(options.output, mesh, fields);
  if (!status.ok() || !options.checks) return status;
  Json& differences = report["differences"];
  status = compare(mesh, fields, differences);
  return status.ok() ? check_differences(differences) : status;
}

Json report_curves(const std::vector<Arrival>& arrivals, const Distributed_curves::Costs& costs) {
  std::size_t cells = 0;
  for (const Arrival& a : arrivals) cells += a.cells;
  return {{"curves", arrivals.size()},      {"cells", cells},          {"rounds", costs.rounds},
          {"crossings", costs.crossings},   {"moves", costs.moves},    {"messages", costs.messages},
          {"bytes_sent", costs.bytes_sent}, {"seconds", costs.seconds}};
}

// The first process has the field and the seeds, and gets the arrivals.
bool trace_curves(const Options& options, const Mesh& mesh, const Distributed_mesh& distributed,
                  Json& report) {
  Curve_field field;
  if (!succeeds(is_first() ? make_certified_field(mesh, options.order, field) : Status())) return false;
  Distributed_curves distributed_curves(distributed, field);
  const Integral_curves curves(mesh, field);
  const std::vector<Base_point> seeds = floor_centroids(mesh, options.step);
  const std::vector<Arrival> arrivals = trace_arrivals(curves, seeds, distributed_curves);
  report["curves"] = report_curves(arrivals, distributed_curves.costs());
  Status status;
  if (is_first()) status = write_arrivals(options.curves, seeds, arrivals);
  if (status.ok() && options.checks) status = compare_arrivals(curves, seeds, arrivals);
  return succeeds(status);
}

int run(const Options& options) {
  Mesh mesh;
  if (!succeeds(is_first() ? read(options.input, mesh) : Status())) return refused;
  const Distributed_mesh distributed(mesh);
  std::vector<Solution_report> reports;
  Fields local;
  local.f = harmonic_function(distributed, reports);
  local.potential = dual_potential(distributed, reports);
  local.flux = flux(distributed, reports);
  const Fields fields = gather(distributed, mesh, local);

  Json report = report_distribution(distributed);
  for (const Solution_report& r : reports) report[r.name] = report_solution(r);
  Status status = check_solutions(reports);
  if (is_first() && status.ok()) status = finish(options, mesh, fields, report);
  bool is_done = succeeds(status);
  if (is_done && !options.curves.empty()) is_done = trace_curves(options, mesh, distributed, report);
  if (is_first()) std::cout << report.dump(2) << std::endl;
  return is_done ? 0 : not_certified;
}

void add_curve_options(CLI::App& app, Options& options) {
  CLI::Option* curves =
      app.add_option("--curves", options.curves, "a text file to write: where certified curves arrive")
          ->type_name("FILE");
  app.add_option("--order", options.order,
                 "their certificate: order.txt of handlebody; without it, INPUT is swept as it is")
      ->needs(curves);
  app.add_option("--seeds", options.step, "trace a curve for every N-th triangle of the floor")
      ->type_name("N")
      ->check(CLI::Range(std::size_t(1), Mesh::most_cells).description("from 1"))
      ->capture_default_str()
      ->needs(curves);
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("computes the harmonic function, the dual potential and the flux of a solid, distributed over\n"
               "the processes of MPI, traces curves through it, and prints as JSON what that took");
  Options options;
  app.add_option("INPUT", options.input,
                 "tetrahedra in MEDIT format with a labelled boundary: object.mesh of handlebody")
      ->required();
  app.add_option("-o", options.output, "a VTU file to write: the solid with the fields");
  add_curve_options(app, options);
  app.add_flag("--check", options.checks, "compare with what the library computes alone, curves to the bit");
  app.footer("Curves start at the centroid of a triangle of the floor. For each, FILE has a line\n"
             "    seed facet b0 b1 b2 level cells\n"
             "with this triangle and that of the ceiling where it arrives, by their places in object.mesh, from 0;\n"
             "the barycentric coordinates there; the gain of the level function; the number of cells passed.\n"
             "PETSc takes its own options from the environment variable PETSC_OPTIONS.\n"
             "Exit: 0 the fields are computed, 1 INPUT is refused, 2 wrong usage, 3 a system was not solved,\n"
             "the order is not certified, an output not written, or the check failed.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const bool is_help = app.exit(error, out, err) == 0;
    if (is_first()) std::cout << out.str(), std::cerr << err.str();
    return is_help ? 0 : wrong_usage;
  }
  return run(options);
}

} // namespace

int main(int argc, char** argv) {
  PetscOptionsSetValue(nullptr, "-no_signal_handler", "true"); // signals belong to the program
  if (PetscInitializeNoArguments() != 0) return not_certified;
  int result = not_certified;
  try {
    result = parse_and_run(argc, argv);
  } catch (const std::exception& error) { // the other processes may wait for this one
    std::cerr << "error: " << error.what() << std::endl;
    MPI_Abort(PETSC_COMM_WORLD, result);
  }
  PetscFinalize();
  return result;
}
