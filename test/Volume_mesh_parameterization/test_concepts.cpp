#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_map_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_map_3.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>

#include "io_test_util.h"
#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <list>
#include <memory>
#include <random>
#include <sstream>
#include <type_traits>
#include <utility>

namespace VMP = CGAL::Volume_mesh_parameterization;

// What the concept VolumeParameterizationTraits_3 asks for and nothing else: types of one kernel, predicates of another.
struct Traits_archetype {
private:
  using Objects = CGAL::Simple_cartesian<double>;
  using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;

  static Predicates::Point_2 convert(const Objects::Point_2& p) { return {p.x(), p.y()}; }
  static Predicates::Point_3 convert(const Objects::Point_3& p) { return {p.x(), p.y(), p.z()}; }
  static Predicates::Segment_2 convert(const Objects::Segment_2& s) { return {convert(s[0]), convert(s[1])}; }
  static Predicates::Segment_3 convert(const Objects::Segment_3& s) { return {convert(s[0]), convert(s[1])}; }
  static Predicates::Triangle_3 convert(const Objects::Triangle_3& t) {
    return {convert(t[0]), convert(t[1]), convert(t[2])};
  }

public:
  using FT = Objects::FT;
  using Point_2 = Objects::Point_2;
  using Segment_2 = Objects::Segment_2;
  using Point_3 = Objects::Point_3;
  using Segment_3 = Objects::Segment_3;
  using Triangle_3 = Objects::Triangle_3;

  struct Orientation_2 {
    CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const {
      return Predicates::Orientation_2()(convert(p), convert(q), convert(r));
    }
  };
  struct Orientation_3 {
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) const {
      return Predicates::Orientation_3()(convert(p), convert(q), convert(r), convert(s));
    }
  };
  struct Compare_slope_2 {
    CGAL::Comparison_result operator()(const Segment_2& s, const Segment_2& t) const {
      return Predicates::Compare_slope_2()(convert(s), convert(t));
    }
  };
  struct Do_intersect_3 {
    bool operator()(const Triangle_3& s, const Triangle_3& t) const {
      return Predicates::Do_intersect_3()(convert(s), convert(t));
    }
    bool operator()(const Triangle_3& s, const Segment_3& t) const {
      return Predicates::Do_intersect_3()(convert(s), convert(t));
    }
  };
  struct Coplanar_orientation_3 {
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) const {
      return Predicates::Coplanar_orientation_3()(convert(p), convert(q), convert(r), convert(s));
    }
  };
};

// What the concept TetrahedralMesh_3 asks for and nothing else.
template <typename Kernel>
class Mesh_archetype {
public:
  using Point_3 = typename Kernel::Point_3;

  struct Corners {
    const std::array<std::size_t, 4>* vertices;
    unsigned short operator[](int i) const { return static_cast<unsigned short>((*vertices)[i]); }
  };

  explicit Mesh_archetype(const VMP::Tetrahedron_soup_3<Point_3>& soup) : m_soup(soup) {}
  Mesh_archetype(const Mesh_archetype&) = delete;
  Mesh_archetype& operator=(const Mesh_archetype&) = delete;

  std::size_t number_of_vertices() const { return m_soup.points.size(); }
  std::size_t number_of_cells() const { return m_soup.cells.size(); }
  Point_3 point(std::size_t vertex) const { return m_soup.points[vertex]; }
  Corners cell(std::size_t c) const { return {&m_soup.cells[c]}; }
  std::list<VMP::Labelled_facet> labelled_facets() const { return {m_soup.facets.begin(), m_soup.facets.end()}; }

private:
  VMP::Tetrahedron_soup_3<Point_3> m_soup;
};

// A model of SparseLinearAlgebraWithFactorTraits_d: Gauss's elimination in a full matrix.
class Dense_solver_traits {
public:
  using NT = double;

  class Vector {
  public:
    explicit Vector(int n) : m_values(std::size_t(n)) {}
    int dimension() const { return int(m_values.size()); }
    double operator[](int i) const { return m_values[std::size_t(i)]; }
    double& operator[](int i) { return m_values[std::size_t(i)]; }

  private:
    std::vector<double> m_values;
  };

  class Matrix {
  public:
    explicit Matrix(int n) : m_n(n), m_coefficients(std::size_t(n) * std::size_t(n), 0) {}
    int row_dimension() const { return m_n; }
    int column_dimension() const { return m_n; }
    double get_coef(int i, int j) const { return m_coefficients[std::size_t(i * m_n + j)]; }
    void set_coef(int i, int j, double a, bool = false) { m_coefficients[std::size_t(i * m_n + j)] = a; }
    void add_coef(int i, int j, double a) { m_coefficients[std::size_t(i * m_n + j)] += a; }

