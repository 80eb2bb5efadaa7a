// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PRISM_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PRISM_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

is the rectangle [`xmin`, `xmax`] × [`ymin`, `ymax`].
*/
struct Rectangle_2 {
  double xmin = 0; ///< lower bound in x
  double ymin = 0; ///< lower bound in y
  double xmax = 0; ///< upper bound in x
  double ymax = 0; ///< upper bound in y

  /// returns the extent in x.
  double width() const { return xmax - xmin; }
  /// returns the extent in y.
  double height() const { return ymax - ymin; }
  /// returns the area.
  double area() const { return width() * height(); }
  /// returns `xmin` or `ymin`, for axis 0 or 1.
  double& low(int axis) { return axis == 0 ? xmin : ymin; }
  /// returns the lower bound in x for axis 0, in y for axis 1.
  double low(int axis) const { return axis == 0 ? xmin : ymin; }
  /// returns `xmax` or `ymax`, for axis 0 or 1.
  double& high(int axis) { return axis == 0 ? xmax : ymax; }
  /// returns the upper bound in x for axis 0, in y for axis 1.
  double high(int axis) const { return axis == 0 ? xmax : ymax; }
  /// returns the corners counterclockwise, that of least coordinates first.
  std::array<std::array<double, 2>, 4> corners() const {
    return {{{xmin, ymin}, {xmax, ymin}, {xmax, ymax}, {xmin, ymax}}};
  }

  /// compares all bounds.
  bool operator==(const Rectangle_2& r) const { return corners() == r.corners(); }

  /// returns whether the rectangles share a point.
  bool meets(const Rectangle_2& r) const {
    return xmin <= r.xmax && r.xmin <= xmax && ymin <= r.ymax && r.ymin <= ymax;
  }

  /// returns on which side of the rectangle a point is; exact if the comparison of its coordinates with a `double` is.
  template <typename Point_2>
  Bounded_side bounded_side(const Point_2& p) const {
    if (p.x() < xmin || p.x() > xmax || p.y() < ymin || p.y() > ymax) return ON_UNBOUNDED_SIDE;
    const bool inside = p.x() > xmin && p.x() < xmax && p.y() > ymin && p.y() < ymax;
    return inside ? ON_BOUNDED_SIDE : ON_BOUNDARY;
  }
};

