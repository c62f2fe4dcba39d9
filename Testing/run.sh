#!/usr/bin/env bash
# Builds the module, the Python package and the plugin in build/, and runs all tests. Installs what
# it needs on Debian and Ubuntu. Arguments go to ctest: bash Testing/run.sh -R Core
#   LMO_REAL_MESHES=DIR  folder of real meshes that are measured too
#   LMO_USE_PETSC=ON     an error if surfaces over several processes cannot be built
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir="$source_dir/build"

. "$source_dir/CMake/install-packages.sh"
install_build_packages "${display_packages[@]}" "${test_packages[@]}" "${parallel_packages[@]}"
install_if_available python3-pyvista

cmake -S "$source_dir" -B "$build_dir" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 \
  -DBUILD_TESTING=ON -DLMO_USE_PETSC="${LMO_USE_PETSC:-AUTO}" -DLMO_REAL_MESHES="${LMO_REAL_MESHES:-}" >/dev/null
cmake --build "$build_dir" -j2
ctest --test-dir "$build_dir" -j2 --output-on-failure "$@"
