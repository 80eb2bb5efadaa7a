#!/usr/bin/env bash
# usage: test_handlebody_mpi.sh MPIRUN HANDLEBODY_MPI HANDLEBODY SOLID...
# Several processes compute the same fields as one, and as the library alone, and trace curves to the same places, to the bit.
set -euo pipefail

mpirun=$1 program=$2 handlebody=$3
shift 3
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

fail() {
  echo "test_handlebody_mpi: $*" >&2
  exit 1
}

# agree FILE FILE: the words are the same, and numbers differ by 1e-10 at most
agree() {
  awk -v most=1e-10 '
    function is_number(word) { return word ~ /^[-+]?[0-9.]+([eE][-+]?[0-9]+)?$/ }
    NR == FNR { first[FNR] = $0; lines = FNR; next }
    {
      n = split($0, a)
      if (split(first[FNR], b) != n) exit bad = 1
      for (i = 1; i <= n; ++i) {
        if (a[i] == b[i]) continue
        difference = a[i] > b[i] ? a[i] - b[i] : b[i] - a[i]
        if (!is_number(a[i]) || !is_number(b[i]) || difference > most) exit bad = 1
      }
    }
    END { exit bad || lines != FNR }' "$1" "$2"
}

# expect STATUS COMMAND...
expect() {
  local status=0
  "${@:2}" >"$folder/output" 2>&1 || status=$?
  [ "$status" -eq "$1" ] || { cat "$folder/output" >&2; fail "exit $status instead of $1: ${*:2}"; }
}

for solid in "$@"; do
  expect 0 "$program" "$solid" -o "$folder/1.vtu" --curves "$folder/1.txt" --check
  grep -qE '^[0-9]+( [-+.0-9e]+){6}$' "$folder/1.txt" || fail "$solid: no curve arrives"
  for processes in 2 3; do
    expect 0 "$mpirun" -n "$processes" "$program" "$solid" -o "$folder/$processes.vtu" --curves "$folder/$processes.txt" --check
    grep -q "\"processes\": $processes" "$folder/output" || fail "there are not $processes processes"
    grep -q '"crossings": [1-9]' "$folder/output" || fail "$solid: no curve crosses from process to process"
    agree "$folder/1.vtu" "$folder/$processes.vtu" || fail "$solid: $processes processes differ from one"
    cmp "$folder/1.txt" "$folder/$processes.txt" || fail "$solid: curves in $processes processes differ from those in one"
  done
done

# the comparison above sees differences
sed '0,/0\.5/s//0.50000001/' "$folder/1.vtu" >"$folder/changed.vtu"
! agree "$folder/1.vtu" "$folder/changed.vtu" || fail "a changed number is not seen"

# a part of the curves
expect 0 "$mpirun" -n 2 "$program" "$1" --curves "$folder/some.txt" --seeds 5
[ -z "$(comm -13 <(sort "$folder/1.txt") <(sort "$folder/some.txt"))" ] || fail "fewer seeds have other curves"

# a given order
expect 0 "$handlebody" parameterize "$1" -o "$folder/result" --partition labels --quiet
given=("$folder/result/object.mesh" --order "$folder/result/order.txt")
expect 0 "$mpirun" -n 2 "$program" "${given[@]}" --curves "$folder/given.txt" --check
[ -s "$folder/given.txt" ] || fail "no curves along a given order"
tac "$folder/result/order.txt" >"$folder/reversed.txt"
expect 3 "$mpirun" -n 2 "$program" "$folder/result/object.mesh" --order "$folder/reversed.txt" --curves "$folder/none.txt"
[ ! -e "$folder/none.txt" ] || fail "curves without a certificate"

printf 'MeshVersionFormatted 2\nDimension 3\nEnd\n' >"$folder/empty.mesh"
expect 1 "$program" "$folder/empty.mesh"
expect 1 "$mpirun" -n 2 "$program" "$folder/empty.mesh"
expect 2 "$program" --no-such-option
expect 2 "$program" "${given[@]}" # an order is for curves
expect 3 "$program" "$1" -o "$folder/no/such/folder.vtu"
