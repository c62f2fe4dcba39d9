#!/usr/bin/env bash
# Builds the module against VTK alone (Debian's 9.1) in build-vtk/ and runs its C++ and Python tests.
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir="$source_dir/build-vtk"

. "$source_dir/CMake/install-packages.sh"
install_packages "${build_packages[@]}" libtbb-dev
unpack_vtk "$build_dir/vtk"
export PYTHONPATH="$build_dir/vtk/usr/lib/python3/dist-packages"

cmake -S "$source_dir" -B "$build_dir" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 \
  -DLMO_PARAVIEW=OFF -DVTK_DIR="$VTK_DIR" -DBUILD_TESTING=ON >/dev/null
cmake --build "$build_dir" -j2
ctest --test-dir "$build_dir" --output-on-failure "$@"
