#!/usr/bin/env bash
# Builds the program handlebody and parameterizes one solid with it.
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() {
  cat <<EOF
usage: scripts/demo.sh [--pictures] [INPUT]

Installs the Debian packages that are missing, builds build/bin/handlebody, maps the solid INPUT onto a prism, makes a
hexahedral mesh of about 800 cells, verifies all files from scratch and tells where they are: in the folder
result-NAME, NAME being that of INPUT without folder and ending.

  INPUT        a closed triangle surface (.off .obj .ply .stl) or tetrahedra (.mesh .vtk .vtu);
               default: the surface eight.off of CGAL's data
  --pictures   also draws pictures into the same folder; installs VTK for Python, a big download
EOF
}

pictures=no input=
while [ $# -gt 0 ]; do
  case $1 in
  -h | --help) usage && exit 0 ;;
  --pictures) pictures=yes ;;
  -*) usage >&2 && fail "unknown option $1" ;;
  *) [ -z "$input" ] || fail "more than one INPUT: $input and $1"; input=$1 ;;
  esac
  shift
done

# count SECTION FILE: how many elements the section of a MEDIT file announces
count() { awk -v section="$1" '$1 == section { if (NF == 1) getline; print $NF; exit }' "$2"; }

describe() {
  if [ ! -e "$result/$1" ]; then
    say "  $1  not written, report.json says why"
  else
    say "  $1  $2"
  fi
}

[ -z "$input" ] || [ -e "$input" ] || fail "$input does not exist"
install "${compiler_packages[@]}" "${library_packages[@]}"
cmake -S "$root" -B "$root/build" -DCMAKE_BUILD_TYPE=Release -DWITH_demo=ON >"$root/build.log" 2>&1 ||
  { cat "$root/build.log" >&2; fail "the configuration failed"; }
rm "$root/build.log"
cmake --build "$root/build" --target handlebody --parallel 2

if [ -z "$input" ]; then
  provide_cgal_data "$root/build/cgal"
  input=$root/build/cgal/data/meshes/eight.off
fi
name=$(basename "$input")
result=$root/result-${name%.*}

handlebody=$root/build/bin/handlebody
status=0
"$handlebody" parameterize "$input" -o "$result" --hexes 800 || status=$?
if [ "$status" -ne 0 ] && [ "$status" -ne 3 ]; then exit "$status"; fi
verdict="everything that is written holds"
"$handlebody" verify "$result" || { status=$? verdict="NOT everything holds, see the messages above"; }

if [ "$pictures" = yes ]; then
  install python3-vtk9 python3-numpy xvfb xauth
  xvfb-run -a /usr/bin/python3 "$root/scripts/make_pictures.py" "$result"
fi

cells=$(count Tetrahedra "$result/object.mesh")
say
say "$name is cut into $cells tetrahedra; verified from scratch: $verdict. In $result:"
describe order.txt "the order in which a front sweeps them from floor to ceiling, which certifies the map"
describe parameter.mesh "the same tetrahedra as a second, piecewise linear map puts them into the prism"
describe hex.mesh "$([ -e "$result/hex.mesh" ] && count Hexahedra "$result/hex.mesh") hexahedra that fill the solid"
describe result.vtu "the solid with its coordinates u, v, w, and curves.vtp some curves; ParaView opens both"
exit "$status"
