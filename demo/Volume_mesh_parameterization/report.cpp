#include "report.h"
#include "commands.h"

#include <CGAL/Volume_mesh_parameterization/Weighted_statistics.h>
#include <CGAL/version.h>

#include <Eigen/Core>
#include <boost/version.hpp>

#include <cmath>

namespace {

Json report_statistics(const VMP::Weighted_statistics& s, double unit = 1) {
  return {{"minimum", s.minimum() / unit},
          {"mean", s.mean() / unit},
          {"median", s.median() / unit},
          {"quantile_95", s.quantile(0.95) / unit},
          {"maximum", s.maximum() / unit}};
}

// The share of the volume in cells that satisfy a predicate.
template <typename Predicate>
double share_of_volume(const Mesh& mesh, const std::vector<double>& volumes, Predicate predicate) {
  double share = 0, total = 0;
  for (VMP::Cell_index c : mesh.cells()) {
    total += volumes[c];
    if (predicate(c)) share += volumes[c];
  }
  return share / total;
}

Json report_rectangle(const VMP::Rectangle_2& r) {
  return {{"xmin", r.xmin}, {"ymin", r.ymin}, {"xmax", r.xmax}, {"ymax", r.ymax}};
}

} // namespace

Json report_status(const VMP::Status& status) {
  if (status.ok()) return "success";
  return {{"code", int(status.code())}, {"message", status.message()}};
}

Json report_stages(const Stage_clock& clock) {
  Json stages = Json::object();
  for (const Stage_clock::Stage& s : clock.stages()) {
    const double before = stages.contains(s.name) ? stages[s.name]["seconds"].get<double>() : 0; // with another partition
    stages[s.name] = {{"seconds", before + s.seconds}, {"bytes", s.bytes}};
  }
  return stages;
}

Json report_candidate(const VMP::Partition_candidate_3& candidate) {
  const VMP::Partition_quality& q = candidate.quality;
  const VMP::Sweep_direction_3& d = candidate.direction;
  return {{"method", VMP::method_name(candidate.method)},
          {"direction", {d.x(), d.y(), d.z()}},
          {"cost", candidate.cost},
          {"balance", q.balance},
          {"smallest_wall", q.smallest_wall},
          {"rim_length", q.rim_length},
          {"zigzag", q.zigzag},
          {"wall_gap", q.wall_gap},
          {"mean_width", q.mean_width},
          {"alignment", q.alignment},
          {"flat_walls", q.flat_walls},
          {"gradient_spread", q.gradient_spread},
          {"length_spread", q.length_spread},
          {"critical_points_of_trial", q.number_of_critical_points}};
}

Json report_partition(const VMP::Boundary_partition_3& partition) {
  Json patches = Json::object();
  for (const VMP::Boundary_patch_3& p : partition.patches)
    patches[p.name()] = {{"label", p.label},
                         {"facets", p.number_of_facets},
                         {"area", p.area},
                         {"euler_number", p.euler_number},
                         {"border_loops", p.number_of_border_loops},
                         {"components", p.number_of_components}};
  return patches;
}

Json report_sweep(const VMP::Sweep_report& report) {
  return {{"left_at_first", report.left_at_first},
          {"from_ceiling", report.from_ceiling},
          {"restarts", report.restarts},
          {"refinements", report.refinements},
          {"bisected_edges", report.bisected_edges}};
}

Json report_maximum_principle(const Product::Harmonic_function& f) {
  Json violations = Json::array();
  for (VMP::Vertex_index v : f.maximum_principle_violations()) violations.push_back({{"vertex", std::size_t(v)}, {"f", f(v)}});
  return {{"share_of_negative_weights", f.share_of_negative_weights()}, {"violations", violations}};
}

Json report_critical_points(const Mesh& mesh, const std::vector<VMP::Critical_vertex>& points) {
  Json list = Json::array();
  for (const VMP::Critical_vertex& p : points) {
    const Point_3& q = mesh.point(p.vertex);
    list.push_back({{"vertex", std::size_t(p.vertex)},
                    {"index", p.index},
                    {"multiplicity", p.multiplicity},
                    {"on_wall", p.on_wall},
                    {"point", {q.x(), q.y(), q.z()}}});
  }
  return list;
}

Json report_irregular_edges(const Mesh& mesh, const std::vector<VMP::Irregular_edge>& edges) {
  Json list = Json::array();
  for (const VMP::Irregular_edge& e : edges) {
    const Point_3 q = CGAL::midpoint(mesh.point(e.vertices[0]), mesh.point(e.vertices[1]));
    list.push_back({{"vertices", {std::size_t(e.vertices[0]), std::size_t(e.vertices[1])}},
                    {"sign_changes", e.sign_changes},
                    {"middle", {q.x(), q.y(), q.z()}}});
  }
  return list;
}

