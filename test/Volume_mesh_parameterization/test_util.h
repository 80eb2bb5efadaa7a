#ifndef VOLUME_MESH_PARAMETERIZATION_TEST_UTIL_H
#define VOLUME_MESH_PARAMETERIZATION_TEST_UTIL_H

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <vector>

// The rectangle of squares [xmin, xmax) x [ymin, ymax) of a grid.
struct Grid_box {
  int xmin, ymin, xmax, ymax;

  bool contains(int x, int y) const { return x >= xmin && x < xmax && y >= ymin && y < ymax; }
  bool is_near(const Grid_box& b) const { // they meet or touch
    return xmin <= b.xmax && b.xmin <= xmax && ymin <= b.ymax && b.ymin <= ymax;
  }
};

// n square holes [2k + 1, 2k + 2] x [1, 2] in a row.
inline std::vector<Grid_box> row_of_holes(int n) {
  std::vector<Grid_box> holes;
  for (int k = 0; k < n; ++k) holes.push_back({2 * k + 1, 1, 2 * k + 2, 2});
  return holes;
}

// A block [0, width] x [0, depth] x [0, height] with n disjoint rectangular holes, cut into cubes of edge 1 / m and each
// cube into the six Kuhn tetrahedra. Bottom and top are labelled floor and ceiling, the outer side is wall 0, hole k is
// wall k + 1.
template <typename Point>
class Block_with_holes {
public:
  // [0, 2n + 1] x [0, 3] with n square holes in a row
  Block_with_holes(int holes, int m, int layers, double height = 1)
      : Block_with_holes({0, 0, 2 * holes + 1, 3}, row_of_holes(holes), m, layers, height) {}

  Block_with_holes(const Grid_box& base, const std::vector<Grid_box>& holes, int m, int layers, double height = 1)
      : m_base(base), m_holes(holes), m_per_unit(m), m_layers(layers), m_height(height) {
    for (int x = 0; x < width(); ++x)
      for (int y = 0; y < depth(); ++y)
        if (!in_hole(x, y)) {
          for (int z = 0; z < layers; ++z) add_cube({x, y, z});
          add_bases(x, y);
        }
    add_walls();
  }

  const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point>& soup() const { return m_soup; }

private:
  using Site = std::array<int, 3>;

  int width() const { return m_base.xmax * m_per_unit; }
  int depth() const { return m_base.ymax * m_per_unit; }

  int hole(int x, int y) const {
    const auto contains = [&](const Grid_box& h) { return x >= 0 && y >= 0 && h.contains(x / m_per_unit, y / m_per_unit); };
    const auto found = std::find_if(m_holes.begin(), m_holes.end(), contains);
    return found == m_holes.end() ? -1 : int(found - m_holes.begin());
  }
  bool in_hole(int x, int y) const { return hole(x, y) >= 0; }
  bool is_solid(int x, int y) const { return x >= 0 && x < width() && y >= 0 && y < depth() && !in_hole(x, y); }

  std::size_t vertex(const Site& s) {
    const auto inserted = m_vertices.emplace(s, m_soup.points.size());
    if (inserted.second)
      m_soup.points.push_back(Point(double(s[0]) / m_per_unit, double(s[1]) / m_per_unit, m_height * s[2] / m_layers));
    return inserted.first->second;
  }

  void add_cube(const Site& corner) {
    std::array<int, 3> axes = {0, 1, 2};
    do {
      std::array<std::size_t, 4> cell;
      Site s = corner;
      cell[0] = vertex(s);
      for (int i = 0; i < 3; ++i) {
        ++s[axes[i]];
        cell[i + 1] = vertex(s);
      }
      const bool even = (axes[1] - axes[0] + 3) % 3 == 1;
      if (!even) std::swap(cell[0], cell[1]);
      m_soup.cells.push_back(cell);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  // The two triangles of the square spanned by axes a and b at s, cut along the diagonal that Kuhn cubes have.
  void add_square(const Site& s, int a, int b, int label) {
    Site sa = s, sb = s, sab = s;
    ++sa[a], ++sb[b], ++sab[a], ++sab[b];
    m_soup.facets.push_back({{vertex(s), vertex(sa), vertex(sab)}, label});
    m_soup.facets.push_back({{vertex(s), vertex(sab), vertex(sb)}, label});
  }

  void add_bases(int x, int y) {
    add_square({x, y, 0}, 0, 1, 1);
    add_square({x, y, m_layers}, 0, 1, 2);
  }

  void add_walls() {
    for (int x = 0; x <= width(); ++x)
      for (int y = 0; y <= depth(); ++y)
        for (int z = 0; z < m_layers; ++z) {
          if (is_solid(x - 1, y) != is_solid(x, y)) add_square({x, y, z}, 1, 2, wall_label(x - 1, y, x, y));
          if (is_solid(x, y - 1) != is_solid(x, y)) add_square({x, y, z}, 0, 2, wall_label(x, y - 1, x, y));
        }
  }
  int wall_label(int x0, int y0, int x1, int y1) const { return 4 + std::max(hole(x0, y0), hole(x1, y1)); }

  Grid_box m_base;
  std::vector<Grid_box> m_holes;
  int m_per_unit, m_layers;
  double m_height;
  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point> m_soup;
  std::map<Site, std::size_t> m_vertices;
};

// Applies `map` to all points.
template <typename Soup, typename Map>
Soup transformed(Soup soup, const Map& map) {
  for (auto& p : soup.points) p = map(p);
  return soup;
}

// Moves the vertices off the boundary by up to `amplitude` in each coordinate. All boundary triangles are labelled.
template <typename Point>
CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point>
jitter_interior(CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point> soup, double amplitude, unsigned seed) {
  std::vector<char> on_boundary(soup.points.size(), 0);
  for (const auto& f : soup.facets)
    for (std::size_t v : f.vertices) on_boundary[v] = 1;
  std::mt19937 random(seed);
  const auto offset = [&] { return amplitude * (2. * random() / random.max() - 1); };
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const double x = offset(), y = offset(), z = offset();
    const Point& p = soup.points[v];
    if (!on_boundary[v]) soup.points[v] = Point(p.x() + x, p.y() + y, p.z() + z);
  }
  return soup;
}

#endif // VOLUME_MESH_PARAMETERIZATION_TEST_UTIL_H
