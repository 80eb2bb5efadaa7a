#!/usr/bin/env bash
# Installs what is missing, builds everything but the benchmarks, runs all tests, and writes the documentation, which must
# raise no warning.
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

if [ $# -gt 0 ]; then
  say "usage: scripts/test.sh"
  say "Installs the Debian packages that are missing, builds all but the benchmarks into build-test, runs all tests with"
  say "CTest and writes the documentation into build-test/doc/html."
  case $1 in -h | --help) exit 0 ;; *) exit 2 ;; esac
fi

build=$root/build-test
install "${compiler_packages[@]}" "${library_packages[@]}" "${petsc_packages[@]}" doxygen
provide_cgal_data "$build/cgal"

# -O1, sources in groups, and no optimization of examples: most of the time goes into compilation
cmake -S "$root" -B "$build" -DCGAL_DATA_DIR="$build/cgal/data" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Werror" \
  -DWITH_demo=ON -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=5 \
  -DWITH_examples=ON -DGROUP_EXAMPLES=ON -DEXAMPLE_COMPILE_OPTIONS=-O0 -DWITH_tests=ON -DGROUP_TESTS=ON
cmake --build "$build" --parallel 2
OPENBLAS_NUM_THREADS=1 ctest --test-dir "$build" --parallel 2 --output-on-failure

cmake --build "$build" --target doc
if [ -s "$build/doc/warnings.log" ]; then
  cat "$build/doc/warnings.log" >&2
  fail "the documentation raises warnings"
fi
say "All tests passed, and the documentation raises no warning: $build/doc/html/index.html"
