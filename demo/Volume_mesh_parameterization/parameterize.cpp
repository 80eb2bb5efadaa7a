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
#include <CGAL/Volume_mesh_parameterization/pillow_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>

#include <iostream>
#include <optional>

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

// A failure that names the file, unless it does already.
Status about(const std::string& file, const Status& status) {
  const bool names_it = status.ok() || status.detail().compare(0, file.size(), file) == 0;
  return names_it ? status : Status(status.code(), file + ": " + status.detail());
}

// The polycube and the images of the boundary of the solid that the user gives.
Status load_domain(const Parameterize_options& options, Stage_clock& clock, Polycube& polycube, std::vector<Point_3>& images) {
  Input_options domain_options;
  domain_options.file = options.domain;
  domain_options.direction = options.input.direction;
  domain_options.number_of_tetrahedra = options.input.number_of_tetrahedra;
  Input domain;
  Status status = load_input(domain_options, clock, domain);
  if (status.ok()) status = polycube.build(domain.mesh, CGAL::parameters::visitor(Clock_visitor(clock, "domain: ")));
  return status.ok() ? about(options.boundary_map, read_points(options.boundary_map, images)) : about(options.domain, status);
}

// One run of `handlebody parameterize`, in the order of the report: over a prism that is found, or over a polycube that
// is given with a boundary map.
template <typename FloorMap>
class Parameterization {
  using Parameterizer = VMP::Direct_product_parameterizer_3<Kernel, Chosen_solver_traits, FloorMap>;

public:
  explicit Parameterization(const Parameterize_options& options)
      : m_options(options), m_folder(options.folder), m_clock(options.quiet) {}

  int run() {
    const Status writable = m_folder.create(m_options.input.file);
    if (!writable.ok()) return say(writable, INPUT_REFUSED);
    m_report["input"] = {{"file", m_options.input.file}};
    m_report["threads"] = m_options.threads;
    Input input;
    std::optional<FloorMap> floor_map;
    Status status = load(input, floor_map);
    if (status.ok()) status = map_solid(input, *floor_map);
    if (is_refusal(status)) return finish(status, INPUT_REFUSED);
    const Status written = m_parameterizer ? write_what_holds() : Status();
    return written.ok() ? finish(status.ok() ? m_not_certified : status, exit_code(status)) : finish(written, INPUT_REFUSED);
  }

private:
  Status load(Input& input, std::optional<Prism_floor_map>& floor_map) {
    floor_map.emplace();
    const Status status = load_input(m_options.input, m_clock, input);
    if (!status.ok()) return status;
    m_report["input"]["partition"] = input.has_labels ? "labels" : "auto";
    if (input.chosen) m_report["input"]["chosen_partition"] = report_candidate(*input.chosen);
    return status;
  }

  Status load(Input& input, std::optional<Given_boundary_map>& floor_map) {
    m_report["input"]["domain"] = m_options.domain;
    m_report["input"]["boundary_map"] = m_options.boundary_map;
    std::vector<Point_3> images;
    Status status = load_domain(m_options, m_clock, m_polycube, images);
    if (status.ok()) status = load_unlabelled(m_options.input, m_clock, input);
    if (!status.ok()) return status;
    if (images.size() != input.number_of_points)
      return {VMP::ERROR_BOUNDARY_MAP, m_options.boundary_map + ": " + std::to_string(images.size()) +
                                           " points for the " + std::to_string(input.number_of_points) + " of the input"};
    floor_map.emplace(m_polycube, std::move(images));
    return floor_map->label_boundary(input.mesh);
  }

  Status map_solid(const Input& input, const FloorMap& floor_map) {
    m_report["input"]["kind"] = input.is_surface ? "surface" : "tetrahedra";
    const auto type = m_options.field == Field::FLUX ? VMP::FLUX_CURVES : VMP::CERTIFIED_CURVES;
    m_parameterizer.emplace(floor_map);
    const Status status =
        m_parameterizer->template run<CGAL::Parallel_if_available_tag>(input.mesh, VMP::parameters::curve_type(type).visitor(Clock_visitor(m_clock)));
    m_clock.finish();
    m_report["input"]["tetrahedra"] = input.mesh.number_of_cells();
    return status;
  }

  Status write_what_holds() {
    const Parameterizer& p = *m_parameterizer;
    m_clock.start("check and write");
    report_mesh();
    Status status = VMP::IO::write_MEDIT(m_folder.file(Result_folder::object), p.mesh());
    if (status.ok() && p.product_structure()) status = m_folder.write_order(Result_folder::order, p.product_structure()->order());
    if (status.ok() && m_polycube.is_valid()) status = write_polycube();
    if (p.curve_field()) report_fields();
    if (status.ok() && !p.vertex_images().empty()) status = write_map();
    if (status.ok() && p.product_map() && m_options.number_of_hexahedra > 0) status = write_hexahedra(p.floor_map()->domain());
    if (m_options.field == Field::PAPER && p.harmonic_function()) report_paper();
    m_clock.finish();
    return status;
  }