/*!
\ingroup PkgVolumeMeshParameterizationMap

is the simplest domain: a rectangle with disjoint rectangular holes, times the interval [0, height]. The planes of its
sides are any real numbers.

Each rim of the base, number 0 the outer one and number 1 + k that of hole k, carries the label of a wall.

\cgalModels{ParameterDomain_3}

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Prism_3 {
public:
  using Geom_traits = GeomTraits;               ///< a model of `VolumeParameterizationTraits_3`
  using FT = typename GeomTraits::FT;           ///< the number type
  using Point_2 = typename GeomTraits::Point_2; ///< the point type of the plane
  using Point_3 = typename GeomTraits::Point_3; ///< the point type
  using Floor_point = Point_2;                  ///< a point of the floor of the domain

  /// constructs an empty prism, which is not valid.
  Prism_3() : Prism_3(Rectangle_2(), {}, 0) {}

  /// constructs the prism with the walls labelled `FIRST_WALL`, `FIRST_WALL + 1`, … in the order of the rims.
  Prism_3(const Rectangle_2& outer, const std::vector<Rectangle_2>& holes, double height)
      : m_rims(1, outer), m_height(height) {
    m_rims.insert(m_rims.end(), holes.begin(), holes.end());
    for (std::size_t rim = 0; rim < m_rims.size(); ++rim) m_wall_labels.push_back(FIRST_WALL + int(rim));
  }

  /// returns whether all rectangles and the height are positive, and the holes are strictly inside and do not even touch.
  bool is_valid() const {
    if (!(m_height > 0) || !is_positive(outer())) return false;
    std::vector<Rectangle_2> holes(m_rims.begin() + 1, m_rims.end());
    if (!std::all_of(holes.begin(), holes.end(), [this](const Rectangle_2& hole) { return is_inside(hole); })) return false;
    std::sort(holes.begin(), holes.end(),
              [](const Rectangle_2& a, const Rectangle_2& b) { return a.xmin < b.xmin; });
    for (std::size_t i = 0; i < holes.size(); ++i)
      for (std::size_t j = i + 1; j < holes.size() && holes[j].xmin <= holes[i].xmax; ++j)
        if (holes[i].meets(holes[j])) return false;
    return true;
  }

  /// returns one more than the number of holes.
  std::size_t number_of_rims() const { return m_rims.size(); }
  /// returns the number of holes.
  std::size_t number_of_holes() const { return m_rims.size() - 1; }
  /// returns the outer rectangle for 0, that of hole k for k + 1.
  const Rectangle_2& rim(std::size_t r) const { return m_rims[r]; }
  /// returns the outer rectangle.
  const Rectangle_2& outer() const { return m_rims[0]; }
  /// returns the rectangle of hole `k`.
  const Rectangle_2& hole(std::size_t k) const { return m_rims[k + 1]; }
  /// returns the distance of floor and ceiling.
  double height() const { return m_height; }

  /// returns the area of the floor, that is without holes.
  double base_area() const {
    double area = outer().area();
    for (std::size_t k = 0; k < number_of_holes(); ++k) area -= hole(k).area();
    return area;
  }

  /// returns the label of the wall over a rim.
  int wall_label(std::size_t rim) const { return m_wall_labels[rim]; }
  /// labels the wall over a rim.
  void set_wall_label(std::size_t rim, int label) { m_wall_labels[rim] = label; }

  /// returns the rim that `p` lies on, or the number of rims.
  std::size_t rim_at(const Point_2& p) const {
    const auto at_p = [&p](const Rectangle_2& rim) { return rim.bounded_side(p) == ON_BOUNDARY; };
    return std::find_if(m_rims.begin(), m_rims.end(), at_p) - m_rims.begin();
  }

  /// computes the point over `foot` at the share `w` of the height.
  Status point(const Floor_point& foot, const FT& w, Point_3& result) const {
    result = Point_3(foot.x(), foot.y(), FT(m_height) * w);
    return {};
  }

  /// splits a point into its foot on the floor and its share of the height.
  /// \returns `ERROR_OUTSIDE` if `p` is above the ceiling or below the floor, whether its foot is in the base or not
  Status locate(const Point_3& p, Floor_point& foot, FT& w) const {
    if (p.z() < FT(0) || p.z() > FT(m_height))
      return {ERROR_OUTSIDE, "the third coordinate is not in the height of the prism"};
    foot = Point_2(p.x(), p.y());
    w = p.z() / FT(m_height);
    return {};
  }

  /// returns on which side of the base `p` is.
  Bounded_side bounded_side(const Point_2& p) const {
    if (rim_at(p) != number_of_rims()) return ON_BOUNDARY;
    const auto contains_p = [&p](const Rectangle_2& rim) { return rim.bounded_side(p) == ON_BOUNDED_SIDE; };
    return std::count_if(m_rims.begin(), m_rims.end(), contains_p) == 1 ? ON_BOUNDED_SIDE : ON_UNBOUNDED_SIDE;
  }

  /// returns on which side of the prism `p` is.
  Bounded_side bounded_side(const Point_3& p) const {
    const Bounded_side base = bounded_side(Point_2(p.x(), p.y()));
    if (base == ON_UNBOUNDED_SIDE || p.z() < 0 || p.z() > m_height) return ON_UNBOUNDED_SIDE;
    return base == ON_BOUNDARY || p.z() == 0 || p.z() == m_height ? ON_BOUNDARY : ON_BOUNDED_SIDE;
  }

  /// returns the label of the side that `p` lies on: floor and ceiling before walls, `INTERIOR` if it is on none.
  int label(const Point_3& p) const {
    if (bounded_side(p) != ON_BOUNDARY) return INTERIOR;
    if (p.z() == 0) return FLOOR;
    if (p.z() == m_height) return CEILING;
    return wall_label(rim_at(Point_2(p.x(), p.y())));
  }

private:
  static bool is_positive(const Rectangle_2& r) { return r.width() > 0 && r.height() > 0; }

  bool is_inside(const Rectangle_2& hole) const {
    return is_positive(hole) && hole.xmin > outer().xmin && hole.xmax < outer().xmax && hole.ymin > outer().ymin &&
           hole.ymax < outer().ymax;
  }

  std::vector<Rectangle_2> m_rims;
  std::vector<int> m_wall_labels;
  double m_height;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PRISM_3_H
