#include "load_domain.h"

#include "load_input.h"
#include "picks.h"

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_cells.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_polygons.h>
#include <CGAL/Volume_mesh_parameterization/image_of_boundary.h>
#include <CGAL/Volume_mesh_parameterization/label_polycube.h>
#include <CGAL/Volume_mesh_parameterization/partition_boundary.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize_polycube.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

using VMP::Status;
using Boxes = VMP::Hexahedron_soup_3<Point_3>;
using Polygons = VMP::Polygon_soup_3<Point_3>;

namespace {

bool holds_hexahedra(const std::string& file) {
  std::ifstream is(file);
  return file_extension(file) == ".mesh" &&
         std::find(std::istream_iterator<std::string>(is), {}, "Hexahedra") != std::istream_iterator<std::string>();
}

// One polycube, as the options say.
class Domain_loader {
public:
  Domain_loader(const Parameterize_options& options, Mesh& domain) : m_options(options), m_domain(domain) {}

  Status load(const Mesh& solid, const std::vector<Point_3>& images) {
    const std::string &file = m_options.domain, format = file_extension(file);
    const bool is_list = format == ".txt" || format == ".cells";
    Boxes boxes;
    if (file.empty()) return fill([&](Polygons& p) { return VMP::image_of_boundary(solid, images, p); });
    if (is_surface_file(file)) return fill([&](Polygons& p) { return VMP::IO::read_polygons(file, p); });
    if (!is_list && !holds_hexahedra(file)) return read_tetrahedra(file, m_domain);
    const Status status = is_list ? VMP::IO::read_cells(file, boxes) : VMP::IO::read_MEDIT(file, boxes);
    return status.ok() ? VMP::tetrahedralize_polycube(boxes, m_domain, m_options.input.number_of_tetrahedra) : status;
  }

  // By picked faces, else labels in the file, else the direction, else the height.
  Status label(Stage_clock& clock) {
    if (!m_options.picks.empty()) return label_picked();
    if (m_options.input.direction) return label_along(*m_options.input.direction, clock);
    const auto labels = m_domain.labelled_facets();
    const bool has_labels = std::any_of(labels.begin(), labels.end(), [](const auto& f) { return f.label != 0; });
    return has_labels ? Status() : VMP::label_polycube_by_height(m_domain);
  }

private:
  template <typename Read>
  Status fill(const Read& read) {
    Polygons polygons;
    Status status = read(polygons);
    if (status.ok() && is_surface_file(m_options.domain)) status = apply_numbered_picks(m_options.picks, polygons);
    return status.ok() ? VMP::tetrahedralize_polycube(polygons, m_domain, m_options.input.number_of_tetrahedra) : status;
  }

  Status label_picked() {
    const Status status = is_surface_file(m_options.domain) ? add_point_picks(m_options.picks, m_domain)
                                                            : apply_picks(m_options.picks, m_domain);
    return status.ok() ? VMP::label_polycube(m_domain) : status;
  }

  // Along an axis by whole faces; else like any solid.
  Status label_along(const std::array<double, 3>& direction, Stage_clock& clock) {
    const auto is_zero = [](double x) { return x == 0; };
    const auto axis = std::find_if_not(direction.begin(), direction.end(), is_zero);
    if (std::count_if(direction.begin(), direction.end(), is_zero) == 2 && std::isfinite(*axis))
      return VMP::label_polycube(m_domain, int(axis - direction.begin()), *axis > 0);
    return VMP::partition_boundary(m_domain, partition_options(m_options.input), nullptr, Clock_visitor(clock));
  }

  const Parameterize_options& m_options;
  Mesh& m_domain;
};

} // namespace

Status load_domain(const Parameterize_options& options, const Mesh& solid, const std::vector<Point_3>& images,
                   Stage_clock& clock, Mesh& domain) {
  clock.start("read and label the domain");
  Domain_loader loader(options, domain);
  const Status status = loader.load(solid, images);
  return status.ok() ? loader.label(clock) : status;
}
