// Transfers a scalar field from one solid with a hole to another one, through the prisms that they are mapped to.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Prism = VMP::Prism_3<Kernel>;

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

// Takes a coordinate of one prism to another: the planes of their sides correspond, between them the map is linear.
double move(double x, const Prism& from, const Prism& to, int axis) {
  const auto planes = [axis](const Prism& p) {
    return std::array<double, 4>{p.outer().low(axis), p.hole(0).low(axis), p.hole(0).high(axis),
                                 p.outer().high(axis)};
  };
  const auto a = planes(from), b = planes(to);
  const int i = (x > a[1]) + (x > a[2]);
  const double share = (x - a[i]) / (a[i + 1] - a[i]), step = b[i + 1] - b[i];
  return share < .5 ? b[i] + share * step : b[i + 1] - (1 - share) * step; // exact at both planes
}

int main() {
  // 1. Take two solids with one hole: a block, and a tower that is twisted; that their tetrahedra correspond is made no
  // use of. With several holes, their planes must come in the same order in both prisms. Floor goes to floor and hole to
  // hole; that other features correspond is not to be expected.
  VMP::Tetrahedron_soup_3<Point_3> block;
  VMP::Status status = VMP::IO::read_MEDIT("data/block_with_hole.mesh", block);
  auto tower = block;
  for (Point_3& p : tower.points) {
    const double x = p.x() - 1.5, y = p.y() - 1.5, c = std::cos(p.z()), s = std::sin(p.z());
    p = Point_3(c * x - s * y, s * x + c * y, 3 * p.z());
  }

  // 2. Parameterize both.
  VMP::Direct_product_parameterizer_3<Kernel> source, target;
  if (status.ok()) status = VMP::parameterize(block, source);
  if (status.ok()) status = VMP::parameterize(tower, target);
  if (!status.ok()) return fail(status);

  // 3. Have a field on the source: the distance from a corner.
  std::vector<double> field;
  for (const Point_3& p : source.mesh().points())
    field.push_back(std::sqrt(CGAL::squared_distance(p, Point_3(0, 0, 0))));

  // 4. Take each vertex of the target to its prism, to that of the source, and into the source.
  const Prism &from = target.floor_map()->domain(), &to = source.floor_map()->domain();
  std::vector<Point_3> images;
  for (const Point_3& p : target.vertex_images())
    images.emplace_back(move(p.x(), from, to, 0), move(p.y(), from, to, 1),
                        p.z() / from.height() * to.height());
  std::vector<VMP::Location_3<Kernel>> places;
  status = source.product_map()->preimages(images, places);
  if (!status.ok()) return fail(status);

  // 5. Interpolate there, and write the result.
  std::vector<double> transferred;
  for (const auto& place : places) transferred.push_back(place.value(source.mesh(), field));
  const auto range = std::minmax_element(transferred.begin(), transferred.end());
  std::cout << "transferred distances: " << *range.first << " to " << *range.second << std::endl;
  VMP::IO::VTU_content content;
  content.point_data = {{"field", transferred}};
  status = VMP::IO::write_VTU("transferred_field.vtu", target.mesh(), content);
  return status.ok() ? EXIT_SUCCESS : fail(status);
}
