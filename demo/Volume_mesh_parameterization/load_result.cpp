#include "load_result.h"

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

using VMP::Status;

namespace {

using Patch_boxes = std::map<int, CGAL::Bbox_3>; // around the image of each patch

VMP::Rectangle_2 rectangle(const CGAL::Bbox_3& box) { return {box.xmin(), box.ymin(), box.xmax(), box.ymax()}; }

// The greatest rectangle is the outer one.
VMP::Prism_3<Kernel> prism_in(const Patch_boxes& boxes) {
  std::vector<std::pair<VMP::Rectangle_2, int>> rims; // with labels
  for (const auto& [label, box] : boxes)
    if (label >= VMP::FIRST_WALL) rims.emplace_back(rectangle(box), label);
  const auto outer = std::max_element(rims.begin(), rims.end(), [](const auto& a, const auto& b) { return a.first.area() < b.first.area(); });
  std::iter_swap(rims.begin(), outer);
  std::vector<VMP::Rectangle_2> holes;
  for (std::size_t r = 1; r < rims.size(); ++r) holes.push_back(rims[r].first);
  VMP::Prism_3<Kernel> prism(rims.front().first, holes, boxes.at(VMP::CEILING).zmax());
  for (std::size_t r = 0; r < rims.size(); ++r) prism.set_wall_label(r, rims[r].second);
  return prism;
}

// Whether a triangle lies in a side of a box: at one end along one of the axes from `first` to `last`.
bool is_in_side(const CGAL::Bbox_3& box, const std::array<Point_3, 3>& triangle, int first, int last) {
  for (int axis = first; axis <= last; ++axis)
    for (double end : {(box.min)(axis), (box.max)(axis)})
      if (std::all_of(triangle.begin(), triangle.end(), [&](const Point_3& p) { return p[axis] == end; })) return true;
  return false;
}

} // namespace

Status load_solid(const Result_folder& folder, const char* file, Mesh& mesh, VMP::Boundary_partition_3& partition) {
  Soup soup;
  VMP::Handlebody_certificate certificate;
  Status status = VMP::IO::read_MEDIT(folder.file(file), soup);
  if (status.ok()) status = mesh.assign(soup);
  if (status.ok()) status = VMP::check_tetrahedral_mesh(mesh);
  return status.ok() ? VMP::validate_solid(mesh, partition, certificate) : status;
}

Status load_images(const Result_folder& folder, const Mesh& solid, std::vector<Point_3>& images) {
  Soup soup;
  const Status status = VMP::IO::read_MEDIT(folder.file(Result_folder::parameter), soup);
  if (!status.ok()) return status;
  bool same = soup.points.size() == solid.number_of_vertices() && soup.cells.size() == solid.number_of_cells();
  for (VMP::Cell_index c : solid.cells())
    same = same && std::equal(solid.cell(c).begin(), solid.cell(c).end(), soup.cells[c].begin());
  if (!same) return {VMP::ERROR_MAP_NOT_BIJECTIVE, "it has other vertices or tetrahedra than object.mesh"};
  images = std::move(soup.points);
  return VMP::verify_map(solid, images).status;
}

Status find_prism(const Mesh& solid, const std::vector<Point_3>& images, VMP::Prism_3<Kernel>& prism) {
  Patch_boxes boxes;
  for (VMP::Facet_index f : solid.boundary_facets())
    for (VMP::Vertex_index v : solid.vertices(f)) boxes[solid.label(f)] += images[v].bbox();
  prism = prism_in(boxes);
  bool fits = prism.is_valid() && boxes.at(VMP::FLOOR).zmin() == 0;
  for (VMP::Facet_index f : solid.boundary_facets()) {
    const bool is_base = solid.label(f) == VMP::FLOOR || solid.label(f) == VMP::CEILING;
    const auto v = solid.vertices(f);
    const CGAL::Bbox_3& box = boxes[solid.label(f)];
    fits = fits && (!is_base || box.zmin() == box.zmax()) &&
           is_in_side(box, {images[v[0]], images[v[1]], images[v[2]]}, is_base ? 2 : 0, is_base ? 2 : 1);
  }
  return fits ? Status() : Status(VMP::ERROR_BOUNDARY_MAP, "it is not mapped onto a prism");
}
