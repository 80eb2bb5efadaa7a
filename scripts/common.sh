# shellcheck shell=bash disable=SC2034
# Shell functions of demo.sh, test.sh and house_rules.sh; to be sourced by bash.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

compiler_packages=(cmake g++ make)
library_packages=(libcgal-dev libeigen3-dev libtet1.5-dev libtbb-dev libcli11-dev nlohmann-json3-dev)
petsc_packages=(libpetsc-real-dev openmpi-bin pkg-config) # PETSc with MPI: algebraic multigrid, several machines

say() { printf '%s\n' "$*"; }

fail() {
  printf 'error: %s\n' "$*" >&2
  exit 2
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    fail "this needs root: $* (run as root or install sudo)"
  fi
}

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# install PACKAGE...: installs those that are missing; on other systems than Debian it leaves that to the user.
install() {
  local package missing=()
  if ! command -v dpkg-query >/dev/null; then
    say "This is no Debian: make sure that what these packages hold is there: $*"
    return
  fi
  for package in "$@"; do is_installed "$package" || missing+=("$package"); done
  if [ "${#missing[@]}" -eq 0 ]; then return; fi
  say "Installing ${missing[*]}"
  as_root apt-get update -qq
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

# provide_cgal_data FOLDER: unpacks the data of CGAL's examples, which Debian has in the package libcgal-demo.
provide_cgal_data() {
  local archive=/usr/share/doc/libcgal-demo/data.tar.gz
  if [ -e "$1/data/meshes/eight.off" ]; then return; fi
  mkdir -p "$1"
  install libcgal-demo
  if [ -e "$archive" ]; then
    tar -xzf "$archive" -C "$1"
  else # slim images of Debian are told not to unpack /usr/share/doc
    (cd "$1" && apt-get download -qq libcgal-demo)
    dpkg-deb --fsys-tarfile "$1"/libcgal-demo_*.deb | tar -xO ".$archive" | tar -xz -C "$1"
    rm "$1"/libcgal-demo_*.deb
  fi
}
