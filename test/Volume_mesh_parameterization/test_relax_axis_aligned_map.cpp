#undef NDEBUG
#include <CGAL/Volume_mesh_parameterization/internal/relax_axis_aligned_map.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using namespace VMP::internal;
using Point_3 = Axis_aligned_map::Point_3;

// The surface of a box, each face cut into n x n squares of two triangles; vertices of different faces are shared.
struct Box_surface {
  Box_surface(int n, double x, double y, double z) : m_n(n) {
    const double size[3] = {x, y, z};
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        for (int k = 0; k <= n; ++k) points.emplace_back(i * x / n, j * y / n, k * z / n);
    map.images = points;
    map.vertex_planes.assign(points.size(), {map.no_plane, map.no_plane, map.no_plane});
    for (int axis = 0; axis < 3; ++axis)
      for (int side : {0, 1}) add_face(axis, side, map.add_plane(axis, side * size[axis], side == 0));
  }

  void add_face(int axis, int side, int plane) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int i = 0; i < m_n; ++i)
      for (int j = 0; j < m_n; ++j) {
        const auto corner = [&](int di, int dj) {
          int site[3];
          site[axis] = side * m_n;
          site[a] = i + di;
          site[b] = j + dj;
          return std::uint32_t((site[0] * (m_n + 1) + site[1]) * (m_n + 1) + site[2]);
        };
        add_triangle({corner(0, 0), corner(1, 0), corner(1, 1)}, axis, side, plane);
        add_triangle({corner(0, 0), corner(1, 1), corner(0, 1)}, axis, side, plane);
      }
  }

  void add_triangle(Axis_aligned_map::Triangle t, int axis, int side, int plane) {
    if (side == 0) std::swap(t[1], t[2]);
    triangles.push_back(t);
    map.frames.push_back(Plane_frame::orthogonal_to(axis, side == 0 ? -1 : 1));
    for (std::uint32_t v : t) map.put_on_plane(v, plane);
  }

  std::vector<Axis_aligned_map::Triangle> triangles;
  std::vector<Point_3> points;
  Axis_aligned_map map;

private:
  int m_n;
};

// From a box of other sizes, disturbed inside of its faces, back to an isometry: energy 4, planes where they were.
void test_isometry() {
  Box_surface box(4, 3, 2, 1);
  std::mt19937 random(1);
  const double stretch[3] = {.5, 2, 1.5};
  for (auto& plane : box.map.planes) plane.value *= stretch[plane.axis];
  for (std::size_t v = 0; v < box.points.size(); ++v) {
    double x[3];
    for (int k = 0; k < 3; ++k)
      x[k] = stretch[k] * (box.points[v][k] + (k == 0 ? .1 : .05) * (2. * random() / random.max() - 1));
    box.map.images[v] = Point_3(x[0], x[1], x[2]);
  }
  box.map.snap_to_planes();
  assert(box.map.count_flipped(box.triangles) == 0);
  const double energy = relax_axis_aligned_map(TO_MINIMUM, box.triangles, box.points, box.map);
  assert(std::abs(energy - 4) < 1e-9);
  assert(box.map.count_flipped(box.triangles) == 0);
  const double size[3] = {3, 2, 1};
  for (const auto& plane : box.map.planes)
    assert(plane.value == 0 || std::abs(plane.value - size[plane.axis]) < 1e-6);
}

// Fixed planes stay, exactly; vertices stay on planes.
void test_fixed() {
  Box_surface box(3, 1, 1, 1);
  for (auto& plane : box.map.planes) {
    plane.value *= 1 + plane.axis;
    plane.is_fixed = true;
  }
  for (Point_3& p : box.map.images) p = Point_3(p.x(), 2 * p.y(), 3 * p.z());
  box.map.snap_to_planes();
  const auto before = box.map;
  relax_axis_aligned_map(TO_MINIMUM, box.triangles, box.points, box.map);
  for (std::size_t p = 0; p < before.planes.size(); ++p)
    assert(box.map.planes[p].value == before.planes[p].value);
  for (const auto& t : box.triangles)
    for (std::uint32_t v : t)
      for (int axis = 0; axis < 3; ++axis)
        if (box.map.vertex_planes[v][axis] != box.map.no_plane)
          assert(box.map.images[v][axis] == box.map.planes[box.map.vertex_planes[v][axis]].value);
}

// A map that is flipped somewhere is left alone.
void test_flipped() {
  Box_surface box(3, 1, 1, 1);
  for (Point_3& p : box.map.images) p = Point_3(-p.x(), p.y(), p.z());
  const auto images = box.map.images;
  const double energy = relax_axis_aligned_map(ROUGHLY, box.triangles, box.points, box.map);
  assert(std::isinf(energy) && box.map.images == images);
}

int main() {
  test_isometry();
  test_fixed();
  test_flipped();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
