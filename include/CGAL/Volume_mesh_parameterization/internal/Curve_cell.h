// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CURVE_CELL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CURVE_CELL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/indices.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The size of a cache line of most processors.
constexpr std::size_t cache_line = 64;

// Begins to bring an object into the cache, where the compiler knows how to.
inline void prefetch(const void* object) {
#ifdef __GNUC__
  __builtin_prefetch(object);
#else
  static_cast<void>(object);
#endif
}

// Some of the four facets of a cell.
class Facet_list {
public:
  int size() const { return m_size; }
  int operator[](int k) const { return m_facets >> 2 * k & 3; }
  void push_back(int facet) { m_facets = std::uint8_t(m_facets | facet << 2 * m_size++); }

private:
  std::uint8_t m_size = 0, m_facets = 0; // two bits for each facet
};

// All that a curve needs to know of a cell to cross it and to go on in the next one. Tracing waits for memory more than
// for anything else; with plain numbers this is one line of the cache.
template <typename FT>
struct alignas(cache_line) Curve_cell {
  std::array<FT, 4> rates;
  std::array<Cell_index, 4> neighbors; // behind each facet, invalid on the boundary
  // Behind each facet, the slot that each vertex has in the neighbor, two bits for each. The vertex opposite to the facet
  // has the slot of the neighbor's vertex opposite to it: both coordinates are zero on the facet.
  std::array<std::uint8_t, 4> slots = {0, 0, 0, 0};
  std::array<std::int8_t, 4> signs = {0, 0, 0, 0};
  Facet_list entries, exits; // those with positive and with negative sign
  bool follows_harmonic_level = false;

  void set_signs(const std::array<std::int8_t, 4>& s) {
    signs = s;
    for (int i = 0; i < 4; ++i) {
      if (s[i] > 0) entries.push_back(i);
      if (s[i] < 0) exits.push_back(i);
    }
  }

  template <typename Mesh>
  void set_neighbors(const Mesh& mesh, Cell_index c) {
    for (int i = 0; i < 4; ++i) {
      const Half_facet behind = mesh.opposite({c, i});
      neighbors[i] = behind.cell;
      if (!behind.cell.is_valid()) continue;
      unsigned all = 0;
      for (int j = 0; j < 4; ++j)
        all |= unsigned(j == i ? behind.index : mesh.index(behind.cell, mesh.vertex(c, j))) << 2 * j;
      slots[i] = std::uint8_t(all);
    }
  }

  // The slot in the neighbor behind facet `exit` of what is in slot j here.
  int slot_behind(int exit, int j) const { return slots[exit] >> 2 * j & 3; }

  // The facet through which the curve at these barycentric coordinates leaves and when; -1 if there is none. `direction`
  // is 1 against the rates, towards the floor, and -1 along them. The cells to which it may go are fetched meanwhile.
  template <typename Fetch>
  std::pair<int, FT> exit_of(const std::array<FT, 4>& at, int direction, const Fetch& fetch) const {
    const Facet_list& facets = direction > 0 ? entries : exits;
    int exit = -1;
    FT least(0);
    for (int k = 0; k < facets.size(); ++k) {
      const int i = facets[k];
      if (neighbors[i].is_valid()) fetch(neighbors[i]);
      const FT time = FT(direction) * at[i] / rates[i];
      const bool is_first = k == 0 || time < least;
      exit = is_first ? i : exit;
      least = is_first ? time : least;
    }
    return {exit, least};
  }

  // Against the rates for that long. Coordinates stay non-negative, and zeros on walls stay.
  std::array<FT, 4> moved(const std::array<FT, 4>& at, const FT& time) const {
    const auto coordinate = [&](int i) {
      const FT result = at[i] - time * rates[i];
      return result < FT(0) ? FT(0) : result;
    };
    return {coordinate(0), coordinate(1), coordinate(2), coordinate(3)};
  }

  // The coordinates `at` on facet `exit`, seen from the neighbor.
  void enter_neighbor(int exit, const std::array<FT, 4>& at, std::array<FT, 4>& result) const {
    for (int j = 0; j < 4; ++j) result[slot_behind(exit, j)] = at[j];
  }
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CURVE_CELL_H
