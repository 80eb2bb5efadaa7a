#include "Result_folder.h"
#include "Stage_clock.h"
#include "commands.h"
#include "load_input.h"
#include "report.h"
#include "result_files.h"

#include <CGAL/Volume_mesh_parameterization/Averaged_gradient_field_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/optimize_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>

#include <iomanip>
#include <iostream>

using VMP::Status;

namespace {

bool is_refusal(const Status& status) {
  switch (status.code()) {
  case VMP::ERROR_CANNOT_SPLIT:
  case VMP::ERROR_CANNOT_SOLVE:
  case VMP::ERROR_SWEEP_STOPPED:
  case VMP::ERROR_SWEEP_RULE:
  case VMP::ERROR_CURVE_LOST:
  case VMP::ERROR_FLOOR_MAP:
  case VMP::ERROR_MAP_NOT_BIJECTIVE:
  case VMP::ERROR_INVERTED_HEXAHEDRON:
  case VMP::ERROR_CANCELLED:
  case VMP::OK: return false;
  default: return true;
  }
}

// One run of `handlebody parameterize`, in the order of the report.
class Parameterization {
public:
  explicit Parameterization(const Parameterize_options& options)
      : m_options(options), m_folder(options.folder), m_clock(options.quiet) {}

  int run() {
    const Status writable = m_folder.create(m_options.input.file);
    if (!writable.ok()) return say(writable, INPUT_REFUSED);
    m_report["input"] = {{"file", m_options.input.file}};
    Input input;
    Status status = load_input(m_options.input, m_clock, input);
    if (status.ok()) status = map_solid(input);
    if (is_refusal(status)) return finish(status, INPUT_REFUSED);
    const Status written = write_what_holds();
    return written.ok() ? finish(status.ok() ? m_not_certified : status, exit_code(status)) : finish(written, INPUT_REFUSED);
  }

private:
  Status map_solid(const Input& input) {
    m_report["input"]["kind"] = input.is_surface ? "surface" : "tetrahedra";
    m_report["input"]["partition"] = input.has_labels ? "labels" : "auto";
    m_report["input"]["direction"] = {input.direction.x(), input.direction.y(), input.direction.z()};
    const auto type = m_options.field == Field::FLUX ? VMP::FLUX_CURVES : VMP::CERTIFIED_CURVES;
    const Status status =
        m_parameterizer.run(input.mesh, VMP::parameters::curve_type(type).visitor(Clock_visitor{&m_clock}));
    m_clock.finish();
    m_report["input"]["tetrahedra"] = input.mesh.number_of_cells();
    return status;
  }

  Status write_what_holds() {
    const Parameterizer& p = m_parameterizer;
    m_clock.start("check and write");
    report_mesh();
    Status status = VMP::IO::write_MEDIT(m_folder.file(Result_folder::object), p.mesh());
    if (status.ok() && p.product_structure()) status = m_folder.write_order(p.product_structure()->order());
    if (p.curve_field()) report_fields();
    if (status.ok() && !p.vertex_images().empty()) status = write_map();
    if (status.ok() && p.product_map() && m_options.number_of_hexahedra > 0) status = write_hexahedra();
    if (m_options.field == Field::PAPER && p.harmonic_function()) report_paper();
    m_clock.finish();
    return status;
  }

  void report_mesh() {
    const Parameterizer& p = m_parameterizer;
    const VMP::Preparation& splits = p.preparation();
    m_report["counts"] = {{"tetrahedra", p.mesh().number_of_cells()},
                          {"vertices", p.mesh().number_of_vertices()},
                          {"boundary_triangles", p.mesh().number_of_boundary_facets()},
                          {"genus", p.partition().genus},
                          {"split_boundary_edges", splits.boundary_edges},
                          {"split_interior_edges", splits.interior_edges},
                          {"split_facets", splits.facets},
                          {"sweep", report_sweep(p.sweep_report())}};
    m_report["partition"] = report_partition(p.partition());
    m_report["certificates"] = {{"handlebody", true},
                                {"longest_word", p.handlebody_certificate().longest_word()},
                                {"product", p.product_structure() != nullptr},
                                {"curves", p.product_map() != nullptr && m_options.field != Field::FLUX},
                                {"piecewise_linear", false}};
  }

  void report_fields() {
    const Parameterizer& p = m_parameterizer;
    m_report["residuals"] = {{"harmonic_function", p.harmonic_function()->residual()},
                             {"dual_potential", p.dual_potential()->residual()},
                             {"flux", p.flux_field()->residual()},
                             {"largest_divergence", p.flux_field()->largest_divergence()}};
    m_report["maximum_principle"] = report_maximum_principle(*p.harmonic_function());
    const Status status = VMP::find_critical_points(p.mesh(), p.harmonic_function()->values(), m_critical_vertices);
    m_report["critical_points"] = status.ok() ? report_critical_points(p.mesh(), m_critical_vertices) : report_status(status);
    m_angles = angles_to_gradient(p, [&](VMP::Cell_index c) { return p.curve_field()->vector(p.mesh(), c); });
    m_report["angles"] = report_angles(p, m_angles);
  }

