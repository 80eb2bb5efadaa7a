#include "Result_folder.h"
#include "Stage_clock.h"
#include "commands.h"
#include "hexahedra.h"
#include "load_domain.h"
#include "load_input.h"
#include "report.h"
#include "result_files.h"

#include <CGAL/Volume_mesh_parameterization/Averaged_gradient_field_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_search_3.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>

#include <cmath>
#include <optional>
#include <string>

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
  case VMP::OK:
    return false;
  default:
    return true;
  }
}

// A failure that names the file, unless it does already.
Status about(const std::string& file, const Status& status) {
  const bool names_it = status.ok() || status.detail().compare(0, file.size(), file) == 0;
  return names_it ? status : Status(status.code(), file + ": " + status.detail());
}

// One run of `handlebody parameterize`, in the order of the report: over a prism that is found, or over a polycube that
// is given with a boundary map.
template <typename FloorMap>
class Parameterization {
  using Search = VMP::Parameterization_search_3<Kernel, Chosen_solver_traits, FloorMap>;
  using Parameterizer = typename Search::Parameterizer;

public:
  explicit Parameterization(const Parameterize_options& options)
      : m_options(options),
        m_folder(options.folder),
        m_clock(options.quiet) {}

  int run() {
    const Status writable = m_folder.create(m_options.input.file);
    if (!writable.ok()) return say(m_options.input.file, writable, INPUT_REFUSED);
    m_report["input"] = {{"file", m_options.input.file}};
    m_report["threads"] = m_options.threads;
    const Status status = map_solid();
    if (is_refusal(status)) return finish(status, INPUT_REFUSED);
    const Status written = is_worth_writing(status) ? write_what_holds() : Status();
    return written.ok() ? finish(status.ok() ? m_not_certified : status, exit_code(status))
                        : finish(written, INPUT_REFUSED);
  }

private:
  Status load(std::optional<Partitions>& partitions, std::optional<Prism_floor_map>& floor_map) {
    floor_map.emplace(m_options.prism);
    return load_input(m_options.input, m_clock, m_input, partitions);
  }

  Status load(std::optional<Partitions>& partitions, std::optional<Given_boundary_map>& floor_map) {
    if (!m_options.domain.empty()) m_report["input"]["domain"] = m_options.domain;
    m_report["input"]["boundary_map"] = m_options.boundary_map;
    Mesh solid;
    std::size_t number_of_points = 0;
    std::vector<Point_3> images;
    m_input.is_surface = is_surface_file(m_options.input.file);
    Status status = load_unlabelled(m_options.input, m_clock, solid, number_of_points);
    if (status.ok()) status = about(m_options.boundary_map, read_points(m_options.boundary_map, images));
    if (!status.ok()) return status;
    if (images.size() != number_of_points)
      return {VMP::ERROR_BOUNDARY_MAP, m_options.boundary_map + ": " + std::to_string(images.size()) +
                                           " points for the " + std::to_string(number_of_points) +
                                           " of the input"};
    status = load_polycube(solid, images);
    if (!status.ok())
      return about(m_options.domain.empty() ? m_options.boundary_map : m_options.domain, status);
    floor_map.emplace(m_polycube, std::move(images));
    status = floor_map->label_boundary(solid);
    if (status.ok()) partitions = Partitions::of_labels(std::move(solid));
    return status;
  }

  Status load_polycube(const Mesh& solid, const std::vector<Point_3>& images) {
    Mesh domain;
    const Status status = load_domain(m_options, solid, images, m_clock, domain);
    return status.ok() ? m_polycube.build(domain, CGAL::parameters::visitor(Clock_visitor(m_clock, "domain: ")))
                       : status;
  }

  Status map_solid() {
    std::optional<Partitions> partitions;
    std::optional<FloorMap> floor_map;
    Status status = load(partitions, floor_map);
    if (!status.ok()) return status;
    const bool is_flux = m_options.field == Field::FLUX;
    VMP::Parameterization_search_options options;
    if (is_flux) options.most_linear_maps = 0;
    m_search.emplace(options, *floor_map);
    const auto type = is_flux ? VMP::FLUX_CURVES : VMP::CERTIFIED_CURVES;
    status = m_search->template run<CGAL::Parallel_if_available_tag>(
        *partitions, VMP::parameters::curve_type(type).visitor(Clock_visitor(m_clock)));
    m_clock.finish();
    report_trials();
    if (parameterizer_or_null()) report_input();
    return status;
  }

