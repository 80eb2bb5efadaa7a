#ifndef HANDLEBODY_COMMANDS_H
#define HANDLEBODY_COMMANDS_H

#include "picks.h"
#include "threads.h"

#include <CGAL/Volume_mesh_parameterization/Floor_map_options.h>
#include <CGAL/Volume_mesh_parameterization/Partition_search_3.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

constexpr const char* handlebody_version = "0.1.0";

enum Exit_code {
  EVERYTHING_CERTIFIED = 0,
  INPUT_REFUSED = 1,
  WRONG_USAGE = 2,
  NOT_CERTIFIED = 3 // what holds is written, the report says what does not
};

enum class Field { CERTIFIED, FLUX, PAPER };

struct Input_options {
  std::string file;
  std::string partition; // "auto", "labels" or empty: labels if the file has them and there is no direction
  std::optional<std::array<double, 3>> direction;
  std::size_t number_of_tetrahedra = 30000; // about, for a surface
  bool keeps_triangles = false;             // of a surface, even if they are thin
};

// One of the first three says how many are wanted.
struct Hexahedra_options {
  std::size_t number = 0;                          // about
  double edge = 0;                                 // about, in the unit of the input
  std::optional<std::array<std::size_t, 3>> cells; // along the axes of the prism
  double grading = 1;                              // height of a layer relative to the one below
  bool has_pillow = false;                         // a layer of hexahedra along the boundary
  std::vector<std::string> formats = {"medit"};    // of files

  bool is_wanted() const { return number > 0 || edge > 0 || cells; }
};

struct Parameterize_options {
  Input_options input;
  std::string folder;
  std::string domain;       // the file of a given polycube; if empty, it is that onto which the boundary map maps
  std::vector<Pick> picks;  // of its floor and ceiling
  std::string boundary_map; // the file with the images of the vertices of the input in its boundary, or empty
  CGAL::Volume_mesh_parameterization::Floor_map_options prism; // what is asked of the prism that is found
  Field field = Field::CERTIFIED;
  std::string solver = "cg";
  Hexahedra_options hexahedra;
  std::size_t threads = Thread_limit::default_number();
  bool quiet = false;
};

struct Partition_command {
  Input_options input;
  std::string output;
  std::vector<Pick> picks;
  CGAL::Volume_mesh_parameterization::Given_labels given_labels = CGAL::Volume_mesh_parameterization::IGNORE_LABELS;
  std::size_t number_of_candidates = 4;
  std::size_t chosen = 0;
  bool quiet = false;
};

struct Remesh_command {
  std::string folder; // of a result
  std::string output; // the folder for the hexahedra
  Hexahedra_options hexahedra;
  std::size_t threads = Thread_limit::default_number();
  bool quiet = false;
};

// Says on stderr why a command failed that was given `input`, and returns `exit_code`.
int say(const std::string& input, const CGAL::Volume_mesh_parameterization::Status& status, int exit_code);

int check(const Input_options& options, bool quiet);
int partition(const Partition_command& options);
int parameterize(const Parameterize_options& options);
int remesh(const Remesh_command& options);
int verify(const std::string& folder, bool quiet);

#endif // HANDLEBODY_COMMANDS_H
