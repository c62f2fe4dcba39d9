#!/usr/bin/env bash
# Checks the format of the C++ code. With --analyse, clang-tidy looks at it too, with ParaView's
# headers; what it finds is an error.
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir="$source_dir/build/analysis"

. "$source_dir/CMake/install-packages.sh"
install_packages "${analysis_packages[@]}"

cd "$source_dir"
git ls-files '*.h' '*.cxx' '*.txx' | xargs clang-format --dry-run -Werror
if [ "${1:-}" = --analyse ]; then
  install_build_packages
  # Most of the time goes into the headers, which a unity build reads once for many sources.
  cmake -S "$source_dir" -B "$build_dir" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 \
    -DLMO_USE_PETSC="${LMO_USE_PETSC:-AUTO}" -DLMO_UNITY_BUILD=ON >/dev/null
  sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$build_dir/compile_commands.json" |
    grep -E '/Unity/unity_|^'"$source_dir"'/Filters/' | sort -u |
    xargs -P 2 -n 1 clang-tidy --quiet -p "$build_dir"
fi
