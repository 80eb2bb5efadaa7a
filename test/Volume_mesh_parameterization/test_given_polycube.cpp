#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/image_of_boundary.h>
#include <CGAL/Volume_mesh_parameterization/label_polycube.h>
#include <CGAL/Volume_mesh_parameterization/measure_map_distance.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize_polycube.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "io_test_util.h"
#include "polycube_test_util.h"
#include "solid_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>

// From cells to the map: polycubes with steps and overhangs, onto which a solid is mapped that is their image under a known
// homeomorphism.

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

void require(const VMP::Status& status) {
  if (!status.ok()) std::cerr << status.message() << std::endl;
  assert(status.ok());
}

// A smooth homeomorphism of space, with simple numbers, which keep exact coordinates short.
template <typename Point>
Point bent(const Point& p) {
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  const FT y = p.y() + p.x() * p.x() / FT(8), z = p.z() + p.x() * y / FT(16);
  return Point(p.x() + z * z / FT(16), y, z);
}

template <typename Kernel>
class Given_polycube_test {
  using Point_3 = typename Kernel::Point_3;
  using FT = typename Kernel::FT;
  using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
  using Polycube = VMP::Polycube_3<Kernel>;
  using Boundary_map = VMP::Boundary_map_3<Polycube>;
  using Parameterizer =
      VMP::Direct_product_parameterizer_3<Kernel, VMP::Default_solver_traits_3, Boundary_map>;
  using Location = VMP::Location_3<Kernel>;

public:
  // The solid has another mesh than the polycube.
  Given_polycube_test(const std::vector<Cell>& cells, std::size_t polycube_size, std::size_t solid_size) {
    Mesh polycube, straight;
    require(VMP::tetrahedralize_polycube(cubes<Point_3>(cells), polycube, polycube_size));
    require(VMP::tetrahedralize_polycube(cubes<Point_3>(cells), straight, solid_size));
    require(VMP::label_polycube_by_height(polycube));
    require(m_polycube.build(polycube));
    require(m_solid.assign(transformed(VMP::make_soup(straight), bent<Point_3>)));
    m_images = straight.points();
  }

  void run(int points, double tolerance) {
    const Boundary_map boundary_map(m_polycube, m_images);
    require(boundary_map.label_boundary(m_solid));
    m_parameterizer = std::make_unique<Parameterizer>(boundary_map);
    require(m_parameterizer->run(m_solid));
    require(VMP::verify_product(mesh(), m_parameterizer->product_structure()->order()));
    require(VMP::verify_product(m_polycube.mesh(), m_polycube.product().product_structure()->order()));
    std::vector<Location> locations;
    for (int k = 0; k < points; ++k)
      locations.push_back({VMP::Cell_index(m_random.below(mesh().number_of_cells())),
                           m_random.weights<FT, 4>(1 + unsigned(m_random.below(15)))});
    std::vector<Point_3> images;
    require(map().template images<CGAL::Parallel_if_available_tag>(locations, images));
    test_levels(locations, images, tolerance);
    test_boundary();
    test_round_trips(images, locations, tolerance);
    test_batch_failures();
    test_distance();
  }

  // The polycube that is left out is the image of the boundary map.
  void test_left_out() {
    VMP::Polygon_soup_3<Point_3> image;
    Mesh mesh;
    require(VMP::image_of_boundary(m_solid, m_images, image));
    assert(image.polygons.size() == m_solid.number_of_boundary_facets());
    require(VMP::tetrahedralize_polycube(image, mesh));
    require(VMP::label_polycube_by_height(mesh));
    Polycube polycube;
    require(polycube.build(mesh));
    Mesh solid = m_solid;
    require(Boundary_map(polycube, m_images).label_boundary(solid));
    for (VMP::Facet_index f : solid.boundary_facets()) assert(solid.label(f) == m_solid.label(f));
    std::vector<Point_3> wrong = m_images;
    wrong.resize(1);
    expect(VMP::image_of_boundary(m_solid, wrong, image), VMP::ERROR_BOUNDARY_MAP, "has no image");
    wrong = m_images;
    wrong[0] = Point_3(.1, .2, .3);
    expect(VMP::image_of_boundary(m_solid, wrong, image), VMP::ERROR_BOUNDARY_MAP, "no axis");
    wrong[0] = Point_3(0, std::numeric_limits<double>::infinity(), 0);
    expect(VMP::image_of_boundary(m_solid, wrong, image), VMP::ERROR_COORDINATE_NOT_FINITE, "vertex 0");
    assert(image.polygons.size() == m_solid.number_of_boundary_facets());
  }

private:
  const Mesh& mesh() const { return m_parameterizer->mesh(); }
  const typename Parameterizer::Product_map& map() const { return *m_parameterizer->product_map(); }