  private:
    int m_n;
    std::vector<double> m_coefficients;
  };

  // The matrices of the fields are positive definite: no pivoting.
  bool factor(const Matrix& a, NT& d) {
    d = 2; // any denominator must do
    m_lu = a;
    for (int k = 0; k < a.row_dimension(); ++k)
      for (int i = k + 1; i < a.row_dimension(); ++i) {
        const double ratio = m_lu.get_coef(i, k) / m_lu.get_coef(k, k);
        m_lu.set_coef(i, k, ratio);
        if (ratio == 0) continue;
        for (int j = k + 1; j < a.row_dimension(); ++j) m_lu.add_coef(i, j, -ratio * m_lu.get_coef(k, j));
      }
    return true;
  }

  bool linear_solver(const Vector& b, Vector& x) {
    const int n = m_lu.row_dimension();
    for (int i = 0; i < n; ++i) {
      x[i] = 2 * b[i];
      for (int j = 0; j < i; ++j) x[i] -= m_lu.get_coef(i, j) * x[j];
    }
    for (int i = n - 1; i >= 0; --i) {
      for (int j = i + 1; j < n; ++j) x[i] -= m_lu.get_coef(i, j) * x[j];
      x[i] /= m_lu.get_coef(i, i);
    }
    return true;
  }

  bool linear_solver(const Matrix& a, const Vector& b, Vector& x, NT& d) {
    return factor(a, d) && linear_solver(b, x);
  }

private:
  Matrix m_lu = Matrix(0);
};

// What the concept ParameterDomain_3 asks for and nothing else.
template <typename Kernel>
class Domain_archetype {
  using Prism = VMP::Prism_3<Kernel>;

public:
  using Geom_traits = Kernel;
  using FT = typename Kernel::FT;
  using Point_3 = typename Kernel::Point_3;

  class Floor_point {
    typename Prism::Floor_point point;
    template <typename>
    friend class Domain_archetype;
    template <typename>
    friend class Floor_map_archetype;
  };

  explicit Domain_archetype(const Prism& prism) : m_prism(prism) {}
  Domain_archetype(const Domain_archetype&) = delete;
  Domain_archetype& operator=(const Domain_archetype&) = delete;

  bool is_valid() const { return m_prism.is_valid(); }
  VMP::Status point(const Floor_point& foot, const FT& w, Point_3& result) const {
    return m_prism.point(foot.point, w, result);
  }
  VMP::Status locate(const Point_3& p, Floor_point& foot, FT& w) const {
    return m_prism.locate(p, foot.point, w);
  }

private:
  const Prism& m_prism;
};

// What the concept VolumeFloorMap_3 asks for and nothing else.
template <typename Kernel>
class Floor_map_archetype {
  using Map = VMP::Floor_map_2<Kernel>;

public:
  using Geom_traits = Kernel;
  using Domain = Domain_archetype<Kernel>;

  explicit Floor_map_archetype(int)
      : m_map(std::make_unique<Map>()), m_domain(std::make_unique<Domain>(m_map->domain())) {}

  VMP::Status build(const VMP::Compact_tetrahedral_mesh_3<Kernel>& mesh) { return m_map->build(mesh); }
  const Domain& domain() const { return *m_domain; }
  typename Domain::Floor_point image(const VMP::Base_point_3<Kernel>& p) const {
    typename Domain::Floor_point result;
    result.point = m_map->image(p);
    return result;
  }
  VMP::Status preimage(const typename Domain::Floor_point& foot, VMP::Base_point_3<Kernel>& p) const {
    return m_map->preimage(foot.point, p);
  }
  VMP::Status map_boundary(const VMP::Compact_tetrahedral_mesh_3<Kernel>& mesh,
                           const std::vector<typename Kernel::Point_3>& images,
                           VMP::Boundary_images_3<Kernel>& boundary) {
    return m_map->map_boundary(mesh, images, boundary);
  }

private:
  std::unique_ptr<Map> m_map; // movable, not copyable
  std::unique_ptr<Domain> m_domain;
};

// The models have what the concepts ask for.
template <typename Domain>
void check_domain() {
  using Floor_point = typename Domain::Floor_point;
  using Point_3 = typename Domain::Geom_traits::Point_3;
  using FT = typename Domain::Geom_traits::FT;
  static_assert(std::is_same<Point_3, typename Domain::Point_3>::value &&
                std::is_same<FT, typename Domain::FT>::value);
  static_assert(std::is_default_constructible<Floor_point>::value &&
                std::is_copy_assignable<Floor_point>::value);
  static_assert(std::is_same<bool (Domain::*)() const, decltype(&Domain::is_valid)>::value);
  static_assert(std::is_same<VMP::Status (Domain::*)(const Floor_point&, const FT&, Point_3&) const,
                             decltype(&Domain::point)>::value);
  static_assert(std::is_same<VMP::Status (Domain::*)(const Point_3&, Floor_point&, FT&) const,
                             decltype(&Domain::locate)>::value);
}