  // Of what was cancelled early nothing is known.
  bool is_worth_writing(const Status& status) const {
    const Parameterizer* p = parameterizer_or_null();
    return p && (status.code() != VMP::ERROR_CANCELLED || p->product_structure());
  }

  const Parameterizer* parameterizer_or_null() const { return m_search ? m_search->parameterizer() : nullptr; }
  const Parameterizer& parameterizer() const { return *m_search->parameterizer(); }
  const VMP::Piecewise_linear_map_3<Kernel>& linear_map() const { return m_search->linear_map(); }

  void report_trials() {
    for (const VMP::Parameterization_trial_3& trial : m_search->trials()) {
      if (!trial.partition) continue;
      Json tried = report_candidate(*trial.partition);
      tried["status"] = report_status(trial.status.ok() ? trial.boundary_status : trial.status);
      if (std::isfinite(trial.boundary_energy)) tried["boundary_energy"] = trial.boundary_energy;
      m_report["input"]["tried_partitions"].push_back(tried);
    }
  }

  void report_input() {
    Json& report = m_report["input"];
    const VMP::Parameterization_trial_3& trial = m_search->chosen();
    if (m_options.boundary_map.empty()) report["partition"] = m_input.has_labels ? "labels" : "auto";
    if (trial.partition) report["chosen_partition"] = report_candidate(*trial.partition);
    report["kind"] = m_input.is_surface ? "surface" : "tetrahedra";
    if (m_input.number_of_triangles > 0)
      report["triangles_after_cutting_thin_ones"] = m_input.number_of_triangles;
    report["tetrahedra"] = trial.number_of_cells;
  }

  // The mesh that is written, and the order in which its cells are swept.
  const Mesh& object() const {
    return linear_map().is_valid() ? linear_map().mesh() : parameterizer().mesh();
  }
  const std::vector<VMP::Cell_index>& order() const {
    return linear_map().is_valid() ? linear_map().order() : parameterizer().product_structure()->order();
  }

  Status write_what_holds() {
    const Parameterizer& p = parameterizer();
    m_clock.start("check and write");
    report_mesh();
    Status status = VMP::IO::write_MEDIT(m_folder.file(Result_folder::object), object());
    if (status.ok() && p.product_structure()) status = m_folder.write_order(Result_folder::order, order());
    if (status.ok() && m_polycube.is_valid()) status = write_polycube();
    if (p.curve_field()) report_fields();
    if (status.ok() && !p.vertex_images().empty()) status = write_map();
    if (status.ok() && p.product_map() && m_options.hexahedra.is_wanted())
      status = write_hexahedra(p.floor_map()->domain());
    if (m_options.field == Field::PAPER && p.harmonic_function()) report_paper();
    m_clock.finish();
    return status;
  }

  Status write_polycube() {
    const Status status = VMP::IO::write_MEDIT(m_folder.file(Result_folder::domain), m_polycube.mesh());
    return status.ok() ? m_folder.write_order(Result_folder::domain_order,
                                              m_polycube.product().product_structure()->order())
                       : status;
  }

  void report_mesh() {
    const Parameterizer& p = parameterizer();
    const VMP::Preparation& splits = p.preparation();
    m_report["counts"] = {{"tetrahedra", object().number_of_cells()},
                          {"vertices", object().number_of_vertices()},
                          {"boundary_triangles", object().number_of_boundary_facets()},
                          {"genus", p.partition().genus},
                          {"split_boundary_edges", splits.boundary_edges},
                          {"split_interior_edges", splits.interior_edges},
                          {"split_facets", splits.facets},
                          {"sweep", report_sweep(p.sweep_report())}};
    m_report["partition"] = report_partition(p.partition());
    m_report["certificates"] = {{"handlebody", p.is_certified()},
                                {"longest_word", p.handlebody_certificate().longest_word()},
                                {"product", p.product_structure() != nullptr},
                                {"curves", p.product_map() != nullptr && m_options.field != Field::FLUX},
                                {"piecewise_linear", false}};
  }

