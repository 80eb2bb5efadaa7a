#include "Partition_source.h"

#include <CGAL/Volume_mesh_parameterization/tetrahedralize.h>

#include <algorithm>
#include <cmath>

using VMP::Status;

Status Partition_source::first(Input& input) {
  input.is_surface = is_surface_file(m_options.file);
  const Status status = input.is_surface ? open_surface(input) : open_tetrahedra(input);
  if (!status.ok() || !input.has_labels) return status.ok() ? next(input) : status;
  input.mesh = m_solid;
  return {};
}

Status Partition_source::next(Input& input) {
  constexpr int most_searches = 2;
  while (!input.has_labels) {
    if (!m_search || m_next == m_search->candidates().size()) {
      if (m_searches == most_searches) break;
      const Status status = search();
      if (!status.ok()) return status;
    }
    const std::size_t candidate = m_next++;
    if (is_like_one_tried(m_search->candidates()[candidate])) continue;
    const Status status = label(candidate, input);
    if (status.code() == VMP::ERROR_CANNOT_SPLIT) continue;
    m_tried.push_back(m_search->candidates()[candidate]);
    input.chosen = m_tried.back();
    return status;
  }
  return {VMP::ERROR_NO_PARTITION, "there is no further one"};
}

// A surface is filled as coarsely as it allows, to try partitions on; and at once as wanted if the mesher cuts its triangles.
Status Partition_source::open_surface(Input& input) {
  if (m_options.partition == "labels") return {VMP::ERROR_UNLABELLED_FACET, "a surface file has no labels"};
  m_clock.start("read and check the surface");
  Status status = read_surface(m_options.file, m_surface);
  if (!status.ok()) return status;
  if (cut_thin_triangles(m_options, m_surface)) input.number_of_triangles = m_surface.triangles.size();
  m_clock.start("tetrahedralize, to try partitions");
  m_surface.labels.resize(m_surface.triangles.size(), VMP::INTERIOR);
  status = VMP::tetrahedralize(m_surface, m_solid);
  if (!status.ok() || m_solid.number_of_boundary_facets() == m_surface.triangles.size()) return status;
  status = VMP::tetrahedralize(m_surface, m_solid, m_options.number_of_tetrahedra);
  m_surface = {};
  return status;
}

Status Partition_source::open_tetrahedra(Input& input) {
  m_clock.start("read and check the tetrahedra");
  const Status status = read_tetrahedra(m_options.file, m_solid);
  if (!status.ok()) return status;
  const auto labels = m_solid.labelled_facets();
  const bool is_auto = m_options.partition == "auto" || (m_options.partition.empty() && m_options.direction);
  input.has_labels =
      m_options.partition == "labels" ||
      (!is_auto && std::any_of(labels.begin(), labels.end(), [](const auto& f) { return f.label != VMP::INTERIOR; }));
  return {};
}

// First for plates and the like. Then rims beside loops, with walls so broad that tubes stay tubes.
Status Partition_source::search() {
  constexpr double broad = .8;
  constexpr std::size_t few = 2;
  m_clock.start("partition");
  VMP::Partition_options options = partition_options(m_options);
  if (m_searches++ > 0) {
    options.only_by_loops = true;
    options.wall_width = broad;
    options.number_of_candidates = few;
  }
  m_next = 0;
  m_search.emplace(m_solid, options);
  return m_search->run(Clock_visitor(m_clock));
}

Status Partition_source::label(std::size_t candidate, Input& input) const {
  m_clock.start("tetrahedralize");
  if (m_surface.triangles.empty()) {
    input.mesh = m_solid;
    return m_search->label(candidate, input.mesh);
  }
  VMP::Triangle_soup_3<Point_3> surface = m_surface;
  m_search->label(candidate, surface);
  return VMP::tetrahedralize(surface, input.mesh, m_options.number_of_tetrahedra);
}

// One made in the same way, along nearly the same line.
bool Partition_source::is_like_one_tried(const VMP::Partition_candidate_3& candidate) const {
  constexpr double cosine_of_same = .866; // 30 degrees
  const auto& d = candidate.direction;
  return std::any_of(m_tried.begin(), m_tried.end(), [&](const VMP::Partition_candidate_3& other) {
    const auto& e = other.direction;
    return other.method == candidate.method &&
           std::abs(d * e) > cosine_of_same * std::sqrt(d.squared_length() * e.squared_length());
  });
}
