#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "solid_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

// Keeps the cells whose barycentre is wanted, and the points that they use.
template <typename Soup, typename Predicate>
Soup filtered(const Soup& soup, const Predicate& is_wanted) {
  Soup result;
  std::vector<std::size_t> numbers(soup.points.size(), soup.points.size());
  for (auto cell : soup.cells) {
    double x[3] = {0, 0, 0};
    for (std::size_t v : cell)
      for (int k = 0; k < 3; ++k) x[k] += CGAL::to_double(soup.points[v][k]) / 4;
    if (!is_wanted(x[0], x[1], x[2])) continue;
    for (std::size_t& v : cell) {
      if (numbers[v] == soup.points.size()) {
        numbers[v] = result.points.size();
        result.points.push_back(soup.points[v]);
      }
      v = numbers[v];
    }
    result.cells.push_back(cell);
  }
  return result;
}

// A polycube with a step and an overhang: its floor [0, 1] x [0, 2], its ceiling [0, 1] x [1, 3], the rest a wall.
template <typename Kernel>
VMP::Tetrahedron_soup_3<typename Kernel::Point_3> step(int per_unit) {
  const auto block = Block_with_holes<typename Kernel::Point_3>(0, per_unit, 2 * per_unit, 2).soup();
  return filtered(block, [](double, double y, double z) { return z < 1 ? y < 2 : y > 1; });
}

template <typename Kernel>
void label_step(VMP::Compact_tetrahedral_mesh_3<Kernel>& mesh) {
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    const auto lies_at = [&](int z) {
      return mesh.point(v[0]).z() == z && mesh.point(v[1]).z() == z && mesh.point(v[2]).z() == z;
    };
    mesh.set_label(f, lies_at(0) ? VMP::FLOOR : lies_at(2) ? VMP::CEILING : int(VMP::FIRST_WALL));
  }
}

// A smooth bend of space; with simple numbers, which keep exact coordinates short.
template <typename Point>
Point bent(const Point& p) {
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  const FT z = p.z(), y = p.y();
  return Point(p.x() + z * z / FT(8), y - p.x() * z / FT(16), z + y * y / FT(16));
}

// The solid is the polycube of other resolution, or the same, bent: its boundary map is known.
template <typename Kernel>
class Given_domain_test {
  using Point_3 = typename Kernel::Point_3;
  using FT = typename Kernel::FT;
  using Soup = VMP::Tetrahedron_soup_3<Point_3>;
  using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
  using Polycube = VMP::Polycube_3<Kernel>;
  using Boundary_map = VMP::Boundary_map_3<Polycube>;
  using Parameterizer =
      VMP::Direct_product_parameterizer_3<Kernel, VMP::Default_solver_traits_3, Boundary_map>;

public:
  Given_domain_test(const Mesh& polycube, const Soup& straight_solid)
      : m_images(straight_solid.points), m_solid(transformed(straight_solid, bent<Point_3>)) {
    m_solid.facets.clear();
    const VMP::Status status = m_polycube.build(polycube);
    if (!status.ok()) std::cerr << status.message() << std::endl;
    assert(status.ok() && m_polycube.is_valid());
  }

  void run(int points, double tolerance) {
    Mesh mesh;
    VMP::Status status = mesh.assign(m_solid);
    const Boundary_map boundary_map(m_polycube, m_images);
    if (status.ok()) status = boundary_map.label_boundary(mesh);
    if (!status.ok()) std::cerr << status.message() << std::endl;
    assert(status.ok());
    Parameterizer parameterizer(boundary_map);
    status = parameterizer.run(mesh);
    if (!status.ok()) std::cerr << status.message() << std::endl;
    assert(status.ok());
    assert(VMP::verify_product(parameterizer.mesh(), parameterizer.product_structure()->order()).ok());
    test_floor(parameterizer);
    test_round_trips(parameterizer, points, tolerance);
  }

