#!/usr/bin/env bash
# Builds the module, the Python package and the plugin in build/, and runs all tests. Installs what
# it needs on Debian and Ubuntu. Arguments go to ctest: bash Testing/run.sh -R Core
#   LMO_REAL_MESHES=DIR  folder of real meshes that are measured too
#   LMO_TARGETS=T...     builds these targets only, for a choice of tests
#   LMO_UNITY_BUILD=ON   compiles each room of the sources at once
#   LMO_USE_PETSC=ON     an error if surfaces over several processes cannot be built
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir="$source_dir/build"

. "$source_dir/Testing/install-test-packages.sh"

cmake -S "$source_dir" -B "$build_dir" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 \
  -DBUILD_TESTING=ON -DLMO_USE_PETSC="${LMO_USE_PETSC:-AUTO}" \
  -DLMO_UNITY_BUILD="${LMO_UNITY_BUILD:-OFF}" -DLMO_REAL_MESHES="${LMO_REAL_MESHES:-}" >/dev/null
# shellcheck disable=SC2086
cmake --build "$build_dir" -j2 --target ${LMO_TARGETS:-all}
ctest --test-dir "$build_dir" -j2 --output-on-failure "$@"
