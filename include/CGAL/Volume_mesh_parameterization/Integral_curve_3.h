// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTEGRAL_CURVE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTEGRAL_CURVE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Curve_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Base_point_3.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationStructure

is a point of a tetrahedral mesh: a cell that contains it and its barycentric coordinates there. A coordinate that is
exactly zero says that the point lies on the opposite facet; tracing keeps such zeros.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
struct Location_3 {
  using FT = typename GeomTraits::FT; ///< the number type

  Cell_index cell; ///< a cell
  /// coordinates in the cell, one for each vertex, which are not negative and whose sum is 1
  std::array<FT, 4> barycentric;

  /// returns the point in space. A coordinate that all vertices of non-zero weight share is kept exactly: so points of a
  /// plane orthogonal to an axis stay there.
  typename GeomTraits::Point_3 point(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh) const {
    const FT sum = barycentric[0] + barycentric[1] + barycentric[2] + barycentric[3];
    const int heaviest = int(std::max_element(barycentric.begin(), barycentric.end()) - barycentric.begin());
    const auto& origin = mesh.point(mesh.vertex(cell, heaviest));
    FT x(0), y(0), z(0);
    for (int i = 0; i < 4; ++i) {
      const auto& p = mesh.point(mesh.vertex(cell, i));
      x += barycentric[i] * (p.x() - origin.x());
      y += barycentric[i] * (p.y() - origin.y());
      z += barycentric[i] * (p.z() - origin.z());
    }
    return {origin.x() + x / sum, origin.y() + y / sum, origin.z() + z / sum};
  }

  /// returns the value at the point of the function that is linear on each cell and has `values` at the vertices.
  template <typename Value>
  FT value(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh, const std::vector<Value>& values) const {
    FT weighted(0), sum(0);
    for (int i = 0; i < 4; ++i) {
      weighted += barycentric[i] * FT(values[mesh.vertex(cell, i)]);
      sum += barycentric[i];
    }
    return weighted / sum;
  }
};

/*!
\ingroup PkgVolumeMeshParameterizationStructure

is an integral curve from the floor to the ceiling, as the segments that it has in the cells.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Integral_curve_3 {
public:
  using FT = typename GeomTraits::FT;      ///< the number type
  using Location = Location_3<GeomTraits>; ///< a point of the solid

  /// is a straight piece in one cell.
  struct Segment {
    Location begin; ///< where it enters the cell
    Location end;   ///< where it leaves it
    FT level;       ///< what the level function has gained at the end since the floor
  };

  /// returns what it passes, cell by cell.
  const std::vector<Segment>& segments() const { return m_segments; }

  /// returns what the level function gains from the floor to the ceiling.
  FT total_level() const { return m_segments.empty() ? FT(0) : m_segments.back().level; }

  /// returns the location at which `level` is gained, \f$ 0 \le \f$ `level` \f$ \le \f$ `total_level()`, in
  /// \f$ O(\log k) \f$ for \f$ k \f$ segments. Coordinates that are zero along a segment are exactly zero.
  /// \pre the curve has a segment
  Location at(const FT& level) const {
    const auto found = std::lower_bound(m_segments.begin(), m_segments.end(), level,
                                        [](const Segment& s, const FT& l) { return s.level < l; });
    if (found == m_segments.end()) return m_segments.back().end;
    const FT start = found == m_segments.begin() ? FT(0) : std::prev(found)->level;
    if (found->level == start) return found->end;
    const FT t = (level - start) / (found->level - start);
    Location result = found->begin;
    for (int i = 0; i < 4; ++i)
      result.barycentric[i] += t * (found->end.barycentric[i] - found->begin.barycentric[i]);
    return result;
  }

  /// appends a segment along which the level changes by `gain`.
  void append(const Location& begin, const Location& end, const FT& gain) {
    m_segments.push_back({begin, end, total_level() + gain});
  }

private:
  std::vector<Segment> m_segments;
};

/// \ingroup PkgVolumeMeshParameterizationStructure
/// tells towards which base a curve is followed.
enum Curve_direction {
  DOWN = 1, ///< towards the floor
  UP = -1   ///< towards the ceiling
};

/*!
\ingroup PkgVolumeMeshParameterizationStructure

traces the integral curves of a `Curve_field_3`: straight segments from facet to facet, in barycentric coordinates.

The facet through which a curve leaves a cell is chosen among those that the signs of the field allow, by the least
quotient of coordinate and rate; that coordinate is then set to zero. A point on several facets passes through the
cells around it in moves of length zero until it comes to the one that moves it. In a certified field every move goes
to a cell swept earlier (later, upwards), so a curve always arrives and passes no cell twice. The time that it takes is in
proportion to the number of cells that it passes.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`; exact number types give exact curves
*/
template <typename GeomTraits>
class Integral_curves_3 {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>; ///< the type of the solid
  using Field = Curve_field_3<GeomTraits>;             ///< the direction of the curve in each cell
  using Location = Location_3<GeomTraits>;             ///< a point of the solid
  using Base_point = Base_point_3<GeomTraits>;         ///< a point of the floor of the solid
  using FT = typename GeomTraits::FT;                  ///< the number type

  /// keeps references to both arguments.
  Integral_curves_3(const Mesh& mesh, const Field& field) : m_mesh(&mesh), m_field(&field) {}