template <typename Floor_map>
void check_floor_map() {
  using Domain = typename Floor_map::Domain;
  using Kernel = typename Floor_map::Geom_traits;
  using Floor_point = typename Domain::Floor_point;
  using Base_point = VMP::Base_point_3<Kernel>;
  check_domain<Domain>();
  static_assert(std::is_same<Kernel, typename Domain::Geom_traits>::value &&
                std::is_move_constructible<Floor_map>::value);
  using Map = const Floor_map&;
  static_assert(std::is_same<const Domain&, decltype(std::declval<Map>().domain())>::value);
  static_assert(
      std::is_same<VMP::Status, decltype(std::declval<Floor_map&>().build(
                                    std::declval<const VMP::Compact_tetrahedral_mesh_3<Kernel>&>()))>::value);
  static_assert(std::is_convertible<decltype(std::declval<Map>().image(std::declval<const Base_point&>())),
                                    Floor_point>::value);
  static_assert(
      std::is_same<VMP::Status, decltype(std::declval<Map>().preimage(std::declval<const Floor_point&>(),
                                                                      std::declval<Base_point&>()))>::value);
  static_assert(std::is_same<VMP::Status, decltype(std::declval<Floor_map&>().map_boundary(
                                              std::declval<const VMP::Compact_tetrahedral_mesh_3<Kernel>&>(),
                                              std::declval<const std::vector<typename Kernel::Point_3>&>(),
                                              std::declval<VMP::Boundary_images_3<Kernel>&>()))>::value);
}

template <typename Kernel>
VMP::Location_3<Kernel> random_location(const VMP::Compact_tetrahedral_mesh_3<Kernel>& mesh,
                                        std::mt19937& random) {
  using FT = typename Kernel::FT;
  std::array<int, 4> weights;
  int sum = 0;
  for (int& w : weights) sum += w = 1 + int(random() % 100);
  VMP::Location_3<Kernel> location;
  location.cell = VMP::Cell_index(random() % mesh.number_of_cells());
  for (int i = 0; i < 4; ++i) location.barycentric[i] = FT(weights[i]) / FT(sum);
  return location;
}

template <typename Kernel>
void expect_inside(const VMP::Prism_3<Kernel>& domain, const typename Kernel::Point_3& p) {
  assert(domain.bounded_side(p) != CGAL::ON_UNBOUNDED_SIDE);
}
template <typename Kernel>
void expect_inside(const Domain_archetype<Kernel>& domain, const typename Kernel::Point_3&) {
  assert(domain.is_valid());
}

// The inverse of the map returns to the start: to the point itself with an exact number type, else almost.
template <typename Parameterizer>
void test_round_trip(const Parameterizer& parameterizer, bool is_exact) {
  const auto& mesh = parameterizer.mesh();
  const auto& map = *parameterizer.product_map();
  std::mt19937 random(1);
  for (int k = 0; k < 100; ++k) {
    const auto start = random_location(mesh, random);
    auto end = start;
    typename Parameterizer::Point_3 image(0, 0, 0);
    expect(map.image(start, image), VMP::OK);
    expect_inside(parameterizer.floor_map()->domain(), image);
    expect(map.preimage(image, end), VMP::OK);
    const auto p = start.point(mesh), q = end.point(mesh);
    assert(is_exact ? p == q : CGAL::squared_distance(p, q) < 1e-16);
  }
}

template <typename Kernel>
void test_floor_map() {
  using Floor_map = Floor_map_archetype<Kernel>;
  check_floor_map<Floor_map>();
  check_floor_map<VMP::Floor_map_2<Kernel>>();
  check_floor_map<VMP::Boundary_map_3<VMP::Polycube_3<Kernel>>>();
  const Mesh_archetype<Kernel> mesh(Block_with_holes<typename Kernel::Point_3>(1, 1, 1).soup());
  VMP::Direct_product_parameterizer_3<Kernel, Dense_solver_traits, Floor_map> parameterizer(Floor_map(0));
  expect(VMP::parameterize(mesh, parameterizer), VMP::OK);
  test_round_trip(parameterizer, false);
  VMP::Piecewise_linear_map_3<Kernel> map;
  expect(VMP::make_piecewise_linear(parameterizer, map), VMP::OK);
  assert(VMP::verify_map(map.mesh(), map.images()).is_polycube_map());
}

