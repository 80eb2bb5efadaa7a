#!/usr/bin/env bash
# Checks what CGAL's testers check before they merge a branch, as far as it applies to one package outside of the tree.
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

if [ $# -gt 0 ]; then
  say "usage: scripts/house_rules.sh"
  say "Prints which of CGAL's rules for packages the files of this checkout break; exit 0 if none, else 1."
  case $1 in -h | --help) exit 0 ;; *) exit 2 ;; esac
fi
cd "$root"

package=Volume_mesh_parameterization
longest_header=450
violations=0

violation() {
  say "house rule: $*"
  violations=$((violations + 1))
}

# sources PATTERN...: the files of the checkout, new ones too
sources() { git ls-files --cached --others --exclude-standard -- "$@" | while read -r f; do [ ! -f "$f" ] || say "$f"; done; }

check_headers() {
  local header tag
  # shellcheck disable=SC2016
  for header in $(sources 'include/*.h'); do
    for tag in 'SPDX-License-Identifier: GPL-3.0-or-later' '$URL$' '$Id$'; do
      grep -qF "$tag" "$header" || violation "$header lacks $tag"
    done
    case $header in
    include/CGAL/license/*) ;;
    *) [ "$(grep -m1 '#include' "$header")" = "#include <CGAL/license/$package.h>" ] ||
      violation "$header does not begin by including the licence" ;;
    esac
    [ "$(wc -l <"$header")" -le $longest_header ] || violation "$header has more than $longest_header lines"
    ! grep -nE '\b(assert|abort|exit)\(' "$header" || violation "$header calls assert, abort or exit"
  done
}

check_text() {
  local file
  for file in $(sources '*.h' '*.cpp' '*.txt' '*.in' '*.md' '*.sh' '*.py' '*.cmake'); do
    ! grep -nP '\t' "$file" || violation "$file has tabs"
    ! grep -nP '[ \r]+$' "$file" || violation "$file has trailing blanks"
    iconv -f UTF-8 -t UTF-8 "$file" >/dev/null 2>&1 || violation "$file is not UTF-8"
  done
  file=$(sources | tr '[:upper:]' '[:lower:]' | sort | uniq -d)
  [ -z "$file" ] || violation "names that differ in case only: $file"
}

# check_folder FOLDER SUFFIX: the project has CGAL's name, and every program is built
check_folder() {
  local lists=$1/$package/CMakeLists.txt program
  [ -f "$lists" ] || { violation "$lists is missing" && return; }
  awk '!/^ *(#|$)/ { found = /^cmake_minimum_required/; exit } END { exit !found }' "$lists" ||
    violation "$lists does not begin with cmake_minimum_required"
  grep -qE "^project\( *${package}_$2\b" "$lists" || violation "$lists: the project is not called ${package}_$2"
  for program in $(sources "$1/$package/*.cpp"); do
    grep -qw "$(basename "$program")" "$lists" || violation "$program is not built"
  done
}

check_examples_are_documented() {
  local example
  for example in $(sources "examples/$package/*.cpp"); do
    grep -q "\\\\example $package/$(basename "$example")" "doc/$package/examples.txt" ||
      violation "$example is missing in doc/$package/examples.txt"
  done
}

# matches EXPRESSION PATH...: what matches the Perl expression below the paths, each once
matches() { grep -rhoP "$1" "${@:2}" | sort -u || true; }

# Every named parameter that is documented is one of CGAL's or has a tag of ours.
check_named_parameters() {
  local cgal name
  cgal=$(echo '#include <CGAL/STL_Extension/internal/parameters_interface.h>' | g++ -E -P -x c++ -)
  while read -r name; do
    grep -qw "$name" <<<"$cgal" || grep -rqE "\b${name}_t\b" include || violation "no named parameter is called $name"
  done < <(matches '\\cgalParamNBegin\{\K[a-z_]+' include)
}

check_groups() {
  local group
  while read -r group; do
    grep -qE "defgroup $group( |$)" "doc/$package/PackageDescription.txt" || violation "there is no group $group"
  done < <(matches '\\(ingroup|addtogroup) +\K\w+' include "doc/$package")
}

# package_of HEADER: the package of CGAL that has the header
package_of() {
  case $1 in
  $package/*) say $package ;;
  license.h | license/* | config.h | version.h | disable_warnings.h | enable_warnings.h) say Installation ;;
  enum.h | determinant.h | Bbox_*.h | Kernel/* | Kernel_traits.h | Exact_predicates_*.h | Origin.h | representation_tags.h) say Kernel_23 ;;
  Simple_cartesian.h | Cartesian.h) say Cartesian_kernel ;;
  number_utils.h | number_type_basic.h | Coercion_traits.h | ipower.h) say Algebraic_foundations ;;
  number_type_config.h | Exact_rational.h | Lazy_exact_nt.h | Gmpq.h | Interval_nt.h | FPU.h) say Number_types ;;
  squared_distance_3.h | Distance_3/*) say Distance_3 ;;
  squared_distance_2.h | Distance_2/*) say Distance_2 ;;
  Intersections_3/*) say Intersections_3 ;;
  Intersections_2/*) say Intersections_2 ;;
  AABB_*.h) say AABB_tree ;;
  box_intersection_d.h | Box_intersection_d/*) say Box_intersection_d ;;
  Eigen_*.h) say Solver_interface ;;
  boost/graph/*) say BGL ;;
  Surface_mesh.h | Surface_mesh/*) say Surface_mesh ;;
  Polygon_2_algorithms.h) say Polygon ;;
  Polygon_mesh_processing/*) say Polygon_mesh_processing ;;
  IO/polygon_soup_io.h) say Stream_support ;;
  Unique_hash_map.h) say Hash_map ;;
  make_conforming_constrained_*.h) say Constrained_triangulation_3 ;;
  spatial_sort.h | Spatial_sort_*.h | hilbert_sort.h) say Spatial_sorting ;;
  property_map.h) say Property_map ;;
  Random.h) say Random_numbers ;;
  assertions.h | Uncertain.h | tags.h | Named_function_parameters.h | for_each.h | iterator.h | Default.h | array.h) say STL_Extension ;;
  *) say "(the package of CGAL/$1, which house_rules.sh does not know)" ;;
  esac
}

used_packages() {
  local header
  while read -r header; do package_of "$header"; done < <(matches '^ *#include <CGAL/\K[^>]+' include)
}

check_dependencies() {
  local difference
  difference=$(diff <({ say $package && used_packages; } | LC_ALL=C sort -u) "package_info/$package/dependencies") ||
    violation "package_info/$package/dependencies differs from what is included:"$'\n'"$difference"
}

check_package_info() {
  local file
  for file in copyright dependencies description.txt license.txt long_description.txt maintainer; do
    [ -s "package_info/$package/$file" ] || violation "package_info/$package/$file is missing"
  done
}

check_headers
check_text
check_folder examples Examples
check_folder test Tests
check_folder benchmark Benchmark
check_folder demo Demo
check_examples_are_documented
check_named_parameters
check_groups
check_package_info
check_dependencies
[ "$violations" -eq 0 ] && say "All house rules are kept."