  void test_refusals() {
    Mesh mesh;
    VMP::Status status = mesh.assign(m_solid);
    assert(status.ok());
    const auto refuses = [&](const std::vector<Point_3>& images, VMP::Error_code code) {
      status = Boundary_map(m_polycube, images).label_boundary(mesh);
      std::cout << status.message() << std::endl;
      assert(status.code() == code);
    };
    refuses({}, VMP::ERROR_BOUNDARY_MAP);
    std::vector<Point_3> images = m_images;
    images[0] = Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
    refuses(images, VMP::ERROR_COORDINATE_NOT_FINITE);
    images[0] = Point_3(0.01, 0.02, 0.03); // the facets at the corner (0, 0, 0) leave their planes
    refuses(images, VMP::ERROR_BOUNDARY_MAP);
    const auto mirrored = [](const Point_3& p) { return Point_3(1 - p.x(), p.y(), p.z()); };
    std::transform(m_images.begin(), m_images.end(), images.begin(), mirrored);
    refuses(images, VMP::ERROR_BOUNDARY_MAP);
    const auto longer = [](const Point_3& p) { return Point_3(p.x(), p.y(), p.z() == 2 ? FT(3) : p.z()); };
    std::transform(m_images.begin(), m_images.end(), images.begin(), longer);
    refuses(images, VMP::ERROR_BOUNDARY_MAP);
    // a vertex inside of the floor moved over its neighbours: the planes keep, the facets fold
    images = m_images;
    for (Point_3& p : images)
      if (p.z() == 0 && p.x() == 0.5 && p.y() == 1) p = Point_3(0.5, 0.25, 0);
    refuses(images, VMP::ERROR_BOUNDARY_MAP);
  }

private:
  // The floor goes where the given images say.
  void test_floor(const Parameterizer& parameterizer) {
    const Mesh &solid = parameterizer.mesh(), &polycube = m_polycube.mesh();
    for (VMP::Facet_index f : floor_facets(solid)) {
      const auto w = m_random.weights<FT, 3>(1 + unsigned(m_random.below(7)));
      const VMP::Base_point_3<Kernel> q = parameterizer.floor_map()->image({f, w});
      FT x(0), y(0), u(0), v(0);
      for (int i = 0; i < 3; ++i) {
        const VMP::Vertex_index a = solid.vertices(f)[i], b = polycube.vertices(q.facet)[i];
        if (a >= m_images.size()) return; // of a split
        x += w[i] * m_images[a].x(), y += w[i] * m_images[a].y();
        u += q.barycentric[i] * polycube.point(b).x(), v += q.barycentric[i] * polycube.point(b).y();
      }
      assert(polycube.label(q.facet) == VMP::FLOOR);
      assert(CGAL::abs(x - u) < 1e-12 && CGAL::abs(y - v) < 1e-12);
    }
  }

  void test_round_trips(const Parameterizer& parameterizer, int points, double tolerance) {
    const Mesh& mesh = parameterizer.mesh();
    const VMP::Cell_locator_3<Kernel> locator(m_polycube.mesh());
    FT largest(0);
    int outside = 0; // rounded off the polycube
    for (int k = 0; k < points; ++k) {
      const VMP::Location_3<Kernel> p{VMP::Cell_index(m_random.below(mesh.number_of_cells())),
                                      m_random.weights<FT, 4>(1 + unsigned(m_random.below(15)))};
      VMP::Location_3<Kernel> back, at;
      Point_3 image(0, 0, 0);
      VMP::Status status = parameterizer.product_map()->image(p, image);
      if (status.ok()) status = locator.locate(image, at);
      if (status.ok()) status = parameterizer.product_map()->preimage(image, back);
      if (status.code() == VMP::ERROR_OUTSIDE) {
        ++outside;
        continue;
      }
      if (!status.ok()) std::cerr << status.message() << std::endl;
      assert(status.ok());
      largest = (std::max)(largest, FT(CGAL::squared_distance(p.point(mesh), back.point(mesh))));
    }
    std::cout << "round trips within " << std::sqrt(CGAL::to_double(largest)) << ", " << outside << " outside"
              << std::endl;
    assert(outside * 1000 <= points && (tolerance > 0 || outside == 0));
    assert(largest <= tolerance * tolerance);
  }

  std::vector<Point_3> m_images;
  Soup m_solid;
  Polycube m_polycube;
  Random m_random{5};
};

template <typename Kernel>
VMP::Compact_tetrahedral_mesh_3<Kernel> labelled_step(int per_unit) {
  VMP::Compact_tetrahedral_mesh_3<Kernel> mesh;
  const VMP::Status status = mesh.assign(step<Kernel>(per_unit));
  assert(status.ok());
  label_step(mesh);
  return mesh;
}

void test_holes(int holes) {
  using Point_3 = Inexact::Point_3;
  VMP::Compact_tetrahedral_mesh_3<Inexact> polycube;
  const VMP::Status status = polycube.assign(shaped_block<Point_3>(Shape::PLAIN, holes, 2, 2));
  assert(status.ok());
  Given_domain_test<Inexact>(polycube, shaped_block<Point_3>(Shape::PLAIN, holes, 3, 3)).run(2000, 1e-12);
}

