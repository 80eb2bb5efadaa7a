#ifndef HANDLEBODY_LOAD_INPUT_H
#define HANDLEBODY_LOAD_INPUT_H

#include "Stage_clock.h"
#include "commands.h"
#include "types.h"

#include <CGAL/Volume_mesh_parameterization/Partition_sequence_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>

#include <optional>
#include <string>
#include <vector>

using Partitions = VMP::Partition_sequence_3<Kernel>;

// What the report says about an input.
struct Input {
  bool is_surface = false;
  std::size_t number_of_triangles = 0; // of a surface whose thin triangles were cut, else 0
  bool has_labels = false;             // given in the file
};

// In lower case, with the dot.
std::string file_extension(const std::string& file);
bool is_surface_file(const std::string& file);
VMP::Status read_surface(const std::string& file, VMP::Triangle_soup_3<Point_3>& surface);
// Unless the options say no, or it cannot be done; tells whether it was.
bool cut_thin_triangles(const Input_options& options, VMP::Triangle_soup_3<Point_3>& surface);
VMP::Status read_tetrahedra(const std::string& file, Mesh& mesh);

// Reads and checks the file, whose solids are labelled by that in the file, or by one partition after the other.
VMP::Status load_input(const Input_options& options, Stage_clock& clock, Input& input,
                       std::optional<Partitions>& partitions);

// Reads and checks the file, and tetrahedralizes a surface; there are no labels, or those that tell triangles apart. The
// points of the file come first, as far as they are used.
VMP::Status load_unlabelled(const Input_options& options, Stage_clock& clock, Mesh& mesh, std::size_t& number_of_points);

// Reads the points of a mesh or surface.
VMP::Status read_points(const std::string& file, std::vector<Point_3>& points);

// What the options say about an automatic partition.
VMP::Partition_options partition_options(const Input_options& options);

#endif // HANDLEBODY_LOAD_INPUT_H
