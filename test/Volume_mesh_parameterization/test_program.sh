#!/usr/bin/env bash
# Tests the program handlebody as its users meet it: on bad input it says why and leaves nothing, on good input
# it writes what it promises.
# usage: test_program.sh PROGRAM
set -euo pipefail
export LC_ALL=C

program=$1
scripts=$(realpath "$(dirname "$0")")/../../scripts
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

fail() {
  printf 'FAILED: %s\n' "$*" >&2
  [ ! -s errors ] || sed 's/^/  stderr: /' errors >&2
  exit 1
}

# run CODE ARGUMENT...: runs the program, which must exit with CODE; its output goes to the files output and errors.
run() {
  local expected=$1 code=0
  shift
  "$program" "$@" >output 2>errors || code=$?
  [ "$code" -eq "$expected" ] || fail "handlebody $*: exit code $code instead of $expected"
}

# says_why FILE REASON: stderr is one line that names the file and the reason.
says_why() {
  [ "$(wc -l <errors)" -eq 1 ] || fail "$1: not one line on stderr"
  grep -qF "$1" errors || fail "$1: stderr does not name the file"
  grep -qi -- "$2" errors || fail "$1: stderr does not say '$2'"
}

# refused FILE REASON: both commands refuse the file, and nothing but the report is left.
refused() {
  run 1 check "$1"
  says_why "$1" "$2"
  rm -rf result
  run 1 parameterize "$1" -o result --hexes 100
  says_why "$1" "$2"
  [ "$(ls -A result)" = report.json ] || fail "$1: left $(ls -A result)"
  grep -qi -- "$2" result/report.json || fail "$1: the report does not say '$2'"
  grep -q '"exit_code": 1' result/report.json || fail "$1: the report has no exit code"
}

# cube X ...: the vertices of a unit cube at X, or its triangles with numbers from X on; as a file a whole cube.
cube_vertices() { awk -v x="$1" 'BEGIN { for (i = 0; i < 8; ++i) print x + i % 2, int(i / 2) % 2, int(i / 4) }'; }
cube_triangles() {
  awk -v n="$1" '{ print 3, n + $1, n + $2, n + $3 }' <<END
0 2 3
0 3 1
4 5 7
4 7 6
0 1 5
0 5 4
2 6 7
2 7 3
0 4 6
0 6 2
1 3 7
1 7 5
END
}
cube() { printf 'OFF\n8 12 0\n' && cube_vertices 0 && cube_triangles 0; }

