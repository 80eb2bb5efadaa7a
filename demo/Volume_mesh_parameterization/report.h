#ifndef HANDLEBODY_REPORT_H
#define HANDLEBODY_REPORT_H

#include "Result_folder.h"
#include "Stage_clock.h"
#include "result_files.h"
#include "types.h"

#include <CGAL/Volume_mesh_parameterization/Partition_search_3.h>
#include <CGAL/Volume_mesh_parameterization/critical_points.h>
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_map_3.h>
#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>
#include <CGAL/Volume_mesh_parameterization/measure_floor_distortion.h>
#include <CGAL/Volume_mesh_parameterization/measure_map_distance.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#include <nlohmann/json.hpp>

// The sections of report.json. Keys keep the order in which they are written.
using Json = nlohmann::ordered_json;

Json report_status(const VMP::Status& status);
Json report_stages(const Stage_clock& clock);
Json report_partition(const VMP::Boundary_partition_3& partition);
Json report_candidate(const VMP::Partition_candidate_3& candidate);
Json report_sweep(const VMP::Sweep_report& report);
Json report_maximum_principle(const Product::Harmonic_function& f);
Json report_critical_points(const Mesh& mesh, const std::vector<VMP::Critical_vertex>& points);
Json report_irregular_edges(const Mesh& mesh, const std::vector<VMP::Irregular_edge>& edges);
Json report_angles(const Product& product, const std::vector<double>& angles_of_curves);
Json report_domain(const VMP::Prism_3<Kernel>& domain);
Json report_domain(const Polycube& domain);
Json report_distortion(const VMP::Distortion_report& report);
Json report_distortion(const VMP::Floor_distortion_report& report);
Json report_untangling(const VMP::Untangling_report& report);
Json report_distance(const VMP::Map_distance& distance, const std::vector<Point_3>& images);
Json report_line_angles(const Mesh& mesh, const std::vector<Point_3>& images);
Json report_hexahedra(const VMP::Hexahedra_report& report, std::size_t number, bool has_pillow);
Json report_versions();

// Ends the report and writes it into the folder, says a failure, and returns the exit code, that of a refusal if the report cannot
// be written.
int end_report(const std::string& input, const VMP::Status& status, int exit_code, Stage_clock& clock, Json& report,
               const Result_folder& folder);

// The angle in degrees between grad f and a vector of each cell.
template <typename Vector_of_cell>
std::vector<double> angles_to_gradient(const Product& product, Vector_of_cell vector_of_cell) {
  std::vector<CGAL::Simple_cartesian<double>::Vector_3> vectors, gradients;
  for (VMP::Cell_index c : product.mesh().cells()) {
    vectors.push_back(vector_of_cell(c));
    gradients.push_back(product.harmonic_function()->gradient(c));
  }
  return VMP::measure_angles(vectors, gradients);
}

#endif // HANDLEBODY_REPORT_H