// A block [0, 1] x [0, 3] x [0, 1], with floor and ceiling where the predicates want them, the rest a wall.
template <typename Is_floor, typename Is_ceiling>
VMP::Compact_tetrahedral_mesh_3<Inexact> labelled_block(int per_unit, const Is_floor& is_floor,
                                                        const Is_ceiling& is_ceiling) {
  VMP::Compact_tetrahedral_mesh_3<Inexact> mesh;
  const VMP::Status status = mesh.assign(shaped_block<Inexact::Point_3>(Shape::PLAIN, 0, per_unit, per_unit));
  assert(status.ok());
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    const auto p = CGAL::centroid(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
    if (mesh.label(f) == VMP::FLOOR && !is_floor(p)) mesh.set_label(f, VMP::FIRST_WALL);
    if (mesh.label(f) == VMP::CEILING && !is_ceiling(p)) mesh.set_label(f, VMP::FIRST_WALL);
  }
  return mesh;
}

using Inexact_polycube = VMP::Polycube_3<Inexact>;
using Inexact_map = VMP::Boundary_map_3<Inexact_polycube>;

// Two patches in one plane: the facets of the solid must keep to their border, which may be subdivided in other places.
void test_patches_in_one_plane() {
  const auto everywhere = [](const Inexact::Point_3&) { return true; };
  const auto to = [](double y) { return [y](const Inexact::Point_3& p) { return p.y() < y; }; };
  const auto lower_half = [](const Inexact::Point_3& p) { return p.x() > p.y(); };
  const auto code = [&](const auto& is_floor, const auto& is_ceiling) {
    Inexact_polycube polycube;
    VMP::Status status = polycube.build(labelled_block(2, is_floor, is_ceiling));
    assert(status.ok());
    VMP::Compact_tetrahedral_mesh_3<Inexact> mesh = labelled_block(3, everywhere, everywhere);
    status = Inexact_map(polycube, mesh.points()).label_boundary(mesh);
    std::cout << status.message() << std::endl;
    const VMP::Compact_tetrahedral_mesh_3<Inexact> expected = labelled_block(3, is_floor, is_ceiling);
    for (VMP::Facet_index f : mesh.boundary_facets())
      assert(!status.ok() || mesh.label(f) == expected.label(f));
    return status.code();
  };
  assert(code(to(2), to(1)) == VMP::OK);
  assert(code(to(1.5), everywhere) == VMP::ERROR_BOUNDARY_MAP);
  assert(code(everywhere, to(1.5)) == VMP::ERROR_BOUNDARY_MAP);
  assert(code(lower_half, everywhere) == VMP::OK);
}

// A border askew, along which barycentres of splits are rounded: its slope is 3, its coordinates have 51 bits or more.
void test_split_border() {
  const double unit = std::ldexp(double((1LL << 50) + 12345677), -50);
  const auto everywhere = [](const Inexact::Point_3&) { return true; };
  const auto lower_half = [](const Inexact::Point_3& p) { return p.x() > p.y(); };
  const auto block = [&](int per_unit) {
    VMP::Compact_tetrahedral_mesh_3<Inexact> mesh;
    const auto scaled = [&](const Inexact::Point_3& p) {
      return Inexact::Point_3(p.x() * unit, p.y() * 3 * unit, p.z());
    };
    const VMP::Status status =
        mesh.assign(transformed(VMP::make_soup(labelled_block(per_unit, lower_half, everywhere)), scaled));
    assert(status.ok());
    return mesh;
  };
  Inexact_polycube polycube;
  VMP::Compact_tetrahedral_mesh_3<Inexact> mesh = block(2);
  VMP::Status status = polycube.build(block(1));
  Inexact_map map(polycube, mesh.points());
  if (status.ok()) status = map.label_boundary(mesh);
  assert(status.ok());
  VMP::internal::Splittable_mesh<Inexact> splittable(mesh);
  const auto is_on_border = [&](VMP::Vertex_index v) {
    return CGAL::collinear(mesh.point(v), Inexact::Point_3(0, 0, 0), Inexact::Point_3(unit, 3 * unit, 0));
  };
  for (VMP::Facet_index f : floor_facets(mesh))
    for (int i = 0; i < 3; ++i) {
      const VMP::Vertex_index v = mesh.vertices(f)[i], w = mesh.vertices(f)[(i + 1) % 3];
      if (is_on_border(v) && is_on_border(w)) status = splittable.insert_barycentre({v, w});
      assert(status.ok());
    }
  status = std::move(splittable).write_to(mesh);
  const std::size_t n = mesh.number_of_vertices();
  assert(status.ok() && mesh.split_simplices().size() == 2);
  assert(!is_on_border(VMP::Vertex_index(n - 2)) || !is_on_border(VMP::Vertex_index(n - 1)));
  status = map.build(mesh);
  if (!status.ok()) std::cerr << status.message() << std::endl;
  assert(status.ok());
}