  Status write_polycube() {
    const Status status = VMP::IO::write_MEDIT(m_folder.file(Result_folder::domain), m_polycube.mesh());
    return status.ok()
               ? m_folder.write_order(Result_folder::domain_order, m_polycube.product().product_structure()->order())
               : status;
  }

  void report_mesh() {
    const Parameterizer& p = *m_parameterizer;
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
    const Parameterizer& p = *m_parameterizer;
    m_report["residuals"] = {{"harmonic_function", p.harmonic_function()->residual()},
                             {"dual_potential", p.dual_potential()->residual()},
                             {"flux", p.flux_field()->residual()},
                             {"largest_divergence", p.flux_field()->largest_divergence()}};
    m_report["maximum_principle"] = report_maximum_principle(*p.harmonic_function());
    auto& critical = m_singularities.critical_vertices;
    const Status status = VMP::find_critical_points(p.mesh(), p.harmonic_function()->values(), critical);
    m_report["critical_points"] = status.ok() ? report_critical_points(p.mesh(), critical) : report_status(status);
    m_singularities.irregular_edges = VMP::irregular_edges(p.mesh(), *p.flux_field());
    m_report["irregular_edges_of_flux"] = report_irregular_edges(p.mesh(), m_singularities.irregular_edges);
    m_angles = angles_to_gradient(p, [&](VMP::Cell_index c) { return p.curve_field()->vector(p.mesh(), c); });
    m_report["angles"] = report_angles(p, m_angles);
  }

  // The vertex map is handed out only if it is bijective.
  Status write_map() {
    const Parameterizer& p = *m_parameterizer;
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
    if (status.ok())
      status = write_result(m_folder, p, p.vertex_images(), height_of(p.floor_map()->domain()), m_angles, m_singularities);
    if (status.ok()) status = write_curves(m_folder, *p.product_map());
    return status;
  }

  // What w is a share of.
  static double height_of(const VMP::Prism_3<Kernel>& domain) { return domain.height(); }
  static double height_of(const Polycube&) { return 1; }

  // The program does not accept --hexes with --domain.
  Status write_hexahedra(const Polycube&) { return {}; }

  Status write_hexahedra(const VMP::Prism_3<Kernel>& domain) {
    VMP::Hexahedron_soup_3<Point_3> hexahedra;
    Status status = extract_hexahedra(domain, hexahedra);
    if (status.ok()) {
      m_report["hexahedra_before_optimization"] = report_hexahedra(VMP::verify_hexahedra(hexahedra), hexahedra.hexahedra.size(), m_options.has_pillow);
      status = VMP::optimize_hexahedra(m_parameterizer->mesh(), hexahedra, optimization());
    }
    if (!status.ok()) {
      m_not_certified = status;
      return {};
    }
    const VMP::Hexahedra_report report = VMP::verify_hexahedra(hexahedra);
    m_report["hexahedra"] = report_hexahedra(report, hexahedra.hexahedra.size(), m_options.has_pillow);
    if (report.is_valid()) return VMP::IO::write_MEDIT(m_folder.file(Result_folder::hexahedra), hexahedra);
    m_not_certified = report.status;
    return {};
  }

  Status extract_hexahedra(const VMP::Prism_3<Kernel>& domain, VMP::Hexahedron_soup_3<Point_3>& hexahedra) const {
    const auto& map = *m_parameterizer->product_map();
    const Status status = VMP::hexahedral_mesh<CGAL::Parallel_if_available_tag>(
        domain, VMP::prism_grid_of_size(domain, m_options.number_of_hexahedra, m_options.has_pillow),
        [&](const Kernel::Point_2& q, std::size_t layers, std::vector<Point_3>& points) {
          return map.column(q, layers, points);
        },
        hexahedra);
    return status.ok() && m_options.has_pillow ? VMP::pillow_hexahedra(hexahedra) : status;
  }

  // A pillow makes good corners possible along smooth rims, where these need not be kept.
  VMP::Hexahedra_optimization optimization() const {
    constexpr double target_with_pillow = 0.5;
    VMP::Hexahedra_optimization optimization;
    if (m_options.has_pillow) optimization.target = target_with_pillow;
    optimization.slides_over_smooth_rims = m_options.has_pillow;
    return optimization;
  }

  // Steps 3 to 5 of the paper on the same mesh: how many interior vertices arrive at each base.
  void report_paper() {
    const auto& mesh = m_parameterizer->mesh();
    const VMP::Averaged_gradient_field_3<Mesh> field(mesh, m_parameterizer->harmonic_function()->values());
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
  Polycube m_polycube; // if one is given
  std::optional<Parameterizer> m_parameterizer;
  Json m_report;
  std::vector<double> m_angles; // between curves and grad f, in degrees
  Singularities m_singularities;
  Status m_not_certified; // why something that was asked for does not hold
};

} // namespace

int parameterize(const Parameterize_options& options) {
  const Thread_limit limit(options.threads);
  Chosen_solver_traits::choose(options.solver);
  return options.domain.empty() ? Parameterization<Prism_floor_map>(options).run()
                                : Parameterization<Given_boundary_map>(options).run();
}