# block M LAYERS: [0, 3] x [0, 3] x [0, 1] without [1, 2] x [1, 2], M cubes of six tetrahedra per unit, labelled.
block() {
  awk -v m="$1" -v layers="$2" '
    function solid(x, y) { return x >= 0 && x < 3 * m && y >= 0 && y < 3 * m && !(hole(x) && hole(y)) }
    function hole(x) { return x >= m && x < 2 * m }
    function vertex(x, y, z) {
      if (!((x, y, z) in number)) {
        number[x, y, z] = ++nv
        points = points x / m " " y / m " " z / layers " 0\n"
      }
      return number[x, y, z]
    }
    function triangle(a, b, c, label) { triangles = triangles a " " b " " c " " label "\n"; ++nt }
    function quadrilateral(a, b, c, d, label) { triangle(a, b, c, label); triangle(a, c, d, label) }
    # along the axes a, b and the third one: three steps from one end of the diagonal of the cube to the other
    function tetrahedron(x, y, z, a, b, even,    p, q, r, s) {
      p = vertex(x, y, z)
      q = vertex(x + (a == 0), y + (a == 1), z + (a == 2))
      r = vertex(x + (a == 0 || b == 0), y + (a == 1 || b == 1), z + (a == 2 || b == 2))
      s = vertex(x + 1, y + 1, z + 1)
      tetrahedra = tetrahedra p " " (even ? q " " r : r " " q) " " s " 0\n"
      ++nc
    }
    BEGIN {
      for (x = 0; x < 3 * m; ++x) for (y = 0; y < 3 * m; ++y) if (solid(x, y)) {
        for (z = 0; z < layers; ++z)
          for (a = 0; a < 3; ++a) for (b = 0; b < 3; ++b) if (a != b) tetrahedron(x, y, z, a, b, (b - a + 3) % 3 == 1)
        for (z = 0; z <= layers; z += layers)
          quadrilateral(vertex(x, y, z), vertex(x + 1, y, z), vertex(x + 1, y + 1, z), vertex(x, y + 1, z), z ? 2 : 1)
      }
      for (x = 0; x <= 3 * m; ++x) for (y = 0; y <= 3 * m; ++y) for (z = 0; z < layers; ++z) {
        if (solid(x - 1, y) != solid(x, y))
          quadrilateral(vertex(x, y, z), vertex(x, y + 1, z), vertex(x, y + 1, z + 1), vertex(x, y, z + 1),
                        x % (3 * m) ? 4 : 3)
        if (solid(x, y - 1) != solid(x, y))
          quadrilateral(vertex(x, y, z), vertex(x + 1, y, z), vertex(x + 1, y, z + 1), vertex(x, y, z + 1),
                        y % (3 * m) ? 4 : 3)
      }
      printf "MeshVersionFormatted 2\nDimension 3\nVertices\n%d\n%s", nv, points
      printf "Triangles\n%d\n%sTetrahedra\n%d\n%sEnd\n", nt, triangles, nc, tetrahedra
    }'
}

test_wrong_usage() {
  run 2
  run 2 check
  run 2 parameterize block.mesh
  run 2 check --no-such-option block.mesh
  run 2 no-such-command
  run 2 parameterize block.mesh -o result --field steepest
  run 2 parameterize block.mesh -o result --direction 1,2
  run 2 parameterize block.mesh -o result --partition labels --direction 0,0,1
  grep -q 'labels excludes --direction' errors || fail "--partition labels with --direction: stderr does not say so"
  run 2 parameterize block.mesh -o result --hexes -5
  run 2 parameterize block.mesh -o result --hexes 1000000000000
  run 2 parameterize block.mesh -o result --pillow
  run 2 parameterize block.mesh -o result --pillow --hexes 0
  run 2 parameterize block.mesh -o result --tets 0
  run 2 parameterize block.mesh -o result --threads 0
  run 2 parameterize block.mesh -o result --threads 1025
  run 2 parameterize block.mesh -o result --threads few
  run 2 parameterize block.mesh -o result --domain block.mesh
  run 2 parameterize block.mesh -o result --floor 0,0,0
  run 2 parameterize block.mesh -o result --domain block.mesh --boundary-map block.mesh --hexes 100
  [ ! -e result ] || fail "wrong usage leaves a folder"
  run 0 --help
  grep -q parameterize output || fail "--help does not name the commands"
}

test_bad_surfaces() {
  cube | sed '10,$d' >truncated.off
  refused truncated.off 'truncated or malformed'
  cube | sed '4s/^[^ ]*/nan/' >nan.off
  refused nan.off 'not finite'
  cube | sed '2s/12/11/; $d' >open.off
  refused open.off 'not closed'
  cube | sed '10s/.*/-1 0.2 0.3/' >crossing.off
  refused crossing.off 'intersect'
  { printf 'OFF\n16 24 0\n' && cube_vertices 0 && cube_vertices 5 && cube_triangles 0 && cube_triangles 8; } >two.off
  refused two.off 'connected\|components'
  # the second cube meets the first one in the edge from 1 to 5, its own from 2 to 6
  { printf 'OFF\n14 24 0\n' && cube_vertices 0 &&
    printf '%s\n' '1 -1 0' '2 -1 0' '2 0 0' '1 -1 1' '2 -1 1' '2 0 1' && cube_triangles 0 &&
    cube_triangles 0 | awk '{ split("8 9 1 10 11 12 5 13", v); print 3, v[$2 + 1], v[$3 + 1], v[$4 + 1] }'; } >edge.off
  refused edge.off 'manifold'
  local type number
  for type in off obj ply stl mesh vtk vtu; do
    for number in {1..500}; do printf '\177\002%d\377\n\0' "$number"; done >noise.$type
    refused noise.$type 'malformed\|names a vertex' # binary STL can be anything
    : >empty.$type
    refused empty.$type 'truncated or malformed'
  done
  refused missing.off 'cannot be read'
  mkdir folder.off
  refused folder.off 'cannot be read\|malformed'
}