// The floor has a hole, whose rim is mapped to a slit on both sides: the images of its facets cover a square once.
void test_slit() {
  using Point_3 = Inexact::Point_3;
  Inexact_polycube polycube;
  VMP::Status status =
      polycube.build(transformed(shaped_block<Point_3>(Shape::PLAIN, 0, 1, 1),
                                 [](const Point_3& p) { return Point_3(3 * p.x(), p.y(), p.z()); }));
  assert(status.ok());
  VMP::Compact_tetrahedral_mesh_3<Inexact> mesh;
  status = mesh.assign(shaped_block<Point_3>(Shape::PLAIN, 1, 1, 1));
  assert(status.ok());
  std::vector<Point_3> images = mesh.points();
  for (Point_3& p : images)
    if ((p.x() == 1 && p.y() == 2) || (p.x() == 2 && p.y() == 1)) p = Point_3(1.5, 1.5, p.z());
  assert(Inexact_map(polycube, images).build(mesh).code() == VMP::ERROR_BOUNDARY_MAP);
  assert(Inexact_map(polycube, images).label_boundary(mesh).code() == VMP::ERROR_BOUNDARY_MAP);
}

// What has to be known beforehand: the polycube, and an image for each vertex of the boundary.
void test_missing() {
  VMP::Compact_tetrahedral_mesh_3<Inexact> mesh = labelled_step<Inexact>(2);
  Inexact_polycube polycube, not_built;
  VMP::Status status = polycube.build(mesh);
  assert(status.ok());
  assert(Inexact_map(not_built, mesh.points()).label_boundary(mesh).code() == VMP::ERROR_BOUNDARY_MAP);
  assert(Inexact_map(polycube, {}).build(mesh).code() == VMP::ERROR_BOUNDARY_MAP);
  // a refined solid: the vertices of splits go to the barycentres of images
  const std::vector<Inexact::Point_3> images = mesh.points();
  VMP::Preparation counts;
  status = prepare_patches(mesh, counts);
  assert(status.ok() && mesh.number_of_vertices() > images.size());
  assert(Inexact_map(polycube, images).label_boundary(mesh).ok() &&
         Inexact_map(polycube, images).build(mesh).ok());
}

void test_no_polycube() {
  using Point_3 = Inexact::Point_3;
  const auto code = [](const auto& soup) {
    VMP::Polycube_3<Inexact> polycube;
    const VMP::Status status = polycube.build(soup);
    std::cout << status.message() << std::endl;
    assert(!polycube.is_valid());
    return status.code();
  };
  assert(code(shaped_block<Point_3>(Shape::TWISTED, 0, 2, 2)) == VMP::ERROR_NOT_A_POLYCUBE);
  for (double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto soup = shaped_block<Point_3>(Shape::PLAIN, 0, 2, 2);
    soup.points[0] = Point_3(0, wrong, 0);
    assert(code(soup) == VMP::ERROR_COORDINATE_NOT_FINITE);
  }
  // a clamp with the gap [1, 1.5] between its jaws, which is closed, and then overlaps
  const auto block = Block_with_holes<Point_3>(0, 1, 6, 3).soup();
  const auto clamp = filtered(
      block, [](double, double y, double z) { return z < 1 || z > 2 || y < 1 || (y > 2 && z > 1.5); });
  for (double end : {1., 0.5}) {
    const auto closed = [&](const Point_3& p) {
      return p.y() >= 2 && p.z() == 1.5 ? Point_3(p.x(), p.y(), end) : p;
    };
    assert(code(transformed(clamp, closed)) == VMP::ERROR_NOT_A_POLYCUBE);
  }
}

int main() {
  Given_domain_test<Inexact> step_test(labelled_step<Inexact>(3), step<Inexact>(4));
  step_test.run(5000, 1e-11);
  step_test.test_refusals();
  for (int holes : {0, 1, 2}) test_holes(holes);
  Given_domain_test<Exact>(labelled_step<Exact>(2), step<Exact>(2)).run(50, 0);
  test_patches_in_one_plane();
  test_split_border();
  test_slit();
  test_missing();
  test_no_polycube();
  return EXIT_SUCCESS;
}
