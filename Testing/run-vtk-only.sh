#!/usr/bin/env bash
# Builds the module against the distribution's VTK alone, in build-vtk/, and runs its C++ and Python
# tests. Arguments go to ctest.
#   LMO_TARGETS=T...    builds these targets only, for a choice of tests
#   LMO_UNITY_BUILD=ON  compiles each room of the sources at once
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir="$source_dir/build-vtk"

. "$source_dir/CMake/install-packages.sh"
install_packages "${tool_packages[@]}"
is_installed libvtk9-dev || install_build_packages libtbb-dev
use_vtk "$build_dir/vtk"

cmake -S "$source_dir" -B "$build_dir" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 \
  -DLMO_PARAVIEW=OFF -DVTK_DIR="$VTK_DIR" -DBUILD_TESTING=ON \
  -DLMO_UNITY_BUILD="${LMO_UNITY_BUILD:-OFF}" >/dev/null
# shellcheck disable=SC2086
cmake --build "$build_dir" -j2 --target ${LMO_TARGETS:-all}
ctest --test-dir "$build_dir" -j2 --output-on-failure "$@"