test_bad_tetrahedra() {
  head -n 200 block.mesh >truncated.mesh
  refused truncated.mesh 'truncated or malformed'
  sed '5s/^[^ ]*/nan/' block.mesh >nan.mesh
  refused nan.mesh 'not finite'
  awk 'tets && NF == 5 { print $2, $1, $3, $4, $5; tets = 0; next } /Tetrahedra/ { tets = 1 } { print }' block.mesh >inverted.mesh
  refused inverted.mesh 'inverted'
  printf '%s\n' 'MeshVersionFormatted 2' 'Dimension 3' Vertices 4 '0 0 0 0' '1 0 0 0' '0 1 0 0' '1 1 0 0' \
    Tetrahedra 1 '1 2 3 4 0' End >flat.mesh
  refused flat.mesh 'flat'
  awk '/Tetrahedra/ { tets = 1 } !tets && NF == 4 && $4 == 2 { $4 = 1 } { print }' block.mesh >labels.mesh
  refused labels.mesh 'labels'
  cp block.mesh block.xyz
  refused block.xyz 'does not end in'
}

test_bad_direction() {
  local direction
  for direction in 0,0,0 nan,0,0 inf,0,0; do
    rm -rf result
    run 1 parameterize block.mesh -o result --direction "$direction"
    says_why block.mesh 'parameter'
  done
}

test_unwritable_folder() {
  run 1 parameterize block.mesh -o block.mesh/result
  says_why block.mesh 'cannot write'
}

# A report that cannot be written is a failure, whether that shows before the work or after it.
test_unwritable_report() {
  local code=0
  mkdir -p before/report.json/full
  run 1 parameterize block.mesh -o before
  says_why before/report.json 'cannot write'
  mkfifo late.mesh
  "$program" parameterize late.mesh -o after >output 2>errors &
  until [ -e after/report.json ]; do sleep 0.1; done
  rm after/report.json && mkdir after/report.json
  : >late.mesh # the program waits for its input
  wait $! || code=$?
  [ "$code" -eq 1 ] || fail "exit code $code instead of 1 without a report"
  says_why after/report.json 'cannot write'
}

# A key of the report, at whatever depth.
has_key() { grep -q "\"$1\":" "$2/report.json" || fail "the report has no $1"; }

# The folder of the result must not be that of the input if this is named as a file of the result.
test_own_input() {
  mkdir own
  cp block.mesh own/object.mesh
  run 1 parameterize own/object.mesh -o own
  says_why own/object.mesh 'it is the input'
  cmp block.mesh own/object.mesh || fail "the input was touched"
}

test_good_block() {
  local name
  run 0 check block.mesh
  grep -q 'genus 1' output || fail "check does not say genus 1"
  run 0 parameterize block.mesh -o result --hexes 200
  [ ! -s errors ] || fail "a good run is not silent"
  for name in object.mesh order.txt hex.mesh result.vtu curves.vtp report.json; do
    [ -s "result/$name" ] || fail "$name is missing"
  done
  if grep -q '"piecewise_linear": true' result/report.json; then
    [ -s result/parameter.mesh ] || fail "parameter.mesh is missing though its map is certified"
  else
    [ ! -e result/parameter.mesh ] || fail "parameter.mesh is written though its map is not certified"
  fi
  for name in counts certificates critical_points angles distortion floor_distortion distance_to_phi at_barycentres \
    w_lines_to_gradient_of_w residuals stages seconds bytes versions; do
    has_key "$name" result
  done
  run 0 verify result
}

