// Maps many points of a solid at a time to the prism and back, and measures how near they return.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/Cell_locator_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Location = VMP::Location_3<Kernel>;
using Concurrency_tag = CGAL::Parallel_if_available_tag; // threads, if the program is linked with TBB

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char* argv[]) {
  // 1. Read labelled tetrahedra and parameterize them.
  const std::string filename = argc > 1 ? argv[1] : "data/block_with_hole.mesh";
  VMP::Tetrahedron_soup_3<Point_3> soup;
  VMP::Direct_product_parameterizer_3<Kernel> result;
  VMP::Status status = VMP::IO::read_MEDIT(filename, soup);
  if (status.ok()) status = VMP::parameterize<Concurrency_tag>(soup, result);
  if (!status.ok()) return fail(status);

  // 2. Take points of the box around the solid; those outside, or in the hole, are refused with ERROR_OUTSIDE.
  const VMP::Cell_locator_3<Kernel> locator(result.mesh());
  const CGAL::Bbox_3 box = CGAL::bbox_3(soup.points.begin(), soup.points.end());
  CGAL::Random random(1);
  std::vector<Location> places;
  for (int k = 0; k < 10000; ++k) {
    const Point_3 p{random.get_double(box.xmin(), box.xmax()), random.get_double(box.ymin(), box.ymax()),
                    random.get_double(box.zmin(), box.zmax())};
    Location place;
    if (locator.locate(p, place).ok()) places.push_back(place);
  }

  // 3. Map them to the prism, and their images back to the solid.
  std::vector<Point_3> images;
  std::vector<Location> back;
  status = result.product_map()->images<Concurrency_tag>(places, images);
  if (status.ok()) status = result.product_map()->preimages<Concurrency_tag>(images, back);
  if (!status.ok()) return fail(status);

  // 4. Measure the greatest distance from a point to where it returned.
  double greatest = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    greatest = (std::max)(
        greatest, CGAL::squared_distance(places[i].point(result.mesh()), back[i].point(result.mesh())));
  std::cout << places.size() << " of 10000 points lie in the solid; all return, from at most "
            << std::sqrt(greatest) << " away" << std::endl;
  return EXIT_SUCCESS;
}