Json report_angles(const Product& product, const std::vector<double>& angles_of_curves) {
  const Mesh& mesh = product.mesh();
  const std::vector<double> volumes = VMP::measure_volumes(mesh, mesh.points());
  const auto& field = *product.curve_field();
  const auto& flux = *product.flux_field();
  const std::vector<double> angles_of_flux =
      angles_to_gradient(product, [&](VMP::Cell_index c) { return flux.vector(c); });
  Json json = {{"curves_to_gradient", report_statistics({angles_of_curves, volumes})},
               {"flux_to_gradient", report_statistics({angles_of_flux, volumes})}};
  json["share_of_volume_where_w_follows_f"] =
      share_of_volume(mesh, volumes, [&](VMP::Cell_index c) { return field.follows_harmonic_level(c); });
  if (const auto* structure = product.product_structure())
    json["share_of_volume_where_flux_obeys_the_sweep"] =
        share_of_volume(mesh, volumes, [&](VMP::Cell_index c) { return flux.signs(c) == structure->signs(c); });
  return json;
}

Json report_domain(const VMP::Prism_3<Kernel>& domain) {
  Json holes = Json::array();
  for (std::size_t k = 0; k < domain.number_of_holes(); ++k) holes.push_back(report_rectangle(domain.hole(k)));
  return {{"rectangle", report_rectangle(domain.outer())}, {"holes", holes}, {"height", domain.height()}};
}

Json report_domain(const Polycube& domain) {
  return {{"tetrahedra", domain.mesh().number_of_cells()},
          {"partition", report_partition(domain.product().partition())},
          {"sweep", report_sweep(domain.product().sweep_report())}};
}

Json report_distortion(const VMP::Distortion_report& report) {
  return {{"scale", report.scale},
          {"greatest_singular_value", report_statistics(report.greatest_singular_value)},
          {"least_singular_value", report_statistics(report.least_singular_value)},
          {"volume_ratio", report_statistics(report.volume_ratio)},
          {"symmetric_dirichlet_energy", report_statistics(report.symmetric_dirichlet_energy)}};
}

Json report_distortion(const VMP::Floor_distortion_report& report) {
  return {{"scale", report.scale},
          {"greatest_singular_value", report_statistics(report.greatest_singular_value)},
          {"least_singular_value", report_statistics(report.least_singular_value)},
          {"symmetric_dirichlet_energy", report_statistics(report.symmetric_dirichlet_energy)}};
}

Json report_untangling(const VMP::Untangling_report& report) {
  return {{"start", report.starts_along_curves ? "along curves" : "harmonic"},
          {"flipped_at_start", report.flipped_at_start},
          {"flipped_at_end", report.flipped_at_end},
          {"rounds", report.rounds},
          {"split_simplices_inside", report.split_simplices},
          {"refilled_balls", report.refilled_balls},
          {"newton_steps", report.work},
          {"relaxed_clusters", report.relaxed_clusters}};
}

// As shares of the diagonal of the domain.
Json report_distance(const VMP::Map_distance& distance, const std::vector<Point_3>& images) {
  const CGAL::Bbox_3 box = CGAL::bbox_3(images.begin(), images.end());
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
  return {{"diagonal_of_domain", diagonal},
          {"at_vertices", report_statistics(distance.at_vertices, diagonal)},
          {"at_barycentres", report_statistics(distance.at_barycentres, diagonal)}};
}

Json report_line_angles(const Mesh& mesh, const std::vector<Point_3>& images) {
  return report_statistics({VMP::measure_line_angles(mesh, images), VMP::measure_volumes(mesh, mesh.points())});
}

Json report_hexahedra(const VMP::Hexahedra_report& report, std::size_t number, bool has_pillow) {
  return {{"number", number},
          {"pillow", has_pillow},
          {"valid", report.is_valid()},
          {"inverted", report.inverted},
          {"below_0.2", report.poor},
          {"minimum_scaled_jacobian", report.minimum_scaled_jacobian},
          {"mean_scaled_jacobian", report.mean_scaled_jacobian},
          {"irregular_interior_edges", report.irregular_edges},
          {"irregular_interior_vertices", report.irregular_vertices},
          {"genus", report.genus},
          {"euler_characteristic", report.euler_characteristic},
          {"status", report_status(report.status)}};
}

Json report_versions() {
  return {{"handlebody", handlebody_version},
          {"CGAL", CGAL_VERSION_STR},
          {"Boost", BOOST_LIB_VERSION},
          {"Eigen", std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                        std::to_string(EIGEN_MINOR_VERSION)},
          {"compiler", __VERSION__}};
}

int end_report(const std::string& input, const VMP::Status& status, int exit_code, Stage_clock& clock, Json& report,
               const Result_folder& folder) {
  clock.finish();
  report["status"] = report_status(status);
  report["exit_code"] = exit_code;
  report["stages"] = report_stages(clock);
  report["versions"] = report_versions();
  const VMP::Status written = folder.write_text(Result_folder::report, report.dump(2) + "\n");
  if (!written.ok()) return say(input, written, INPUT_REFUSED);
  return status.ok() ? exit_code : say(input, status, exit_code);
}
