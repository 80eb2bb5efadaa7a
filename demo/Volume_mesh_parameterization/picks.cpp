#include "picks.h"

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>

#include <CGAL/squared_distance_3.h>

#include <cmath>
#include <limits>
#include <sstream>

using VMP::Status;

namespace {

// The whole text must be a number.
template <typename Number>
std::optional<Number> parse(const std::string& text) {
  std::istringstream in(text);
  Number number;
  char rest;
  if (text.empty() || text[0] == ' ' || !(in >> number) || in >> rest) return {};
  return number;
}

std::optional<std::size_t> parse_number(const std::string& text) {
  if (text.find_first_not_of("0123456789") != std::string::npos) return {};
  return parse<std::size_t>(text);
}

std::optional<Point_3> parse_point(const std::string& text) {
  std::istringstream in(text);
  double x[3];
  for (double& coordinate : x) {
    std::string part;
    std::getline(in, part, ',');
    const auto value = parse<double>(part);
    if (!value || !std::isfinite(*value)) return {};
    coordinate = *value;
  }
  return in.eof() ? std::make_optional<Point_3>(x[0], x[1], x[2]) : std::nullopt;
}

// Among n triangles that may be picked, `triangle(i)` being one of them.
template <typename Triangle>
std::size_t nearest(const Point_3& point, std::size_t n, const Triangle& triangle) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    const double distance = CGAL::squared_distance(point, triangle(i));
    if (!(distance < least)) continue;
    least = distance;
    best = i;
  }
  return best;
}

Status give(int label, std::size_t triangle, int& old_label) {
  if (old_label != VMP::INTERIOR && old_label != label)
    return {VMP::ERROR_WRONG_PARAMETER, "triangle " + std::to_string(triangle) + " is picked as " +
                                            VMP::patch_name(old_label) + " and as " + VMP::patch_name(label)};
  old_label = label;
  return {};
}

} // namespace

std::optional<Pick> parse_pick(int label, const std::string& text) {
  if (const auto number = parse_number(text)) return Pick{label, number, CGAL::ORIGIN};
  if (const auto point = parse_point(text)) return Pick{label, {}, *point};
  return {};
}

std::optional<Pick> parse_wall_pick(const std::string& text) {
  constexpr std::size_t most_walls = 1000000;
  const std::size_t colon = text.find(':');
  const auto wall = parse_number(text.substr(0, colon));
  if (colon == std::string::npos || !wall || *wall > most_walls) return {};
  return parse_pick(VMP::FIRST_WALL + int(*wall), text.substr(colon + 1));
}

Status apply_picks(const std::vector<Pick>& picks, VMP::Triangle_soup_3<Point_3>& surface) {
  surface.labels.assign(surface.triangles.size(), VMP::INTERIOR);
  const auto triangle = [&](std::size_t i) {
    const auto& t = surface.triangles[i];
    return Kernel::Triangle_3(surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
  };
  Status status;
  for (std::size_t k = 0; k < picks.size() && status.ok(); ++k) {
    const std::size_t t = picks[k].number ? *picks[k].number : nearest(picks[k].point, surface.triangles.size(), triangle);
    if (t >= surface.triangles.size())
      return {VMP::ERROR_INDEX_OUT_OF_RANGE, "triangle " + std::to_string(t) + " of " + std::to_string(surface.triangles.size())};
    status = give(picks[k].label, t, surface.labels[t]);
  }
  return status;
}

Status apply_picks(const std::vector<Pick>& picks, Mesh& mesh) {
  for (const Pick& pick : picks)
    if (pick.number)
      return {VMP::ERROR_WRONG_PARAMETER, "facets of such a file are picked by points X,Y,Z, not by numbers"};
  for (VMP::Facet_index f : mesh.boundary_facets()) mesh.set_label(f, VMP::INTERIOR);
  return add_point_picks(picks, mesh);
}

Status apply_numbered_picks(const std::vector<Pick>& picks, VMP::Polygon_soup_3<Point_3>& surface) {
  surface.labels.assign(surface.polygons.size(), VMP::INTERIOR);
  Status status;
  for (std::size_t k = 0; k < picks.size() && status.ok(); ++k) {
    if (!picks[k].number) continue;
    const std::size_t f = *picks[k].number;
    if (f >= surface.polygons.size())
      return {VMP::ERROR_INDEX_OUT_OF_RANGE, "facet " + std::to_string(f) + " of " + std::to_string(surface.polygons.size())};
    status = give(picks[k].label, f, surface.labels[f]);
  }
  return status;
}

Status add_point_picks(const std::vector<Pick>& picks, Mesh& mesh) {
  const auto triangle = [&](std::size_t f) {
    const auto v = mesh.vertices(VMP::Facet_index(f));
    return Kernel::Triangle_3(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]));
  };
  Status status;
  for (std::size_t k = 0; k < picks.size() && status.ok(); ++k) {
    if (picks[k].number) continue;
    const VMP::Facet_index f(nearest(picks[k].point, mesh.number_of_boundary_facets(), triangle));
    int label = mesh.label(f);
    status = give(picks[k].label, f, label);
    mesh.set_label(f, label);
  }
  return status;
}