  // The share of the level below a point, and whether the level is the harmonic function f all along its curve.
  struct Share {
    FT w;
    bool is_harmonic;
  };
  template <typename Product>
  static Share share(const Product& product, const Location& p) {
    const auto curves = product.curves();
    Share result{FT(0), true};
    FT gain[2] = {FT(0), FT(0)};
    for (auto direction : {VMP::DOWN, VMP::UP}) {
      Location at = p;
      VMP::Half_facet arrival;
      require(curves.trace(at, direction, FT(-1), arrival, gain[direction == VMP::UP],
                           [&](const Location& begin, const Location&, const FT& time) {
                             result.is_harmonic &=
                                 time == 0 || product.curve_field()->follows_harmonic_level(begin.cell);
                           }));
    }
    result.w = gain[0] / (gain[0] + gain[1]);
    return result;
  }

  template <typename Product>
  static double harmonic(const Product& product, const Location& p) {
    double f = 0;
    for (int i = 0; i < 4; ++i)
      f += CGAL::to_double(p.barycentric[i]) *
           (*product.harmonic_function())(product.mesh().vertex(p.cell, i));
    return f;
  }

  // w is kept, and so is f along curves on which w equals f.
  void test_levels(const std::vector<Location>& locations, const std::vector<Point_3>& images,
                   double tolerance) const {
    const VMP::Cell_locator_3<Kernel> locator(m_polycube.mesh());
    double largest = 0, largest_f = 0;
    std::size_t n = 0;
    for (std::size_t k = 0; k < images.size(); ++k) {
      Location image;
      const VMP::Status status = locator.locate(images[k], image);
      if (status.code() == VMP::ERROR_OUTSIDE && tolerance > 0) continue; // rounded off the polycube
      require(status);
      const Share here = share(*m_parameterizer, locations[k]), there = share(m_polycube.product(), image);
      largest = (std::max)(largest, CGAL::to_double(CGAL::abs(here.w - there.w)));
      if (!here.is_harmonic || !there.is_harmonic) continue;
      ++n;
      const double f = harmonic(*m_parameterizer, locations[k]);
      largest_f = (std::max)(largest_f, std::abs(f - harmonic(m_polycube.product(), image)));
    }
    std::cout << "w is kept within " << largest << ", f at " << n << " of " << images.size()
              << " points within " << largest_f << std::endl;
    assert(largest <= (std::min)(tolerance, 1e-10) && largest_f < 1e-10 && n > 0);
  }

  // Whether p lies in the plane of a facet, exactly.
  static bool is_in_plane(const Mesh& mesh, VMP::Facet_index f, const Point_3& p) {
    const auto v = mesh.vertices(f);
    for (int axis = 0; axis < 3; ++axis)
      if (mesh.point(v[0])[axis] == mesh.point(v[1])[axis] &&
          mesh.point(v[0])[axis] == mesh.point(v[2])[axis])
        return p[axis] == mesh.point(v[0])[axis];
    return false;
  }