  // The vertex map is handed out only if it is bijective.
  Status write_map() {
    const Parameterizer& p = m_parameterizer;
    const VMP::Map_report map = VMP::verify_map(p.mesh(), p.vertex_images());
    m_report["certificates"]["piecewise_linear"] = map.is_bijective();
    m_report["vertex_map"] = {{"flipped", map.flipped},
                              {"flat", map.flat},
                              {"off_axis_boundary_triangles", map.off_axis},
                              {"overlapping_boundary_triangles", map.overlaps},
                              {"status", report_status(map.status)}};
    m_report["domain"] = report_domain(p.floor_map()->domain());
    m_report["distortion"] = report_distortion(VMP::measure_distortion(p.mesh(), p.vertex_images()));
    Status status;
    if (map.is_bijective()) {
      Soup image = VMP::make_soup(p.mesh());
      image.points = p.vertex_images();
      status = VMP::IO::write_MEDIT(m_folder.file(Result_folder::parameter), image);
    } else if (m_options.field == Field::FLUX)
      m_not_certified = map.status;
    if (status.ok()) status = write_result(m_folder, p, m_angles, critical_vertices());
    if (status.ok()) status = write_curves(m_folder, p);
    return status;
  }

  std::vector<std::size_t> critical_vertices() const {
    std::vector<std::size_t> vertices;
    for (const VMP::Critical_vertex& c : m_critical_vertices) vertices.push_back(c.vertex);
    return vertices;
  }

  Status write_hexahedra() {
    VMP::Hexahedron_soup_3<Point_3> hexahedra;
    Status status = extract_hexahedra(hexahedra);
    if (status.ok()) {
      m_report["hexahedra_before_optimization"] = report_hexahedra(VMP::verify_hexahedra(hexahedra), hexahedra.hexahedra.size());
      status = VMP::optimize_hexahedra(m_parameterizer.mesh(), hexahedra);
    }
    if (!status.ok()) {
      m_not_certified = status;
      return {};
    }
    const VMP::Hexahedra_report report = VMP::verify_hexahedra(hexahedra);
    m_report["hexahedra"] = report_hexahedra(report, hexahedra.hexahedra.size());
    if (report.is_valid()) return VMP::IO::write_MEDIT(m_folder.file(Result_folder::hexahedra), hexahedra);
    m_not_certified = report.status;
    return {};
  }

  Status extract_hexahedra(VMP::Hexahedron_soup_3<Point_3>& hexahedra) const {
    const auto& map = *m_parameterizer.product_map();
    const auto& domain = map.floor_map().domain();
    return VMP::hexahedral_mesh(
        domain, VMP::prism_grid_of_size(domain, m_options.number_of_hexahedra),
        [&](const Kernel::Point_2& q, std::size_t layers, std::vector<Point_3>& points) {
          return map.column(q, layers, points);
        },
        hexahedra);
  }

  // Steps 3 to 5 of the paper on the same mesh: how many interior vertices arrive at each base.
  void report_paper() {
    const auto& mesh = m_parameterizer.mesh();
    const VMP::Averaged_gradient_field_3<Mesh> field(mesh, m_parameterizer.harmonic_function()->values());
    for (const auto& [name, base] : {std::pair<const char*, int>("floor", VMP::FLOOR), {"ceiling", VMP::CEILING}}) {
      const auto interior = field.arrivals(base), wall = field.arrivals_on_walls(base);
      m_report["paper"][name] = {{"share_of_interior_vertices", interior.share()},
                                 {"left_through_wall", interior.left_through_wall},
                                 {"stuck", interior.stuck},
                                 {"share_of_wall_vertices", wall.share()}};
    }
    m_not_certified = Status(VMP::ERROR_CURVE_LOST, "the paper's averaged gradient certifies nothing; see report.json");
  }

  int exit_code(const Status& status) const {
    return status.ok() && m_not_certified.ok() ? EVERYTHING_CERTIFIED : NOT_CERTIFIED;
  }

  int finish(const Status& status, int exit_code) {
    m_clock.finish();
    m_report["status"] = report_status(status);
    m_report["exit_code"] = exit_code;
    m_report["stages"] = report_stages(m_clock);
    m_report["versions"] = report_versions();
    const Status written = m_folder.write_text(Result_folder::report, m_report.dump(2) + "\n");
    return status.ok() && written.ok() ? exit_code : say(status.ok() ? written : status, exit_code);
  }

  int say(const Status& status, int exit_code) const {
    std::cerr << "handlebody: " << m_options.input.file << ": " << status.message() << std::endl;
    return exit_code;
  }

  const Parameterize_options& m_options;
  Result_folder m_folder;
  Stage_clock m_clock;
  Parameterizer m_parameterizer;
  Json m_report;
  std::vector<double> m_angles; // between curves and grad f, in degrees
  std::vector<VMP::Critical_vertex> m_critical_vertices;
  Status m_not_certified; // why something that was asked for does not hold
};

} // namespace

int parameterize(const Parameterize_options& options) {
  Chosen_solver_traits::choose(options.solver);
  return Parameterization(options).run();
}
