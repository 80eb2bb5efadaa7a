#include "result_files.h"

#include <CGAL/Volume_mesh_parameterization/IO/VTP.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>

using VMP::Status;

namespace {

// Floor points over a grid of the domain, so that rims and corners have their curves too.
std::vector<Kernel::Point_2> grid_points(const VMP::Prism_3<Kernel>& domain) {
  constexpr std::size_t number_of_cells = 120;
  const VMP::Prism_grid grid = VMP::prism_grid_of_size(domain, number_of_cells);
  std::vector<Kernel::Point_2> points;
  for (double x : grid.x)
    for (double y : grid.y)
      if (domain.bounded_side(Kernel::Point_2(x, y)) != CGAL::ON_UNBOUNDED_SIDE) points.emplace_back(x, y);
  return points;
}

// Polylines with the level w at each point, in the solid or in the prism.
struct Curve_collection {
  std::vector<std::vector<Point_3>> polylines;
  std::vector<double> levels;
  std::vector<int> curves, domains;

  void add(int curve, int domain, const std::vector<Point_3>& points, const std::vector<double>& levels_of_points) {
    polylines.push_back(points);
    levels.insert(levels.end(), levels_of_points.begin(), levels_of_points.end());
    curves.push_back(curve);
    domains.push_back(domain);
  }
};

Status add_curve(const Parameterizer::Product_map& map, const Kernel::Point_2& q, int number, Curve_collection& collection) {
  VMP::Base_point_3<Kernel> start;
  VMP::Integral_curve_3<Kernel> curve;
  Status status = map.floor_map().preimage(q, start);
  if (status.ok()) status = map.curves().trace_curve(start, curve);
  if (!status.ok()) return status;
  const Mesh& mesh = map.curves().mesh();
  std::vector<Point_3> points = {curve.segments().front().begin.point(mesh)};
  std::vector<double> levels = {0};
  for (const auto& s : curve.segments()) {
    points.push_back(s.end.point(mesh));
    levels.push_back(s.level / curve.total_level());
  }
  collection.add(number, 0, points, levels);
  collection.add(number, 1, {Point_3(q.x(), q.y(), 0), Point_3(q.x(), q.y(), map.floor_map().domain().height())}, {0, 1});
  return {};
}

// Values of cells, followed by zeros for the facets and the marked vertices of the file.
template <typename T>
std::vector<T> padded(std::vector<T> values, std::size_t size) {
  values.resize(size, T(0));
  return values;
}

} // namespace

Status write_result(const Result_folder& folder, const Parameterizer& parameterizer, const std::vector<double>& angles,
                    const std::vector<std::size_t>& critical_vertices) {
  const Mesh& mesh = parameterizer.mesh();
  const double height = parameterizer.floor_map()->domain().height();
  std::vector<double> u, v, w;
  for (const Point_3& p : parameterizer.vertex_images()) {
    u.push_back(p.x());
    v.push_back(p.y());
    w.push_back(p.z() / height);
  }
  std::vector<int> positions(mesh.number_of_cells(), 0);
  if (const auto* structure = parameterizer.product_structure())
    for (VMP::Cell_index c : mesh.cells()) positions[c] = int(structure->position(c));
  const std::size_t cells = mesh.number_of_cells() + mesh.number_of_boundary_facets() + critical_vertices.size();
  VMP::IO::VTU_content content;
  content.marked_vertices = critical_vertices;
  content.point_data = {{"f", parameterizer.harmonic_function()->values()}, {"u", u}, {"v", v}, {"w", w}};
  content.cell_data = {{"sweep_position", padded(positions, cells)}, {"angle", padded(angles, cells)}};
  return VMP::IO::write_VTU(folder.file(Result_folder::result), mesh, content);
}

Status write_curves(const Result_folder& folder, const Parameterizer& parameterizer) {
  const Parameterizer::Product_map& map = *parameterizer.product_map();
  Curve_collection collection;
  int number = 0;
  for (const Kernel::Point_2& q : grid_points(map.floor_map().domain())) {
    const Status status = add_curve(map, q, number++, collection);
    if (!status.ok()) return status;
  }
  return VMP::IO::write_VTP(folder.file(Result_folder::curves), collection.polylines, {{"w", collection.levels}},
                            {{"curve", collection.curves}, {"domain", collection.domains}});
}