# The partition is found, and whether its boundary map is good is told.
test_surface() {
  cube >cube.off
  "$program" parameterize cube.off -o cube >output 2>errors || {
    grep -q TetGen errors && return
    fail "a cube is not parameterized: $(cat errors)"
  }
  local name
  for name in tried_partitions boundary_energy chosen_partition; do
    has_key "$name" cube
  done
  [ "$(grep -c boundary_energy cube/report.json)" -eq 1 ] || fail "a good partition is not the only one that is tried"
  [ -s cube/parameter.mesh ] || fail "there is no piecewise linear map of a cube"
}

# The table tells everything of a run that made a map.
test_table() {
  command -v python3 >/dev/null && [ -f "$scripts/make_table.py" ] || return 0
  python3 "$scripts/make_table.py" result >output 2>errors || fail "no table is made"
  [ "$(grep -c 'block\.mesh' output)" -eq 3 ] || fail "the tables lack a row for block.mesh"
  ! grep -q '| - ' output || fail "the report lacks what a table has a column for"
}

# The block is a polycube itself; as a bent solid, it has the straight one as domain.
test_given_domain() {
  awk '/Tetrahedra|Triangles/ { others = 1 } NF == 4 && !others { $1 += $3 * $3 } { print }' block.mesh >bent.mesh
  run 0 parameterize bent.mesh -o given --domain block.mesh --boundary-map block.mesh
  local name
  for name in object.mesh order.txt domain.mesh domain_order.txt result.vtu curves.vtp report.json; do
    [ -s "given/$name" ] || fail "$name is missing"
  done
  run 0 verify given
  tac given/domain_order.txt >order && mv order given/domain_order.txt
  run 3 verify given
  run 1 parameterize block.mesh -o given --domain bent.mesh --boundary-map block.mesh
  says_why bent.mesh 'not a polycube'
  run 1 parameterize bent.mesh -o given --domain block.mesh --boundary-map bent.mesh
  says_why bent.mesh 'not one to one'
  [ "$(ls -A given)" = report.json ] || fail "a refused boundary map left $(ls -A given)"
  block 2 2 >coarse.mesh
  run 1 parameterize bent.mesh -o given --domain block.mesh --boundary-map coarse.mesh
  says_why coarse.mesh 'points'
}

# The polycube of block.mesh in all forms that may be given.
ring_cells() { printf '%s\n' '# a ring' '0 0 0' '1 0 0' '2 0 0' '0 1 0' '2 1 0 # beside the hole' '0 2 0' '1 2 0' '2 2 0'; }
ring_corners() { ring_cells | sed 's/#.*//' | awk 'NF { for (i = 0; i < 8; ++i) print $1 + (i % 4 == 1 || i % 4 == 2), $2 + int(i % 4 / 2), int(i / 4) }'; }
ring_quadrilaterals() {
  local faces='1 4 3 2 5 6 7 8 1 2 6 5 2 3 7 6 3 4 8 7 4 1 5 8'
  awk -v faces="$faces" 'BEGIN { split(faces, v); for (k = 0; k < 8; ++k) for (f = 0; f < 24; f += 4)
    print 8 * k + v[f + 1], 8 * k + v[f + 2], 8 * k + v[f + 3], 8 * k + v[f + 4] }'
}
ring_hexahedra() {
  printf '%s\n' 'MeshVersionFormatted 2' 'Dimension 3' Vertices 64
  ring_corners | sed 's/$/ 0/'
  printf '%s\n' Hexahedra 8
  awk 'BEGIN { for (k = 0; k < 8; ++k) { for (i = 1; i <= 8; ++i) printf "%d ", 8 * k + i; print 0 } print "End" }'
}

