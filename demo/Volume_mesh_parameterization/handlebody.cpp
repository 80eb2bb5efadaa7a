// The program handlebody: a thin shell over the package Volume_mesh_parameterization.

#include "Chosen_solver_traits.h"
#include "commands.h"
#include "load_input.h"

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <utility>

namespace {

constexpr double most_cells = 1e7; // more is a slip of the keyboard

void add_quiet(CLI::App& command, bool& quiet) { command.add_flag("-q,--quiet", quiet, "say nothing but errors"); }

void add_input(CLI::App& command, Input_options& options) {
  command.add_option("INPUT", options.file, "a closed triangle surface (.off .obj .ply .stl) or tetrahedra (.mesh .vtk .vtu)")
      ->required();
  command.add_option("--tets", options.number_of_tetrahedra, "about how many tetrahedra for a surface input")
      ->check(CLI::Range(1., most_cells).description("up to 1e7"))
      ->capture_default_str();
}

void add_keep_triangles(CLI::App& command, Input_options& options) {
  command.add_flag("--keep-triangles", options.keeps_triangles, "do not cut a surface of long and thin triangles into better ones");
}

// Options whose values are picks; `parse` says which.
template <typename Parse>
CLI::Option* add_picks(CLI::App& command, const char* name, const char* type, const char* description, std::vector<Pick>& picks, Parse parse) {
  const auto add = [&picks, parse](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      const auto pick = parse(text);
      if (!pick) return false;
      picks.push_back(*pick);
    }
    return true;
  };
  return command.add_option(name, add, description)->type_name(type)->allow_extra_args(false)->take_all();
}

void add_partition(CLI::App& command, Partition_command& options) {
  add_input(command, options.input);
  add_keep_triangles(command, options.input);
  command.add_option("-o,--output", options.output, "the file for the labelled tetrahedra (.mesh)")
      ->check([](const std::string& file) {
        return std::filesystem::path(file).extension() == ".mesh" ? std::string() : file + " does not end in .mesh";
      }, "")
      ->required();
  command.add_option("--direction", options.input.direction, "from the floor to the ceiling, as X,Y,Z")->delimiter(',');
  add_picks(command, "--floor", "PICK", "a triangle that is to be floor: its number in a surface file, from 0, or X,Y,Z for the nearest", options.picks,
            [](const std::string& text) { return parse_pick(VMP::FLOOR, text); });
  add_picks(command, "--ceiling", "PICK", "a triangle that is to be ceiling", options.picks,
            [](const std::string& text) { return parse_pick(VMP::CEILING, text); });
  add_picks(command, "--wall", "K:PICK", "a triangle that is to be in wall K", options.picks, parse_wall_pick);
  const std::map<std::string, VMP::Given_labels> uses = {
      {"ignore", VMP::IGNORE_LABELS}, {"keep", VMP::KEEP_LABELS}, {"mend", VMP::MEND_LABELS}};
  command.add_option("--labels", options.given_labels, "what labels in INPUT are for: nothing (default), facets to keep them, or a partition to mend")
      ->transform(CLI::Transformer(uses).description(""))
      ->transform(CLI::IsMember(uses)) // the last one comes first, and complains better
      ->excludes("--floor", "--ceiling", "--wall");
  command.add_option("--candidates", options.number_of_candidates, "how many partitions to compare")
      ->check(CLI::Range(1, 100).description("1 to 100"))
      ->capture_default_str();
  command.add_option("--choose", options.chosen, "which one to write; 0 is the best")
      ->check(CLI::Range(0, 99).description("from 0"))
      ->capture_default_str();
  add_quiet(command, options.quiet);
  command.callback([&options] {
    if (options.given_labels != VMP::IGNORE_LABELS && is_surface_file(options.input.file))
      throw CLI::ValidationError("--labels", options.input.file + " is a surface file, which has no labels");
  });
}