template <typename Kernel>
void test(bool is_exact) {
  const auto soup = Block_with_holes<typename Kernel::Point_3>(1, 1, 1).soup();
  const Mesh_archetype<Kernel> mesh(soup);
  VMP::Direct_product_parameterizer_3<Kernel, Dense_solver_traits> parameterizer;
  expect(VMP::parameterize(mesh, parameterizer), VMP::OK);
  assert(parameterizer.product_structure() && parameterizer.partition().genus == 1);
  test_round_trip(parameterizer, is_exact);
  std::cout << parameterizer.mesh().number_of_cells() << " cells: the way back ends where the way there began"
            << (is_exact ? ", exactly" : "") << std::endl;
}

// Onto a polycube that is given: a block, which is the image of a sheared one.
void test_polycube() {
  using Polycube = VMP::Polycube_3<Traits_archetype>;
  using Boundary_map = VMP::Boundary_map_3<Polycube>;
  using Point_3 = Traits_archetype::Point_3;
  const auto soup = Block_with_holes<Point_3>(1, 1, 1).soup();
  Polycube polycube;
  expect(polycube.build(Mesh_archetype<Traits_archetype>(soup)), VMP::OK);
  VMP::Compact_tetrahedral_mesh_3<Traits_archetype> solid;
  expect(solid.assign(transformed(soup, [](const Point_3& p) { return Point_3(p.x() + p.y(), 2 * p.y(), p.z()); })), VMP::OK);
  const Boundary_map boundary_map(polycube, soup.points);
  expect(boundary_map.label_boundary(solid), VMP::OK);
  VMP::Direct_product_parameterizer_3<Traits_archetype, Dense_solver_traits, Boundary_map> parameterizer(boundary_map);
  expect(VMP::parameterize(solid, parameterizer), VMP::OK);
  for (const VMP::Labelled_facet& f : soup.facets)
    for (std::size_t v : f.vertices) {
      const Point_3& image = parameterizer.vertex_images()[v];
      if (f.label == VMP::FLOOR) assert(image == soup.points[v]);
      if (f.label == VMP::CEILING) assert(image.z() == 1);
    }
  VMP::Piecewise_linear_map_3<Traits_archetype> map;
  expect(VMP::make_piecewise_linear(parameterizer, map), VMP::OK);
}

// A block so flat that most of its cells are flat once their points are rounded, of which plain doubles are not aware.
VMP::Tetrahedron_soup_3<Traits_archetype::Point_3> flattened_block() {
  using Point_3 = Traits_archetype::Point_3;
  return transformed(Block_with_holes<Point_3>(1, 2, 2).soup(), [&](const Point_3& p) {
    return Point_3(p.x() / 7 + .1, p.y() / 7 + .3, (p.x() + 2 * p.y()) / 3 + 1e-16 * p.z());
  });
}

// All signs come from the traits: those of the kernel of the points would be others.
void test_signs() {
  const auto soup = flattened_block();
  VMP::Compact_tetrahedral_mesh_3<Traits_archetype> mesh;
  expect(mesh.assign(soup), VMP::OK);
  std::size_t flat = 0, wrong = 0;
  for (const auto& v : soup.cells) {
    const auto &p = soup.points[v[0]], &q = soup.points[v[1]], &r = soup.points[v[2]], &s = soup.points[v[3]];
    const CGAL::Orientation sign = Traits_archetype::Orientation_3()(p, q, r, s);
    flat += sign == CGAL::ZERO;
    wrong += sign != CGAL::orientation(p, q, r, s);
  }
  assert(wrong > 0);
  assert(VMP::verify_map(mesh, mesh.points()).flat == flat);
}

// A file does not tell from which model it was written.
void test_output() {
  using Kernel = CGAL::Simple_cartesian<double>;
  const auto soup = Block_with_holes<Kernel::Point_3>(1, 1, 1).soup();
  const Mesh_archetype<Kernel> mesh(soup);
  std::ostringstream from_archetype, from_soup;
  expect(VMP::IO::write_MEDIT(from_archetype, mesh), VMP::OK);
  expect(VMP::IO::write_MEDIT(from_soup, soup), VMP::OK);
  expect(VMP::IO::write_VTU(from_archetype, mesh), VMP::OK);
  expect(VMP::IO::write_VTU(from_soup, soup), VMP::OK);
  assert(from_archetype.str() == from_soup.str());
}

int main() {
  test<CGAL::Simple_cartesian<double>>(false);
  test<CGAL::Exact_predicates_exact_constructions_kernel>(true);
  test<Traits_archetype>(false);
  test_floor_map<CGAL::Simple_cartesian<double>>();
  test_floor_map<Traits_archetype>();
  test_polycube();
  test_signs();
  test_output();
  return EXIT_SUCCESS;
}