test_polycubes() {
  ring_cells >ring.cells
  { ring_corners | sed 's/^/v /' && ring_quadrilaterals | sed 's/^/f /'; } >ring.obj
  { printf 'OFF\n64 48 0\n' && ring_corners && ring_quadrilaterals | awk '{ print 4, $1 - 1, $2 - 1, $3 - 1, $4 - 1 }'; } >ring.off
  ring_hexahedra >ring.mesh
  local polycube given=(parameterize bent.mesh -o given --boundary-map block.mesh --tets 500)
  for polycube in ring.cells ring.obj ring.off ring.mesh; do
    run 0 "${given[@]}" --domain "$polycube"
    run 0 verify given
    run 0 "${given[@]}" --domain "$polycube" --floor 1.5,0.5,1 --ceiling 0.5,1.5,-1
    run 0 verify given
  done
  run 0 "${given[@]}"
  run 0 verify given
  ! grep -q '"domain": ""' given/report.json || fail "the report has a domain that was not given"
  run 0 "${given[@]}" --direction 0,0,-2
  run 0 "${given[@]}" --domain ring.obj --floor 0 --ceiling 0.5,0.5,1 --floor 12
  run 1 "${given[@]}" --domain ring.obj --floor 0 --ceiling 5
  says_why ring.obj 'no wall 1'
  run 1 "${given[@]}" --domain ring.obj --floor 48
  says_why ring.obj 'facet 48 of 48'
  run 1 "${given[@]}" --domain ring.cells --floor 0
  says_why ring.cells 'not by numbers'
  run 1 "${given[@]}" --direction 1,0,0
  says_why block.mesh 'no wall 1'
  run 1 "${given[@]}" --direction nan,0,0
  { ring_cells && echo 5 5 5; } >apart.txt
  run 1 "${given[@]}" --domain apart.txt
  says_why apart.txt 'not connected'
  { ring_cells && echo 3 3 0; } >touching.txt
  run 1 "${given[@]}" --domain touching.txt
  says_why touching.txt 'touches itself'
  { ring_cells && echo 2 2 0; } >twice.txt
  run 1 "${given[@]}" --domain twice.txt
  says_why twice.txt 'twice'
  cube >cube.off
  run 1 "${given[@]}" --domain cube.off
  says_why bent.mesh 'not one to one'
}

test_pillow() {
  run 0 parameterize block.mesh -o pillow --hexes 400 --pillow
  grep -q '"pillow": true' pillow/report.json || fail "the report does not say that there is a pillow"
  grep -q '"irregular_interior_edges": 0' pillow/report.json && fail "a pillow without irregular edges"
  run 0 verify pillow
}

# From a result, again and in another size; not from what is no result, or not that of a prism.
test_remeshing() {
  local name
  run 0 parameterize block.mesh -o mapped
  [ -e mapped/parameter.mesh ] || return 0
  run 2 hexahedra mapped -o again
  run 2 hexahedra mapped --hexes 200
  run 0 hexahedra mapped -o again --hexes 200
  [ ! -s errors ] || fail "a good run is not silent"
  for name in hex.mesh report.json; do
    [ -s "again/$name" ] || fail "$name is missing"
  done
  run 0 verify again
  run 0 hexahedra mapped -o again --hexes 400 --pillow --hex-format vtu
  grep -q '"pillow": true' again/report.json || fail "the report does not say that there is a pillow"
  [ -s again/hex.vtu ] && [ ! -e again/hex.mesh ] || fail "an earlier hex.mesh is left"

  run 1 hexahedra mapped -o mapped --hexes 200
  says_why mapped 'it is the input'
  [ -s mapped/object.mesh ] || fail "the input was touched"
  run 1 hexahedra no-such-folder -o again --hexes 200
  says_why no-such-folder 'no object.mesh'
  cp -r mapped spoilt
  cp block.mesh spoilt/parameter.mesh
  run 1 hexahedra spoilt -o again --hexes 200
  says_why spoilt 'other vertices'
  awk '/Tetrahedra|Triangles/ { others = 1 } NF == 4 && !others { $1 += $3 } { print }' mapped/parameter.mesh >spoilt/parameter.mesh
  run 1 hexahedra spoilt -o again --hexes 200
  says_why spoilt 'prism'
  rm spoilt/parameter.mesh
  run 1 hexahedra spoilt -o again --hexes 200
  says_why spoilt 'no parameter.mesh'
  [ "$(ls -A again)" = report.json ] || fail "a refused result left $(ls -A again)"
}