void add_hexahedra(CLI::App& command, Hexahedra_options& options) {
  constexpr double greatest_grading = 10;
  command.add_option("--hexes", options.number, "also a hexahedral mesh of about so many cells; 0: none")
      ->check(CLI::Range(0., most_cells).description("up to 1e7"))
      ->capture_default_str();
  command.add_option("--hex-edge", options.edge, "also a hexahedral mesh with edges of about this length")
      ->type_name("LENGTH")
      ->check(CLI::PositiveNumber)
      ->excludes("--hexes");
  command.add_option("--hex-cells", options.cells, "also a hexahedral mesh of about so many cells along the width, depth and height of the prism")
      ->type_name("X,Y,Z")
      ->delimiter(',')
      ->check(CLI::Range(1., most_cells).description("from 1"))
      ->excludes("--hexes", "--hex-edge");
  command.add_option("--hex-grading", options.grading, "how many times as high as the layer below each layer of hexahedra is")
      ->check(CLI::Range(1 / greatest_grading, greatest_grading))
      ->capture_default_str();
  command.add_option("--hex-format", options.formats, "of the files for the hexahedra, separated by commas: medit for hex.mesh, gmsh for hex.msh, abaqus for hex.inp, vtu for hex.vtu")
      ->type_name("FORMAT,...")
      ->delimiter(',')
      ->check(CLI::IsMember({"medit", "gmsh", "abaqus", "vtu"}).description("of {medit,gmsh,abaqus,vtu}"))
      ->capture_default_str();
  command.add_flag("--pillow", options.has_pillow, "with hexahedra: a layer of them along the boundary, for good corners where it is smooth");
}

// Unless they are all that is asked for, hexahedra may be left out, but then there is nothing to say about them.
void check_hexahedra(const CLI::App& command, const Hexahedra_options& options, bool is_required) {
  if (is_required && !options.is_wanted()) throw CLI::RequiredError("--hexes, --hex-edge or --hex-cells");
  for (const char* option : {"--hex-grading", "--hex-format", "--pillow"})
    if (command.count(option) > 0 && !options.is_wanted()) throw CLI::RequiresError(option, "--hexes");
}

void add_threads(CLI::App& command, std::size_t& threads) {
  command.add_option("--threads", threads, "how many threads at most; the result does not depend on it")
      ->check(CLI::Range(std::size_t(1), Thread_limit::most).description("up to 1024"))
      ->check(CLI::Validator([](std::string& number) { return Thread_limit::refusal(number); }, ""))
      ->capture_default_str();
}

void add_parameterize(CLI::App& command, Parameterize_options& options) {
  add_input(command, options.input);
  add_keep_triangles(command, options.input);
  command.add_option("-o,--output", options.folder, "the folder for the result")->required();
  CLI::Option* partition = command.add_option("--partition", options.input.partition, "where floor, ceiling and walls come from; default: labels if INPUT has them and there is no --direction, else auto")
      ->check(CLI::IsMember({"auto", "labels"}));
  command.add_option("--direction", options.input.direction, "from the floor to the ceiling, as X,Y,Z; with --boundary-map: those of POLYCUBE")
      ->delimiter(',');
  const std::map<std::string, Field> fields = {
      {"certified", Field::CERTIFIED}, {"flux", Field::FLUX}, {"paper", Field::PAPER}};
  command.add_option("--field", options.field, "the curves: certified (default), of the flux itself, or also the paper's averaged gradient for comparison")
      ->transform(CLI::Transformer(fields).description(""))
      ->transform(CLI::IsMember(fields));
  add_hexahedra(command, options.hexahedra);
  CLI::Option* boundary_map = command.add_option("--boundary-map", options.boundary_map, "onto a polycube instead of a prism that fits: a file like INPUT whose points are the images of the vertices of INPUT; those on the boundary count")
      ->type_name("FILE")
      ->excludes(partition)
      ->excludes("--hexes", "--hex-edge", "--hex-cells");
  command.add_option("--domain", options.domain, "the polycube: a closed surface, tetrahedra, hexahedra (.mesh), or a list of integer cells (.txt .cells); default: what the boundary map maps onto")
      ->type_name("POLYCUBE")
      ->needs(boundary_map);
  for (const auto& [name, label] : {std::pair<const char*, int>("--floor", VMP::FLOOR), {"--ceiling", VMP::CEILING}}) {
    const std::string description = "a face of POLYCUBE that is to be " + VMP::patch_name(label) + ": the number of a facet in a surface file, from 0, or X,Y,Z for the nearest; default: labels in POLYCUBE, else its lowest and highest faces";
    add_picks(command, name, "PICK", description.c_str(), options.picks, [label = label](const std::string& text) { return parse_pick(label, text); })
        ->needs(boundary_map);
  }
  command.add_option("--domain-size", options.prism.size, "width, depth and height of the prism that fits, as X,Y,Z; 0: in proportion to the others")
      ->type_name("X,Y,Z")
      ->delimiter(',')
      ->excludes(boundary_map);
  command.add_flag("--integer-planes", options.prism.integer_planes, "all planes of the prism that fits are integers; without --domain-size, in a unit that fits")
      ->excludes(boundary_map);
  command.add_option("--solver", options.solver, "for the linear systems")
      ->check(CLI::IsMember(Chosen_solver_traits::names()))
      ->capture_default_str();
  add_threads(command, options.threads);
  add_quiet(command, options.quiet);
  command.callback([&command, &options] {
    check_hexahedra(command, options.hexahedra, false);
    if (options.input.partition == "labels" && options.input.direction)
      throw CLI::ExcludesError("--partition labels", "--direction");
  });
}

