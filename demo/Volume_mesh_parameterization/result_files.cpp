#include "result_files.h"

#include <CGAL/Volume_mesh_parameterization/IO/Abaqus.h>
#include <CGAL/Volume_mesh_parameterization/IO/Gmsh.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTP.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

using VMP::Status;

namespace {

// Polylines with the level w at each point, in the solid or in the domain.
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

  void add(int curve, int domain, const Mesh& mesh, const VMP::Integral_curve_3<Kernel>& polyline) {
    std::vector<Point_3> points = {polyline.segments().front().begin.point(mesh)};
    std::vector<double> levels_of_points = {0};
    for (const auto& s : polyline.segments()) {
      points.push_back(s.end.point(mesh));
      levels_of_points.push_back(s.level / polyline.total_level());
    }
    add(curve, domain, points, levels_of_points);
  }
};

constexpr std::size_t about_curves = 120;

// Floor points over a grid of the domain, so that rims and corners have their curves too.
std::vector<Kernel::Point_2> some_feet(const VMP::Product_map_3<Kernel, Prism_floor_map>& map) {
  const VMP::Prism_grid grid = VMP::prism_grid_of_size(map.domain(), about_curves);
  std::vector<Kernel::Point_2> feet;
  for (double x : grid.x)
    for (double y : grid.y)
      if (map.domain().bounded_side(Kernel::Point_2(x, y)) != CGAL::ON_UNBOUNDED_SIDE) feet.emplace_back(x, y);
  return feet;
}

// Below the middles and the vertices of some triangles of the floor of the solid.
std::vector<VMP::Base_point_3<Kernel>> some_feet(const VMP::Product_map_3<Kernel, Given_boundary_map>& map) {
  std::vector<VMP::Base_point_3<Kernel>> all, feet;
  const Mesh& mesh = map.curves().mesh();
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    if (mesh.label(f) != VMP::FLOOR) continue;
    all.push_back({f, {1. / 3, 1. / 3, 1. / 3}});
    all.push_back({f, {1, 0, 0}});
  }
  for (std::size_t k = 0; k < all.size(); k += 1 + all.size() / about_curves) feet.push_back(map.floor_map().image(all[k]));
  return feet;
}

Status add_image(const VMP::Prism_3<Kernel>& domain, const Kernel::Point_2& foot, int number, Curve_collection& curves) {
  curves.add(number, 1, {Point_3(foot.x(), foot.y(), 0), Point_3(foot.x(), foot.y(), domain.height())}, {0, 1});
  return {};
}

Status add_image(const Polycube& domain, const VMP::Base_point_3<Kernel>& foot, int number, Curve_collection& curves) {
  VMP::Integral_curve_3<Kernel> curve;
  const Status status = domain.curve_over(foot, curve);
  if (status.ok()) curves.add(number, 1, domain.mesh(), curve);
  return status;
}

template <typename FloorMap>
Status write_some_curves(const Result_folder& folder, const VMP::Product_map_3<Kernel, FloorMap>& map) {
  Curve_collection collection;
  int number = 0;
  for (const auto& foot : some_feet(map)) {
    VMP::Integral_curve_3<Kernel> curve;
    Status status = map.curve_over(foot, curve);
    if (status.ok()) status = add_image(map.domain(), foot, number, collection);
    if (!status.ok()) return status;
    collection.add(number++, 0, map.curves().mesh(), curve);
  }
  return VMP::IO::write_VTP(folder.file(Result_folder::curves), collection.polylines, {{"w", collection.levels}},
                            {{"curve", collection.curves}, {"domain", collection.domains}});
}

// Values of cells, followed by zeros for the facets, the marked vertices and edges of the file.
template <typename T>
std::vector<T> padded(std::vector<T> values, std::size_t size) {
  values.resize(size, T(0));
  return values;
}

Status write_hexahedra_file(const Result_folder& folder, const VMP::Hexahedron_soup_3<Point_3>& hexahedra, const std::string& format) {
  if (format == "gmsh") return VMP::IO::write_Gmsh(folder.file(Result_folder::gmsh_hexahedra), hexahedra);
  if (format == "abaqus") return VMP::IO::write_Abaqus(folder.file(Result_folder::abaqus_hexahedra), hexahedra);
  if (format == "vtu")
    return VMP::IO::write_VTU(folder.file(Result_folder::vtu_hexahedra), hexahedra, {},
                              {{"scaled_jacobian", VMP::scaled_jacobians(hexahedra)}});
  return VMP::IO::write_MEDIT(folder.file(Result_folder::hexahedra), hexahedra);
}

} // namespace

Status write_result(const Result_folder& folder, const Mesh& mesh, const Result_fields& fields, double height,
                    const Singularities& singularities) {
  std::vector<double> u, v, w;
  for (const Point_3& p : fields.images) {
    u.push_back(p.x());
    v.push_back(p.y());
    w.push_back(p.z() / height);
  }
  VMP::IO::VTU_content content;
  for (const VMP::Critical_vertex& v : singularities.critical_vertices) content.marked_vertices.push_back(v.vertex);
  for (const VMP::Irregular_edge& e : singularities.irregular_edges) content.marked_edges.push_back(e.vertices);
  const std::size_t cells = mesh.number_of_cells() + mesh.number_of_boundary_facets() + content.marked_vertices.size() +
                            content.marked_edges.size();
  content.point_data = {{"f", fields.f}, {"u", u}, {"v", v}, {"w", w}};
  content.cell_data = {{"sweep_position", padded(fields.positions, cells)}, {"angle", padded(fields.angles, cells)}};
  return VMP::IO::write_VTU(folder.file(Result_folder::result), mesh, content);
}

Status write_curves(const Result_folder& folder, const VMP::Product_map_3<Kernel, Prism_floor_map>& map) {
  return write_some_curves(folder, map);
}

Status write_curves(const Result_folder& folder, const VMP::Product_map_3<Kernel, Given_boundary_map>& map) {
  return write_some_curves(folder, map);
}

Status write_hexahedra_files(const Result_folder& folder, const VMP::Hexahedron_soup_3<Point_3>& hexahedra,
                             const std::vector<std::string>& formats) {
  Status status;
  for (const std::string& format : formats)
    if (status.ok()) status = write_hexahedra_file(folder, hexahedra, format);
  return status;
}