# Each format has its file and no other; programs that are there can read it. In the straight block the temperature is
# linear, but for hexahedra that cut off a bit of its edges: CalculiX and the tetrahedra agree well.
test_hexahedra_formats() {
  local name largest
  run 2 parameterize block.mesh -o formats --hex-format gmsh
  run 2 parameterize block.mesh -o formats --hexes 200 --hex-format medit,stl
  run 0 parameterize block.mesh -o formats --hexes 200 --hex-format gmsh,abaqus,vtu
  [ ! -e formats/hex.mesh ] || fail "hex.mesh was not asked for"
  for name in 'hex.msh 3 1 "solid"' 'hex.msh 2 4 "wall_1"' 'hex.inp *NSET, NSET=WALL_1' 'hex.vtu scaled_jacobian'; do
    grep -qF -- "${name#* }" "formats/${name%% *}" || fail "not in the file: $name"
  done
  if command -v gmsh >/dev/null; then
    gmsh -save -format msh2 -o old.msh formats/hex.msh >output 2>&1 || fail "Gmsh does not read hex.msh"
    grep -qF '2 4 "wall_1"' old.msh || fail "Gmsh does not find the groups"
    [ "$(awk 'NF == 13' old.msh | wc -l)" -eq "$(awk 'NF == 9' formats/hex.msh | wc -l)" ] || fail "Gmsh loses hexahedra"
  fi
  if command -v ccx >/dev/null && command -v python3 >/dev/null; then
    python3 "$scripts/solve_with_calculix.py" formats >output 2>errors || fail "CalculiX does not solve hex.inp"
    largest=$(awk -F'|' 'END { print $5 }' output)
    awk -v x="$largest" 'BEGIN { exit !(x < 0.01) }' || fail "the temperatures of CalculiX differ by $largest"
  fi
  run 0 parameterize block.mesh -o formats --hexes 200
  [ -s formats/hex.mesh ] && [ ! -e formats/hex.inp ] || fail "by default the format is not only medit"
}

# The number of hexahedra follows from the length of edges, or from the cells along the axes; layers may be graded.
test_hexahedra_sizes() {
  local few many
  number_of_hexahedra() { awk 'found { print $1; exit } /^Hexahedra/ { if (NF > 1) { print $2; exit } found = 1 }' sizes/hex.mesh; }
  run 2 parameterize block.mesh -o sizes --hexes 200 --hex-edge 0.5
  run 2 parameterize block.mesh -o sizes --hex-edge 0.5 --hex-cells 4,4,2
  run 2 parameterize block.mesh -o sizes --hex-cells 4,4
  run 2 parameterize block.mesh -o sizes --hex-cells 0,4,2
  run 2 parameterize block.mesh -o sizes --hex-grading 2
  run 0 parameterize block.mesh -o sizes --hex-edge 0.5
  few=$(number_of_hexahedra)
  run 0 parameterize block.mesh -o sizes --hex-edge 0.25
  many=$(number_of_hexahedra)
  [ "$many" -gt "$((4 * few))" ] || fail "half of the edge gives $many instead of $few hexahedra"
  run 0 parameterize block.mesh -o sizes --hex-cells 6,6,3 --hex-grading 1.5
  [ "$(($(number_of_hexahedra) % 3))" -eq 0 ] || fail "$(number_of_hexahedra) hexahedra in three layers"
}

