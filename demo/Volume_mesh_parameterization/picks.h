#ifndef HANDLEBODY_PICKS_H
#define HANDLEBODY_PICKS_H

#include "types.h"

#include <CGAL/Volume_mesh_parameterization/Polygon_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

// A boundary triangle that is to have a label: its number in a surface file, or the one nearest to a point.
struct Pick {
  int label;
  std::optional<std::size_t> number;
  Point_3 point;
};

// Reads "17" or "1.5,0,2".
std::optional<Pick> parse_pick(int label, const std::string& text);
// Reads "1:17" or "1:1.5,0,2", for wall 1.
std::optional<Pick> parse_wall_pick(const std::string& text);

// Gives picked triangles their labels.
VMP::Status apply_picks(const std::vector<Pick>& picks, VMP::Triangle_soup_3<Point_3>& surface);
VMP::Status apply_picks(const std::vector<Pick>& picks, Mesh& mesh);

// The same in two steps, for polygons that will be those of the mesh: first those picked by number, then the others.
VMP::Status apply_numbered_picks(const std::vector<Pick>& picks, VMP::Polygon_soup_3<Point_3>& surface);
VMP::Status add_point_picks(const std::vector<Pick>& picks, Mesh& mesh);

#endif // HANDLEBODY_PICKS_H
