#include "load_input.h"

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTK.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_surface.h>
#include <CGAL/Volume_mesh_parameterization/check_surface.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/make_triangle_soup.h>
#include <CGAL/Volume_mesh_parameterization/remesh_thin_triangles.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <vector>

using VMP::Status;
using Surface = VMP::Triangle_soup_3<Point_3>;

namespace {

// Cuts faces with more than three vertices into triangles.
Status read_polygons(const std::string& file, Surface& surface) {
  CGAL::Surface_mesh<Point_3> mesh;
  try {
    if (CGAL::IO::read_polygon_mesh(file, mesh) && CGAL::Polygon_mesh_processing::triangulate_faces(mesh))
      return VMP::make_triangle_soup(mesh, surface);
  } catch (const std::exception&) { // a failed allocation, or an assertion of the reader
  }
  return {VMP::ERROR_NOT_TRIANGULATED, file + ": the polygons cannot be cut into triangles that make a surface"};
}

Status read_triangles(const std::string& file, Surface& surface) {
  const Status status = VMP::IO::read_surface(file, surface);
  return status.code() == VMP::ERROR_NOT_TRIANGULATED ? read_polygons(file, surface) : status;
}

Status read_soup(const std::string& file, Soup& soup) {
  const std::string format = file_extension(file);
  if (format == ".mesh") return VMP::IO::read_MEDIT(file, soup);
  if (format == ".vtk") return VMP::IO::read_VTK(file, soup);
  if (format == ".vtu") return VMP::IO::read_VTU(file, soup);
  return {VMP::ERROR_WRONG_FORMAT, "the name does not end in .off .obj .ply .stl .mesh .vtk or .vtu"};
}

} // namespace

std::string file_extension(const std::string& file) {
  std::string e = std::filesystem::path(file).extension().string();
  std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return std::tolower(c); });
  return e;
}

VMP::Partition_options partition_options(const Input_options& options) {
  VMP::Partition_options result;
  if (options.direction) result.directions = {{(*options.direction)[0], (*options.direction)[1], (*options.direction)[2]}};
  return result;
}

bool is_surface_file(const std::string& file) {
  const std::string format = file_extension(file);
  return format == ".off" || format == ".obj" || format == ".ply" || format == ".stl";
}

Status read_surface(const std::string& file, Surface& surface) {
  const Status status = read_triangles(file, surface);
  return status.ok() ? VMP::check_surface(surface) : status;
}

bool cut_thin_triangles(const Input_options& options, Surface& surface) {
  const std::size_t before = surface.triangles.size();
  return !options.keeps_triangles && VMP::remesh_thin_triangles(surface).ok() && surface.triangles.size() > before;
}

Status read_tetrahedra(const std::string& file, Mesh& mesh) {
  Soup soup;
  Status status = read_soup(file, soup);
  if (!status.ok()) return status;
  VMP::orient_cells(soup);
  status = mesh.assign(soup);
  return status.ok() ? VMP::check_tetrahedral_mesh(mesh) : status;
}

Status read_points(const std::string& file, std::vector<Point_3>& points) {
  Surface surface;
  Soup soup;
  const Status status = is_surface_file(file) ? read_triangles(file, surface) : read_soup(file, soup);
  points = is_surface_file(file) ? std::move(surface.points) : std::move(soup.points);
  return status;
}

namespace {

Status load_surface(const Input_options& options, Stage_clock& clock, Input& input, std::optional<Partitions>& partitions) {
  if (options.partition == "labels") return {VMP::ERROR_UNLABELLED_FACET, "a surface file has no labels"};
  clock.start("read and check the surface");
  Surface surface;
  const Status status = read_surface(options.file, surface);
  if (!status.ok()) return status;
  if (cut_thin_triangles(options, surface)) input.number_of_triangles = surface.triangles.size();
  partitions.emplace(std::move(surface), options.number_of_tetrahedra, partition_options(options));
  return status;
}

Status load_tetrahedra(const Input_options& options, Stage_clock& clock, Input& input, std::optional<Partitions>& partitions) {
  clock.start("read and check the tetrahedra");
  Mesh mesh;
  const Status status = read_tetrahedra(options.file, mesh);
  if (!status.ok()) return status;
  const auto labels = mesh.labelled_facets();
  const bool is_auto = options.partition == "auto" || (options.partition.empty() && options.direction);
  input.has_labels =
      options.partition == "labels" ||
      (!is_auto && std::any_of(labels.begin(), labels.end(), [](const auto& f) { return f.label != VMP::INTERIOR; }));
  if (input.has_labels)
    partitions = Partitions::of_labels(std::move(mesh));
  else
    partitions.emplace(std::move(mesh), partition_options(options));
  return status;
}

} // namespace

Status load_unlabelled(const Input_options& options, Stage_clock& clock, Mesh& mesh, std::size_t& number_of_points) {
  clock.start("read, check and tetrahedralize");
  const bool is_surface = is_surface_file(options.file);
  Surface surface;
  Status status = is_surface ? read_surface(options.file, surface) : read_tetrahedra(options.file, mesh);
  if (status.ok() && is_surface) status = VMP::tetrahedralize(surface, mesh, options.number_of_tetrahedra);
  number_of_points = is_surface ? surface.points.size() : mesh.number_of_vertices();
  return status;
}

Status load_input(const Input_options& options, Stage_clock& clock, Input& input, std::optional<Partitions>& partitions) {
  input.is_surface = is_surface_file(options.file);
  return input.is_surface ? load_surface(options, clock, input, partitions) : load_tetrahedra(options, clock, input, partitions);
}