  // Points of floor and ceiling go to facets with the same label, those of the wall to the wall.
  void test_boundary() {
    std::size_t outside = 0, tested = 0;
    for (VMP::Facet_index f : mesh().boundary_facets()) {
      if (m_random.below(4) != 0) continue;
      const Location p = m_parameterizer->curves().locate({f, m_random.weights<FT, 3>(7)});
      Point_3 image(0, 0, 0);
      require(map().image(p, image));
      ++tested;
      outside += !is_on_boundary(image, mesh().label(f));
    }
    std::cout << outside << " of " << tested << " boundary points are off their patch" << std::endl;
    assert(outside == 0);
  }

  bool is_on_boundary(const Point_3& p, int label) const {
    const Mesh& polycube = m_polycube.mesh();
    for (VMP::Facet_index f : polycube.boundary_facets()) {
      const auto v = polycube.vertices(f);
      if (polycube.label(f) != label || !is_in_plane(polycube, f, p)) continue;
      const typename Kernel::Triangle_3 triangle(polycube.point(v[0]), polycube.point(v[1]),
                                                 polycube.point(v[2]));
      if (CGAL::to_double(CGAL::squared_distance(CGAL::centroid(triangle), p)) < 4 && triangle.has_on(p))
        return true;
    }
    return false;
  }

  void test_round_trips(const std::vector<Point_3>& images, const std::vector<Location>& locations,
                        double tolerance) const {
    std::vector<Point_3> inside;
    std::vector<std::size_t> numbers;
    const VMP::Cell_locator_3<Kernel> locator(m_polycube.mesh());
    for (std::size_t k = 0; k < images.size(); ++k) {
      Location at;
      if (!locator.locate(images[k], at).ok()) continue;
      inside.push_back(images[k]);
      numbers.push_back(k);
    }
    assert((images.size() - inside.size()) * 1000 <= images.size());
    std::vector<Location> back;
    require(map().template preimages<CGAL::Parallel_if_available_tag>(inside, back));
    FT largest(0);
    for (std::size_t i = 0; i < inside.size(); ++i)
      largest = (std::max)(
          largest, FT(CGAL::squared_distance(back[i].point(mesh()), locations[numbers[i]].point(mesh()))));
    std::cout << "round trips within " << std::sqrt(CGAL::to_double(largest)) << std::endl;
    assert(largest <= tolerance * tolerance);
  }

  void test_batch_failures() const {
    std::vector<Location> result(1);
    expect(map().preimages({Point_3(.5, .5, .5), Point_3(-1, 0, 0), Point_3(99, 0, 0)}, result),
           VMP::ERROR_OUTSIDE, "(-1, 0, 0)");
    assert(result.size() == 1);
  }

  void test_distance() const {
    VMP::Map_distance distance;
    std::vector<Point_3> images = m_parameterizer->vertex_images();
    require(VMP::measure_map_distance(map(), images, distance));
    std::cout << "piecewise linear within " << distance.at_barycentres.maximum() << ", in the mean "
              << distance.at_barycentres.mean() << std::endl;
    assert(distance.at_vertices.maximum() == 0 && distance.at_barycentres.mean() > 0 &&
           distance.at_barycentres.maximum() < 1);
    images[3] = images[3] + typename Kernel::Vector_3(0, 3, 4);
    require(VMP::measure_map_distance(map(), images, distance));
    assert(std::abs(distance.at_vertices.maximum() - 5) < 1e-12);
    assert(std::abs(distance.at_vertices.mean() * double(images.size()) - 5) < 1e-9);
    images.pop_back();
    expect(VMP::measure_map_distance(map(), images, distance), VMP::ERROR_WRONG_PARAMETER, "images");
  }

  Polycube m_polycube;
  Mesh m_solid;
  std::vector<Point_3> m_images; // of the vertices of the solid
  std::unique_ptr<Parameterizer> m_parameterizer;
  Random m_random{7};
};

int main() {
  for (const auto& cells : {l_stairs(), overhang(), ring()}) {
    Given_polycube_test<Inexact> test(cells, 1500, 4000);
    test.run(2000, 1e-11);
    test.test_left_out();
  }
  Given_polycube_test<Exact>({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, 0, 0).run(20, 0);
  return EXIT_SUCCESS;
}
