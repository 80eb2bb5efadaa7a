#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Cell_locator_3.h>
#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/measure_map_distance.h>

#include "solid_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

void require(const VMP::Status& status) {
  if (!status.ok()) std::cerr << status.message() << std::endl;
  assert(status.ok());
}

template <typename Kernel>
class Solid {
public:
  using Point_3 = typename Kernel::Point_3;

  explicit Solid(const VMP::Tetrahedron_soup_3<Point_3>& soup) {
    require(m_parameterizer.run(soup));
    require(VMP::make_piecewise_linear(m_parameterizer, m_linear));
  }

  void test() const {
    VMP::Map_distance distance;
    require(VMP::measure_map_distance(phi(), m_linear, distance));
    std::cout << m_linear.images().size() << " vertices, distance "
              << distance.at_vertices.mean() << " and " << distance.at_barycentres.mean() << std::endl;
    const std::vector<double> ones(m_linear.images().size(), 1.);
    assert(is_close(distance.at_vertices,
                    to_phi(m_linear.locations(m_parameterizer.mesh()), m_linear.images(), ones)));
    const auto volumes = VMP::measure_volumes(m_linear.mesh(), m_linear.mesh().points());
    assert(is_close(distance.at_barycentres, to_phi(located(barycentres(m_linear.mesh().points())),
                                                    barycentres(m_linear.images()), volumes)));
  }

  // Of the vertices along curves, and of one that has been moved.
  void test_vertex_map() const {
    VMP::Map_distance distance;
    auto images = m_parameterizer.vertex_images();
    require(VMP::measure_map_distance(phi(), images, distance));
    assert(distance.at_vertices.maximum() == 0 && distance.at_barycentres.mean() > 0);
    images[3] = images[3] + typename Kernel::Vector_3(0, 3, 4);
    require(VMP::measure_map_distance(phi(), images, distance));
    assert(std::abs(distance.at_vertices.maximum() - 5) < 1e-12);
    assert(std::abs(distance.at_vertices.mean() * double(images.size()) - 5) < 1e-9);
  }

  void test_refused() const {
    VMP::Map_distance distance;
    VMP::Status status = VMP::measure_map_distance(phi(), VMP::Piecewise_linear_map_3<Kernel>(), distance);
    assert(status.code() == VMP::ERROR_WRONG_PARAMETER);
    status = VMP::measure_map_distance(phi(), std::vector<Point_3>(1), distance);
    assert(status.code() == VMP::ERROR_WRONG_PARAMETER &&
           status.detail().find("images") != std::string::npos);
    assert(distance.at_vertices.maximum() == 0 && distance.at_barycentres.maximum() == 0);
  }

private:
  const typename VMP::Direct_product_parameterizer_3<Kernel>::Product_map& phi() const {
    return *m_parameterizer.product_map();
  }

  std::vector<Point_3> barycentres(const std::vector<Point_3>& points) const {
    std::vector<Point_3> result;
    for (VMP::Cell_index c : m_linear.mesh().cells()) {
      const auto& v = m_linear.mesh().cell(c);
      result.push_back(CGAL::centroid(points[v[0]], points[v[1]], points[v[2]], points[v[3]]));
    }
    return result;
  }

  // The places of points that are looked for in space.
  std::vector<VMP::Location_3<Kernel>> located(const std::vector<Point_3>& points) const {
    const VMP::Cell_locator_3<Kernel> locator(m_parameterizer.mesh());
    std::vector<VMP::Location_3<Kernel>> result(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) require(locator.locate(points[i], result[i]));
    return result;
  }

  VMP::Weighted_statistics to_phi(const std::vector<VMP::Location_3<Kernel>>& places,
                                  const std::vector<Point_3>& images,
                                  const std::vector<double>& weights) const {
    std::vector<double> distances;
    for (std::size_t i = 0; i < places.size(); ++i) {
      Point_3 image;
      require(phi().image(places[i], image));
      distances.push_back(std::sqrt(CGAL::to_double(CGAL::squared_distance(image, images[i]))));
    }
    return {distances, weights};
  }

  static bool is_close(const VMP::Weighted_statistics& a, const VMP::Weighted_statistics& b) {
    const auto near = [](double x, double y) { return std::abs(x - y) < 1e-10; };
    return near(a.maximum(), b.maximum()) && near(a.mean(), b.mean()) && near(a.minimum(), b.minimum());
  }

  VMP::Direct_product_parameterizer_3<Kernel> m_parameterizer;
  VMP::Piecewise_linear_map_3<Kernel> m_linear;
};

int main() {
  for (Shape shape : {Shape::BENT, Shape::JITTERED}) {
    const Solid<Inexact> solid(shaped_block<Inexact::Point_3>(shape, 1, 2, 3));
    solid.test();
    solid.test_vertex_map();
    solid.test_refused();
  }
  Solid<Exact>(shaped_block<Exact::Point_3>(Shape::BENT, 0, 1, 2)).test();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