# The result does not depend on the number of threads.
test_threads() {
  local name
  run 0 parameterize block.mesh -o one --hexes 200 --threads 1
  if ! "$program" parameterize block.mesh -o two --hexes 200 --threads 2 >output 2>errors; then
    run 2 parameterize block.mesh -o two --hexes 200 --threads 2
    grep -q TBB errors || fail "two threads are refused, but not for want of TBB"
    return
  fi
  grep -q '"threads": 2' two/report.json || fail "the report does not say that there were two threads"
  for name in one two; do
    sed '/"seconds"/d; /"bytes"/d; /"threads"/d' $name/report.json >$name.json
    mv $name.json $name/report.json
  done
  diff -r one two >errors || fail "two threads give another result than one"
}

test_partition() {
  run 2 partition block.mesh
  run 2 partition block.mesh -o labelled.mesh --floor 1,2
  run 2 partition block.mesh -o labelled.mesh --wall 1,2,3
  run 2 partition block.mesh -o labelled.mesh --candidates 0
  run 2 partition block.mesh -o labelled.vtu
  run 2 partition block.mesh -o labelled.mesh --labels guess
  grep -qF 'guess not in {ignore,keep,mend}' errors || fail "--labels guess: stderr does not say what there is"
  run 1 partition block.mesh -o block.mesh
  says_why block.mesh 'it is the input'
  run 1 partition block.mesh -o labelled.mesh --floor 17
  says_why block.mesh 'by points'
  run 1 partition block.mesh -o labelled.mesh --choose 99
  says_why block.mesh 'there are only'
  run 1 partition block.mesh -o labelled.mesh --wall 0:0,1.4,.5 --wall 0:1,1.4,.5
  says_why block.mesh 'is to be wall 0'
  [ ! -e labelled.mesh ] || fail "a refused partition leaves a file"

  run 0 partition block.mesh -o labelled.mesh --direction 0,0,1 --floor .4,.5,0 --ceiling .4,.5,1 --wall 0:1,1.4,.5
  grep -q 'legal of' output || fail "partition does not tell what it tried"
  run 0 check labelled.mesh
  grep -q 'wall 0: .* area 4,' output || fail "the picked wall is not wall 0"
  run 0 parameterize labelled.mesh -o result --quiet

  awk '/^Triangles/ { first = NR + 2 } NR == first { $4 = 2 } 1' block.mesh >island.mesh
  run 1 check island.mesh
  run 0 partition island.mesh -o labelled.mesh --labels mend --quiet
  [ ! -s output ] || fail "partition is not quiet"
  run 0 check labelled.mesh

  cube >cube.off
  run 2 partition cube.off -o labelled.mesh --labels keep
  grep -q 'cube.off is a surface file' errors || fail "--labels keep: stderr does not say that a surface has none"
  if ! "$program" partition cube.off -o labelled.mesh --floor 0 --tets 100 >output 2>errors; then
    run 1 partition cube.off -o labelled.mesh --floor 0
    grep -q TetGen errors || fail "a cube is refused, but not for want of TetGen"
    return
  fi
  run 0 check labelled.mesh
  run 1 partition cube.off -o labelled.mesh --floor 12
  says_why cube.off 'triangle 12 of 12'
}

test_broken_results() {
  cp result/order.txt order
  { tail -n 1 order && sed '1d;$d' order && head -n 1 order; } >result/order.txt
  run 3 verify result
  grep -q order.txt errors || fail "verify does not name order.txt"
  { cat order && echo word; } >result/order.txt
  run 1 verify result
  rm result/order.txt
  run 1 verify result
  cp order result/order.txt
  run 0 verify result
  run 1 verify no-such-folder
}

block 4 3 >block.mesh
test_wrong_usage
test_bad_surfaces
test_bad_tetrahedra
test_bad_direction
test_unwritable_folder
test_unwritable_report
test_own_input
test_good_block
test_surface
test_table
test_given_domain
test_polycubes
test_pillow
test_remeshing
test_hexahedra_formats
test_hexahedra_sizes
test_threads
test_partition
test_broken_results
echo 'done'
