#undef NDEBUG
#include <CGAL/Volume_mesh_parameterization/internal/write_atomically.h>

#include "io_test_util.h"

#include <cassert>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;
using VMP::internal::write_atomically;

std::string content(const std::string& filename) {
  std::ifstream is(filename);
  return {std::istreambuf_iterator<char>(is), {}};
}

auto writer_of(const std::string& text) {
  return [text](std::ostream& os) {
    os << text;
    return VMP::Status();
  };
}

void test_replaces_when_complete(const Temporary_folder& folder) {
  const std::string file = folder.file("a.txt");
  expect(write_atomically(file, writer_of("first")), VMP::OK);
  assert(content(file) == "first");
  expect(write_atomically(file,
                          [&](std::ostream& os) {
                            os << "second" << std::flush;
                            assert(content(file) == "first"); // nobody sees half a file
                            return VMP::Status();
                          }),
         VMP::OK);
  assert(content(file) == "second" && folder.number_of_files() == 1);
}

void test_failure_changes_nothing(const Temporary_folder& folder) {
  const std::string file = folder.file("a.txt");
  const auto fails = [](std::ostream& os) {
    os << "half";
    return VMP::Status(VMP::ERROR_COORDINATE_NOT_FINITE, "vertex 3");
  };
  expect(write_atomically(file, fails), VMP::ERROR_COORDINATE_NOT_FINITE, "a.txt: vertex 3");
  const auto breaks = [](std::ostream& os) {
    os.setstate(std::ios::badbit);
    return VMP::Status();
  };
  expect(write_atomically(file, breaks), VMP::ERROR_CANNOT_WRITE_FILE, "a.txt");
  assert(content(file) == "second" && folder.number_of_files() == 1);
}

void test_names_in_use_and_links(const Temporary_folder& folder) {
  write_text(folder.file("a.txt.part0"), "of somebody else");
  std::filesystem::create_symlink("a.txt", folder.file("link.txt"));
  expect(write_atomically(folder.file("link.txt"), writer_of("third")), VMP::OK);
  assert(content(folder.file("a.txt")) == "third" && std::filesystem::is_symlink(folder.file("link.txt")));
  assert(content(folder.file("a.txt.part0")) == "of somebody else" && folder.number_of_files() == 3);
}

void test_unwritable(const Temporary_folder& folder) {
  expect(write_atomically(folder.file("none/a.txt"), writer_of("x")), VMP::ERROR_CANNOT_WRITE_FILE, "a.txt: No such");
  expect(write_atomically(folder.file("a.txt/b.txt"), writer_of("x")), VMP::ERROR_CANNOT_WRITE_FILE, "b.txt: ");
  expect(write_atomically(folder.file(""), writer_of("x")), VMP::ERROR_CANNOT_WRITE_FILE, "Is a directory");
  if (std::filesystem::exists("/dev/full")) {
    expect(write_atomically("/dev/full", writer_of("x")), VMP::ERROR_CANNOT_WRITE_FILE, "/dev/full: No space left");
    assert(std::filesystem::is_character_file("/dev/full"));
  }
  const std::string locked = folder.file("locked");
  std::filesystem::create_directory(locked);
  std::filesystem::permissions(locked, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  const VMP::Status status = write_atomically(locked + "/a.txt", writer_of("x"));
  if (!status.ok()) expect(status, VMP::ERROR_CANNOT_WRITE_FILE, "a.txt: Permission denied"); // root may write
}

int main() {
  const Temporary_folder folder("test_write_atomically");
  test_replaces_when_complete(folder);
  test_failure_changes_nothing(folder);
  test_names_in_use_and_links(folder);
  test_unwritable(folder);
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
