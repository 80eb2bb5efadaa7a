#include "commands.h"
#include "load_input.h"

#include <CGAL/Volume_mesh_parameterization/check_surface.h>
#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>

#include <iostream>

using VMP::Status;

namespace {

void print_patches(const VMP::Boundary_partition_3& partition) {
  for (const VMP::Boundary_patch_3& p : partition.patches)
    std::cout << "  " << p.name() << ": " << p.number_of_facets << " triangles, area " << p.area << ", Euler number "
              << p.euler_number << ", " << p.number_of_border_loops << " border loops, " << p.number_of_components
              << " component(s)\n";
}

Status read_solid(const Input_options& options, bool quiet, Mesh& mesh) {
  if (!is_surface_file(options.file)) return read_tetrahedra(options.file, mesh);
  VMP::Triangle_soup_3<Point_3> surface;
  Soup soup;
  Status status = read_surface(options.file, surface);
  if (!status.ok()) return status;
  if (!quiet)
    std::cout << "surface: " << surface.points.size() << " vertices, " << surface.triangles.size()
              << " triangles, closed, manifold, without self-intersections, genus " << VMP::genus(surface) << '\n';
  status = VMP::tetrahedralize(surface, soup, options.number_of_tetrahedra);
  return status.ok() ? mesh.assign(soup) : status;
}

Status check_labels(const Mesh& mesh, const VMP::Handlebody_certificate& certificate, bool quiet) {
  VMP::Boundary_partition_3 partition;
  Status status = VMP::validate_partition(mesh, partition);
  if (!quiet) print_patches(partition);
  if (status.ok()) status = VMP::validate_fundamental_group(mesh, certificate);
  if (status.ok() && !quiet) std::cout << "labels: a legal partition\n";
  return status;
}

Status check_solid(const Input_options& options, bool quiet) {
  Mesh mesh;
  VMP::Handlebody_certificate certificate;
  Status status = read_solid(options, quiet, mesh);
  if (!status.ok()) return status;
  if (!quiet)
    std::cout << "solid: " << mesh.number_of_vertices() << " vertices, " << mesh.number_of_cells()
              << " tetrahedra, all positive, manifold, connected boundary\n";
  status = VMP::certify_handlebody(mesh, certificate);
  if (!status.ok()) return status;
  if (!quiet)
    std::cout << "handlebody: genus " << certificate.genus() << ", certified by a collapse to a graph, longest word "
              << certificate.longest_word() << '\n';
  const auto labels = mesh.labelled_facets();
  const bool has_labels =
      !is_surface_file(options.file) && std::any_of(labels.begin(), labels.end(), [](const auto& f) { return f.label != 0; });
  return has_labels ? check_labels(mesh, certificate, quiet) : Status();
}

} // namespace

int check(const Input_options& options, bool quiet) {
  const Status status = check_solid(options, quiet);
  return status.ok() ? EVERYTHING_CERTIFIED : say(options.file, status, INPUT_REFUSED);
}