  void report_fields() {
    const Parameterizer& p = parameterizer();
    m_report["residuals"] = {{"harmonic_function", p.harmonic_function()->residual()},
                             {"dual_potential", p.dual_potential()->residual()},
                             {"flux", p.flux_field()->residual()},
                             {"largest_divergence", p.flux_field()->largest_divergence()}};
    m_report["maximum_principle"] = report_maximum_principle(*p.harmonic_function());
    auto& critical = m_singularities.critical_vertices;
    const Status status = VMP::find_critical_points(p.mesh(), p.harmonic_function()->values(), critical);
    m_report["critical_points"] =
        status.ok() ? report_critical_points(p.mesh(), critical) : report_status(status);
    m_singularities.irregular_edges = VMP::irregular_edges(p.mesh(), *p.flux_field());
    m_report["irregular_edges_of_flux"] = report_irregular_edges(p.mesh(), m_singularities.irregular_edges);
    m_angles = angles_to_gradient(p, [&](VMP::Cell_index c) { return p.curve_field()->vector(p.mesh(), c); });
    m_report["angles"] = report_angles(p, m_angles);
  }

  Status write_map() {
    const Parameterizer& p = parameterizer();
    const VMP::Map_report map = VMP::verify_map(p.mesh(), p.vertex_images());
    m_report["vertex_map"] = {{"flipped", map.flipped},
                              {"flat", map.flat},
                              {"off_axis_boundary_triangles", map.off_axis},
                              {"overlapping_boundary_triangles", map.overlaps},
                              {"status", report_status(map.status)}};
    m_report["domain"] = report_domain(p.floor_map()->domain());
    report_floor(*p.floor_map());
    if (m_options.field == Field::FLUX && !map.is_bijective()) m_not_certified = map.status;
    Result_fields fields;
    Status status = result_fields(fields);
    if (status.ok()) status = write_linear_map(map.is_bijective(), fields);
    if (status.ok())
      status = write_result(m_folder, object(), fields, height_of(p.floor_map()->domain()), m_singularities);
    if (status.ok()) status = write_curves(m_folder, *p.product_map());
    return status;
  }

  void report_floor(const Prism_floor_map& map) {
    m_report["floor_distortion"] =
        report_distortion(VMP::measure_floor_distortion(parameterizer().mesh(), map));
  }
  void report_floor(const Given_boundary_map&) {}

  // A piecewise linear map is handed out only if it is bijective: the untangled one, or that of the vertices along curves.
  Status write_linear_map(bool vertex_map_is_bijective, const Result_fields& fields) {
    const bool is_linear = linear_map().is_valid() || vertex_map_is_bijective;
    const std::vector<Point_3>& images = linear_map().is_valid() ? linear_map().images() : fields.images;
    m_report["certificates"]["piecewise_linear"] = is_linear;
    m_report["distortion"] = report_distortion(VMP::measure_distortion(object(), images));
    Json& report = m_report["piecewise_linear_map"];
    if (m_options.field != Field::FLUX)
      report = {{"status", report_status(m_search->linear_status())},
                {"untangling", report_untangling(linear_map().report())}};
    report["tetrahedra_before"] = parameterizer().mesh().number_of_cells();
    report_distance_to_phi(images);
    report_lines(*parameterizer().floor_map(), images);
    if (!is_linear && m_not_certified.ok()) m_not_certified = m_search->linear_status();
    if (!is_linear) return {};
    Soup image = VMP::make_soup(object());
    image.points = images;
    return VMP::IO::write_MEDIT(m_folder.file(Result_folder::parameter), image);
  }

  void report_distance_to_phi(const std::vector<Point_3>& images) {
    using Tag = CGAL::Parallel_if_available_tag;
    const auto& phi = *parameterizer().product_map();
    VMP::Map_distance distance;
    const Status status = linear_map().is_valid() ? VMP::measure_map_distance<Tag>(phi, linear_map(), distance)
                                              : VMP::measure_map_distance<Tag>(phi, images, distance);
    m_report["piecewise_linear_map"]["distance_to_phi"] =
        status.ok() ? report_distance(distance, images) : report_status(status);
  }

