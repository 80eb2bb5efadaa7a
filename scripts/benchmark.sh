#!/usr/bin/env bash
# Measures what the stages cost, and other programs on the same solids.
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() {
  cat <<EOF
usage: scripts/benchmark.sh [--size small|full] [--repetitions N]

Installs the Debian packages that are missing, builds the benchmarks into build-benchmark, measures the stages on a figure
eight and on a long knot, and VTK's stream tracer, PETSc, CHOLMOD and Eigen on the same solids; prints tables and writes
build-benchmark/results/benchmark.json.

  --size small   solids of about 50,000 and 200,000 tetrahedra, medians of three; some minutes (default)
  --size full    up to two million, medians of five; hours
  --repetitions  of how many runs medians are taken instead

The machine should have nothing else to do.
EOF
}

size=small
repetitions=
while [ $# -gt 0 ]; do
  case $1 in
  -h | --help) usage && exit 0 ;;
  --size) [ $# -gt 1 ] || fail "--size needs small or full"; size=$2; shift ;;
  --repetitions) [ $# -gt 1 ] || fail "--repetitions needs a number"; repetitions=$2; shift ;;
  *) usage >&2 && fail "unknown argument $1" ;;
  esac
  shift
done
case $size in small | full) ;; *) usage >&2 && fail "there is no size $size" ;; esac
[[ $repetitions =~ ^([1-9][0-9]*)?$ ]] || fail "--repetitions needs a positive number, not $repetitions"

build=$root/build-benchmark
install "${compiler_packages[@]}" "${library_packages[@]}" "${petsc_packages[@]}" libsuitesparse-dev python3-vtk9 python3-numpy
provide_cgal_data "$build/cgal"
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DWITH_demo=ON -DWITH_benchmark=ON
cmake --build "$build" --target handlebody benchmark_stages benchmark_solvers --parallel 2
/usr/bin/python3 "$root/scripts/benchmark.py" "$build/bin" "$build/cgal/data/meshes" "$build/results" "$size" ${repetitions:+"$repetitions"}
