# Installs what is missing, from Debian, and nothing else. Sourced: `install_missing [--replace] PACKAGE...`.
# Boost 1.81 takes the place of 1.74: apt would remove the old headers and what needs them without a question, so what it
# would remove is shown and left to the user.
install_missing() {
  replace=""
  if [ "${1:-}" = "--replace" ]; then replace=yes; shift; fi
  missing=""
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q "ok installed" || missing="$missing $package"
  done
  [ -z "$missing" ] && return 0
  echo "installing:$missing"
  sudo=""
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || { echo "error: packages are missing; run as root or install sudo" >&2; return 1; }
    sudo=sudo
  fi
  $sudo apt-get update -qq
  removed=$(apt-get install -s --no-install-recommends $missing | awk '/^Remv/ { print "  " $2 }')
  if [ -n "$removed" ] && [ -z "$replace" ]; then
    printf 'error: installing these would remove:\n%s\nrun again with --replace to agree\n' "$removed" >&2
    return 1
  fi
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
}

build_packages="g++ cmake ninja-build libboost1.81-dev libcli11-dev libtomlplusplus-dev libeigen3-dev librandom123-dev libnlopt-dev libnlopt-cxx-dev"
test_packages="doctest-dev"
mpi_packages="openmpi-bin libopenmpi-dev"  # for LOADPATH_MPI=ON
python_packages="python3-dev python3-numpy pybind11-dev"  # LOADPATH_PYTHON
hdf5_packages="libhdf5-dev"  # LOADPATH_HDF5
binding_test_packages="python3-h5py"
count_packages="valgrind"
width_packages="qemu-user"
latex_packages="texlive-latex-base texlive-latex-recommended texlive-pictures lmodern poppler-utils"  # for tests of .tex reports; without them these are skipped
schema_packages="python3-jsonschema"  # for tests/schema.py; without it its test is skipped
extension_packages="nodejs npm"  # for scripts/extension.sh; without them its test is skipped