  // The curves of a given polycube need not be straight.
  void report_lines(const Prism_floor_map&, const std::vector<Point_3>& images) {
    m_report["piecewise_linear_map"]["w_lines_to_gradient_of_w"] = report_line_angles(object(), images);
  }
  void report_lines(const Given_boundary_map&, const std::vector<Point_3>&) {}

  // Fields of the mesh that is written, which may be finer than the one that they were computed on.
  Status result_fields(Result_fields& fields) const {
    const Parameterizer& p = parameterizer();
    fields = {p.harmonic_function()->values(), p.vertex_images(), positions(), m_angles};
    if (!linear_map().is_valid()) return {};
    const auto locations = linear_map().locations(p.mesh());
    fields.f.clear();
    for (const auto& l : locations) fields.f.push_back(l.value(p.mesh(), p.harmonic_function()->values()));
    fields.angles.clear();
    for (VMP::Cell_index c : linear_map().origins(p.mesh())) fields.angles.push_back(m_angles[c]);
    return p.product_map()->template images<CGAL::Parallel_if_available_tag>(locations, fields.images);
  }

  std::vector<int> positions() const {
    std::vector<int> result(object().number_of_cells(), 0);
    if (parameterizer().product_structure())
      for (std::size_t k = 0; k < order().size(); ++k) result[order()[k]] = int(k);
    return result;
  }

  // What w is a share of.
  static double height_of(const VMP::Prism_3<Kernel>& domain) { return domain.height(); }
  static double height_of(const Polycube&) { return 1; }

  // The program does not accept --hexes with --domain.
  Status write_hexahedra(const Polycube&) { return {}; }

  Status write_hexahedra(const VMP::Prism_3<Kernel>&) {
    VMP::Hexahedron_soup_3<Point_3> hexahedra;
    const Status status =
        make_hexahedra(m_options.hexahedra, parameterizer(), linear_map(), m_report, hexahedra);
    if (status.ok()) return write_hexahedra_files(m_folder, hexahedra, m_options.hexahedra.formats);
    if (m_not_certified.ok()) m_not_certified = status;
    return {};
  }

  // Steps 3 to 5 of the paper on the same mesh: how many interior vertices arrive at each base.
  void report_paper() {
    const auto& mesh = parameterizer().mesh();
    const VMP::Averaged_gradient_field_3<Mesh> field(mesh,
                                                     parameterizer().harmonic_function()->values());
    for (const auto& [name, base] :
         {std::pair<const char*, int>("floor", VMP::FLOOR), {"ceiling", VMP::CEILING}}) {
      const auto interior = field.arrivals(base), wall = field.arrivals_on_walls(base);
      m_report["paper"][name] = {{"share_of_interior_vertices", interior.share()},
                                 {"left_through_wall", interior.left_through_wall},
                                 {"stuck", interior.stuck},
                                 {"share_of_wall_vertices", wall.share()}};
    }
    if (m_not_certified.ok())
      m_not_certified = {VMP::ERROR_CURVE_LOST, "the paper's averaged gradient certifies nothing; see report.json"};
  }

  int exit_code(const Status& status) const {
    return status.ok() && m_not_certified.ok() ? EVERYTHING_CERTIFIED : NOT_CERTIFIED;
  }

  int finish(const Status& status, int exit_code) {
    return end_report(m_options.input.file, status, exit_code, m_clock, m_report, m_folder);
  }

  const Parameterize_options& m_options;
  Result_folder m_folder;
  Stage_clock m_clock;
  Polycube m_polycube; // if one is given
  Input m_input;
  std::optional<Search> m_search;
  Json m_report;
  std::vector<double> m_angles; // between curves and grad f, in degrees
  Singularities m_singularities;
  Status m_not_certified; // why something that was asked for does not hold
};

} // namespace

int parameterize(const Parameterize_options& options) {
  const Thread_limit limit(options.threads);
  Chosen_solver_traits::choose(options.solver);
  return options.boundary_map.empty() ? Parameterization<Prism_floor_map>(options).run()
                                      : Parameterization<Given_boundary_map>(options).run();
}
