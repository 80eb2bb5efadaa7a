#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>

#include "io_test_util.h"
#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <list>
#include <random>
#include <sstream>

namespace VMP = CGAL::Volume_mesh_parameterization;

// What the concept TetrahedralMesh_3 asks for and nothing else.
template <typename Kernel>
class Mesh_archetype {
public:
  using Point_3 = typename Kernel::Point_3;

  struct Cell_vertices {
    const std::array<std::size_t, 4>* vertices;
    unsigned short operator[](int i) const { return static_cast<unsigned short>((*vertices)[i]); }
  };

  using Labelled_facets = std::list<VMP::Labelled_facet>;

  explicit Mesh_archetype(const VMP::Tetrahedron_soup_3<Point_3>& soup) : m_soup(soup) {}
  Mesh_archetype(const Mesh_archetype&) = delete;
  Mesh_archetype& operator=(const Mesh_archetype&) = delete;

  std::size_t number_of_vertices() const { return m_soup.points.size(); }
  std::size_t number_of_cells() const { return m_soup.cells.size(); }
  Point_3 point(std::size_t vertex) const { return m_soup.points[vertex]; }
  Cell_vertices cell(std::size_t c) const { return {&m_soup.cells[c]}; }
  Labelled_facets labelled_facets() const { return Labelled_facets(m_soup.facets.begin(), m_soup.facets.end()); }

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

  bool linear_solver(const Matrix& a, const Vector& b, Vector& x, NT& d) { return factor(a, d) && linear_solver(b, x); }

private:
  Matrix m_lu = Matrix(0);
};

template <typename Kernel>
VMP::Location_3<Kernel> random_location(const VMP::Compact_tetrahedral_mesh_3<Kernel>& mesh, std::mt19937& random) {
  using FT = typename Kernel::FT;
  std::array<int, 4> weights;
  int sum = 0;
  for (int& w : weights) sum += w = 1 + int(random() % 100);
  VMP::Location_3<Kernel> location;
  location.cell = VMP::Cell_index(random() % mesh.number_of_cells());
  for (int i = 0; i < 4; ++i) location.barycentric[i] = FT(weights[i]) / FT(sum);
  return location;
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
    typename Parameterizer::Point_3 image;
    expect(map.image(start, image), VMP::OK);
    assert(parameterizer.floor_map()->domain().bounded_side(image) != CGAL::ON_UNBOUNDED_SIDE);
    expect(map.preimage(image, end), VMP::OK);
    const auto p = start.point(mesh), q = end.point(mesh);
    assert(is_exact ? p == q : CGAL::squared_distance(p, q) < 1e-16);
  }
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
  test_output();
  return EXIT_SUCCESS;
}
