#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/optimize_hexahedra.h>

#include "test_util.h"

#include <CGAL/tags.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <set>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
namespace internal = VMP::internal;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Hexahedra = VMP::Hexahedron_soup_3<Point_3>;
using Nodes = std::vector<Eigen::Vector3d>;
using Handles = std::vector<internal::Carriers_3::Handle>;

constexpr double edge = 0.5;

// The block of 1 x 3 x 1 by cubes.
Hexahedra cubes() {
  const VMP::Prism_3<Kernel> prism({0, 0, 1, 3}, {}, 1);
  const auto column = [](const Kernel::Point_2& p, const std::vector<double>& levels, std::vector<Point_3>& points) {
    for (double level : levels) points.push_back(Point_3(p.x(), p.y(), level));
    return VMP::Status();
  };
  Hexahedra result;
  const VMP::Status status = VMP::hexahedral_mesh(prism, VMP::prism_grid(prism, edge), column, result);
  assert(status.ok());
  return result;
}

bool is_on_crease(const Eigen::Vector3d& p) { return p.x() == 0 && p.y() == 0; }

Eigen::Vector3d mean(const internal::Attraction& a, const Nodes& nodes) {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (int i = 0; i < 4; ++i) result += a.weights[i] * nodes[a.nodes[i]];
  return result;
}

// Points are means of nodes of quadrilaterals, as far from the surface, or from a point of it, as is said; places are on the
// surface of the block, and what is cut off is seen along the normal.
void check_attractions(const std::vector<internal::Attraction>& attractions, const Nodes& nodes) {
  std::size_t along_normal = 0;
  for (const internal::Attraction& a : attractions) {
    assert(std::abs(a.weights[0] + a.weights[1] + a.weights[2] + a.weights[3] - 1) < 1e-12);
    assert(*std::min_element(a.weights.begin(), a.weights.end()) > -1e-12);
    const Eigen::Vector3d p = mean(a, nodes), q = a.place;
    assert((p - q).norm() > a.distance - 1e-12);
    const double depth = std::min({q.x(), q.y(), q.z(), 1 - q.x(), 3 - q.y(), 1 - q.z()});
    assert(std::abs(depth) < 1e-12);
    along_normal += (p - q).norm() > a.distance + 1e-3;
  }
  assert(along_normal > 0);
}

// The derivatives of the energy are those of its values.
void check_energy(const std::vector<internal::Attraction>& attractions, Nodes nodes, std::size_t v) {
  constexpr double step = 1e-5;
  const Nodes good = nodes;
  for (int power : {2, 8}) {
    const internal::Surface_attraction energy(attractions, nodes.size(), power, 0.1);
    const auto at = [&](const Eigen::Vector3d& d) {
      nodes[v] = good[v] + d;
      internal::Star_energy::Derivatives result;
      energy.add_to(result, v, nodes);
      assert(std::abs(result.value - energy(v, nodes)) <= 1e-12 * result.value);
      return result;
    };
    const auto here = at(Eigen::Vector3d::Zero());
    assert(here.value > 0);
    for (int i = 0; i < 3; ++i) {
      const auto ahead = at(step * Eigen::Vector3d::Unit(i)), behind = at(-step * Eigen::Vector3d::Unit(i));
      assert(std::abs((ahead.value - behind.value) / (2 * step) - here.gradient[i]) < 1e-5 * (1 + here.gradient.norm()));
      const Eigen::Vector3d column = (ahead.gradient - behind.gradient) / (2 * step);
      assert((column - here.hessian.col(i)).norm() < 1e-5 * (1 + here.hessian.norm()));
    }
  }
}

int main() {
  Mesh solid;
  VMP::Status status = solid.assign(Block_with_holes<Point_3>(0, 2, 2).soup());
  assert(status.ok());
  const Hexahedra hexahedra = cubes();
  Nodes nodes;
  for (const Point_3& p : hexahedra.points) nodes.emplace_back(p.x(), p.y(), p.z());
  internal::Carriers_3 carriers;
  Handles carrier_of_node;
  status = carriers.build(solid, true);
  if (status.ok()) status = internal::find_carriers(carriers, hexahedra, nodes, carrier_of_node);
  assert(status.ok());
  internal::Surface_watch<CGAL::Sequential_tag> watch(internal::Hexahedron_facets(hexahedra.hexahedra).boundary,
                                                      carriers.surface(), internal::surface_points(solid), nodes.size(), 0.3);
  watch.start(nodes);
  for (std::size_t v = 0; v < nodes.size(); ++v) assert(watch.accepts(v, nodes));
  assert(watch.attractions(nodes).empty());

  // Nodes of the crease at the origin leave it along the wall, so that quadrilaterals cut it off.
  std::vector<std::size_t> moved;
  for (std::size_t v = 0; v < nodes.size(); ++v)
    if (is_on_crease(nodes[v])) moved.push_back(v);
  assert(moved.size() == 3);
  const Nodes good = nodes;
  for (std::size_t v : moved) nodes[v].x() = 0.8 * edge;
  for (std::size_t v : moved) assert(!watch.accepts(v, nodes));
  const std::vector<internal::Attraction> attractions = watch.attractions(nodes);
  assert(watch.excess(attractions) > 0 && watch.excess(watch.attractions(good)) == 0);
  check_attractions(attractions, nodes);
  check_energy(attractions, nodes, moved.front());
  std::set<std::size_t> drawn;
  for (const internal::Attraction& a : attractions)
    if (is_on_crease(a.place)) drawn.insert(a.nodes.begin(), a.nodes.end());
  for (std::size_t v : moved) assert(drawn.count(v) == 1);

  // What is so from the start may stay, but not return once it is better.
  watch.start(nodes);
  for (std::size_t v : moved) assert(watch.accepts(v, nodes));
  const Nodes worse = nodes;
  for (std::size_t v : moved) nodes[v].x() = 0;
  for (std::size_t v : moved) watch.take_note(v, nodes);
  for (std::size_t v : moved) assert(watch.accepts(v, nodes) && !watch.accepts(v, worse));

  // A chord may be near enough to the surface when the crease is not near enough to it: that counts once it is asked for.
  nodes = good;
  watch.start(nodes);
  nodes[moved.front()].x() = 0.4 * edge;
  assert(watch.accepts(moved.front(), nodes));
  watch.keep_covered(good);
  assert(!watch.accepts(moved.front(), nodes) && watch.accepts(moved.front(), good));
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