void add_remesh(CLI::App& command, Remesh_command& options) {
  command.add_option("DIR", options.folder, "the folder of a result with parameter.mesh")->required();
  command.add_option("-o,--output", options.output, "the folder for the hexahedra and their report")->required();
  add_hexahedra(command, options.hexahedra);
  add_threads(command, options.threads);
  add_quiet(command, options.quiet);
  command.callback([&command, &options] { check_hexahedra(command, options.hexahedra, true); });
}

int run(int argc, char** argv) {
  CLI::App app("Maps handlebodies one to one onto prisms, and meshes them by hexahedra.", "handlebody");
  app.set_version_flag("--version", handlebody_version);
  app.require_subcommand(1);
  bool quiet = false;

  CLI::App* check_command = app.add_subcommand("check", "Tells what a file holds: manifold, genus, handlebody, legal labels.");
  Input_options check_options;
  add_input(*check_command, check_options);
  add_quiet(*check_command, quiet);

  CLI::App* partition_command = app.add_subcommand("partition", "Divides the boundary of a solid into floor, ceiling and walls.");
  Partition_command partition_options;
  add_partition(*partition_command, partition_options);

  CLI::App* parameterize_command = app.add_subcommand("parameterize", "Maps a solid onto a prism.");
  Parameterize_options parameterize_options;
  add_parameterize(*parameterize_command, parameterize_options);

  CLI::App* remesh_command = app.add_subcommand("hexahedra", "Meshes a solid by hexahedra that has been mapped onto a prism.");
  Remesh_command remesh_options;
  add_remesh(*remesh_command, remesh_options);

  CLI::App* verify_command = app.add_subcommand("verify", "Checks the files of a result again, from scratch.");
  std::string folder;
  verify_command->add_option("DIR", folder, "the folder of a result")->required();
  add_quiet(*verify_command, quiet);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? int(EVERYTHING_CERTIFIED) : int(WRONG_USAGE);
  }
  if (*check_command) return check(check_options, quiet);
  if (*partition_command) return partition(partition_options);
  if (*parameterize_command) return parameterize(parameterize_options);
  if (*remesh_command) return remesh(remesh_options);
  return verify(folder, quiet);
}

} // namespace

int say(const std::string& input, const VMP::Status& status, int exit_code) {
  std::cerr << "handlebody: " << input << ": " << status.message() << std::endl;
  return exit_code;
}

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) { // out of memory, and what libraries throw
    std::cerr << "handlebody: " << error.what() << std::endl;
    return NOT_CERTIFIED;
  }
}
