#!/usr/bin/env bash
# Runs the C++ tests with clang's sanitizers, against VTK alone: bash Testing/run-sanitized.sh [PRESET]
#   address  address and undefined-behaviour sanitizer (the default)
#   thread   thread sanitizer
# Further arguments go to ctest.
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${1:-address}
shift || true

. "$source_dir/CMake/install-packages.sh"
install_packages "${tool_packages[@]}" "${analysis_packages[@]}"
is_installed libvtk9-dev || install_build_packages libtbb-dev
use_vtk "$source_dir/build-vtk/vtk"
export UBSAN_OPTIONS=print_stacktrace=1

cd "$source_dir"
cmake --preset "$preset" -DPython3_EXECUTABLE=/usr/bin/python3 -DVTK_DIR="$VTK_DIR" >/dev/null
cmake --build --preset "$preset" -j2
ctest --preset "$preset" "$@"