  /// returns the solid.
  const Mesh& mesh() const { return *m_mesh; }
  /// returns the directions.
  const Field& field() const { return *m_field; }

  /// \name Locations
  /// @{

  /// returns the location of a point on floor or ceiling.
  Location locate(Base_point p) const {
    const Half_facet h = m_mesh->half_facet(p.facet);
    Location at{h.cell, {FT(0), FT(0), FT(0), FT(0)}};
    for (int i = 0; i < 3; ++i) at.barycentric[Mesh::facet_vertices[h.index][i]] = p.barycentric[i];
    return at;
  }

  /// returns the point of floor or ceiling at a location.
  /// \pre `at` lies on facet `h` of its cell, a facet of floor or ceiling
  Base_point base_point(const Location& at, Half_facet h) const {
    const int* v = Mesh::facet_vertices[h.index];
    const FT sum = at.barycentric[v[0]] + at.barycentric[v[1]] + at.barycentric[v[2]];
    return {m_mesh->facet(h.cell, h.index),
            {at.barycentric[v[0]] / sum, at.barycentric[v[1]] / sum, at.barycentric[v[2]] / sum}};
  }
  /// @}
  /// \name Tracing
  /// @{

  /*!
  moves `at` along its curve until it reaches the base in that direction or `duration` is used up, whichever comes first.

  \param[in,out] at the location; on arrival its cell has the facet `arrival`
  \param direction towards which base
  \param duration what the level function may gain or lose on the way, negative for no limit
  \param[out] arrival the facet of the base, its cell invalid if the duration was used up before
  \param[out] elapsed the level gained or lost
  \param on_segment a functor called as `on_segment(begin, end, time)` for each segment, two locations in one cell
  \returns `ERROR_CURVE_LOST`, for uncertified fields only, with the cell where the curve ends or turns round
  */
  template <typename OnSegment>
  Status trace(Location& at, Curve_direction direction, const FT& duration, Half_facet& arrival, FT& elapsed,
               OnSegment on_segment) const {
    Location here = at;
    FT time(0);
    arrival = Half_facet();
    const Status status = follow(here, direction, duration, arrival, time, on_segment);
    at = here;
    elapsed = time;
    return status;
  }

  /// moves `at` as the function above, without reporting segments.
  Status trace(Location& at, Curve_direction direction, const FT& duration, Half_facet& arrival, FT& elapsed) const {
    return trace(at, direction, duration, arrival, elapsed, [](const Location&, const Location&, const FT&) {});
  }

  /// traces to the base: the floor for `DOWN`, the ceiling for `UP`.
  Status trace_to_base(Location at, Curve_direction direction, Base_point& end, FT& elapsed) const {
    Half_facet arrival;
    const Status status = trace(at, direction, FT(-1), arrival, elapsed);
    if (status.ok()) end = base_point(at, arrival);
    return status;
  }

  /// appends to `curve` the segments of the curve that starts at `start`, up to the ceiling.
  Status trace_curve(const Base_point& start, Integral_curve_3<GeomTraits>& curve) const {
    Location at = locate(start);
    Half_facet arrival;
    FT elapsed;
    return trace(at, UP, FT(-1), arrival, elapsed,
                 [&](const Location& begin, const Location& end, const FT& gain) { curve.append(begin, end, gain); });
  }
  /// @}

private:
  using Cell = internal::Curve_cell<FT>;

  // For `trace()`, which passes variables of its own that nothing else refers to: they stay in registers.
  template <typename OnSegment>
  Status follow(Location& at, Curve_direction direction, const FT& duration, Half_facet& arrival, FT& elapsed,
                OnSegment& on_segment) const {
    for (std::size_t steps = 0; steps <= m_mesh->number_of_cells(); ++steps) {
      const Cell& cell = m_field->cell(at.cell);
      const auto fetch = [&](Cell_index c) { internal::prefetch(&m_field->cell(c)); };
      const auto [exit, time] = cell.exit_of(at.barycentric, direction, fetch);
      if (exit < 0) return lost(at, "has no facet to leave by");
      const bool stops = duration >= FT(0) && duration - elapsed < time;
      const FT step = stops ? FT(duration - elapsed) : time;
      Location end{at.cell, cell.moved(at.barycentric, FT(int(direction)) * step)};
      if (!stops) end.barycentric[exit] = FT(0);
      elapsed += step;
      on_segment(at, end, step);
      if (!stops && cell.neighbors[exit].is_valid()) {
        at.cell = cell.neighbors[exit];
        cell.enter_neighbor(exit, end.barycentric, at.barycentric);
        continue;
      }
      at = end;
      return stops ? Status() : arrive(at, exit, direction, arrival);
    }
    return lost(at, "is passed twice");
  }

  Status arrive(const Location& at, int facet, Curve_direction direction, Half_facet& arrival) const {
    if (m_mesh->label(at.cell, facet) != (direction == DOWN ? FLOOR : CEILING)) return lost(at, "leaves the solid");
    arrival = {at.cell, facet};
    return {};
  }

  static Status lost(const Location& at, const char* why) {
    return {ERROR_CURVE_LOST, "tetrahedron " + std::to_string(at.cell) + " " + why};
  }

  const Mesh* m_mesh;
  const Field* m_field;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTEGRAL_CURVE_3_H
