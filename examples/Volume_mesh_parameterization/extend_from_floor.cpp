// Extends a function from the floor to the whole solid, constant along the curves that join floor and ceiling: no domain
// is needed for that.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/Direct_product_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/compute_charts.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Concurrency_tag = CGAL::Parallel_if_available_tag; // threads, if the program is linked with TBB

// What is to be extended: rings on the floor.
double value_at(const Point_3& p) { return std::sin(20 * std::hypot(p.x(), p.y())); }

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char* argv[]) {
  // 1. Read labelled tetrahedra and make the solid a product.
  const std::string filename = argc > 1 ? argv[1] : "data/block_with_hole.mesh";
  VMP::Tetrahedron_soup_3<Point_3> soup;
  VMP::Direct_product_3<Kernel> product;
  VMP::Status status = VMP::IO::read_MEDIT(filename, soup);
  if (status.ok()) status = product.build<Concurrency_tag>(soup);
  if (!status.ok()) return fail(status);

  // 2. Place a point at each vertex, in one of its cells.
  const Mesh& mesh = product.mesh();
  std::vector<VMP::Location_3<Kernel>> places(mesh.number_of_vertices());
  for (VMP::Cell_index c : mesh.cells())
    for (int i = 0; i < 4; ++i) {
      places[mesh.vertex(c, i)] = {c, {0, 0, 0, 0}};
      places[mesh.vertex(c, i)].barycentric[i] = 1;
    }

  // 3. Follow the curves through all of them, down and up.
  std::vector<VMP::Curve_chart_3<Kernel>> charts;
  status = VMP::compute_charts<Concurrency_tag>(product.curves(), places, charts);
  if (!status.ok()) return fail(status);

  // 4. Take the value where the curve starts, between the corners of a triangle of the floor.
  std::vector<double> values(charts.size(), 0), shares;
  for (std::size_t k = 0; k < charts.size(); ++k) {
    const auto corners = mesh.vertices(charts[k].floor.facet);
    for (int i = 0; i < 3; ++i) values[k] += charts[k].floor.barycentric[i] * value_at(mesh.point(corners[i]));
    shares.push_back(charts[k].share());
  }

  // 5. Write both for ParaView.
  VMP::IO::VTU_content content;
  content.point_data = {{"value", values}, {"share of the way up", shares}};
  status = VMP::IO::write_VTU("extended.vtu", mesh, content);
  if (!status.ok()) return fail(status);
  std::cout << "wrote " << values.size() << " values to extended.vtu" << std::endl;
  return EXIT_SUCCESS;
}
