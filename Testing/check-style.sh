#!/usr/bin/env bash
# Format and static analysis of the C++ code; what they find is an error.
#   bash Testing/check-style.sh BUILD_DIR    a configured build, for the compile commands
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${1:-$source_dir/build}

. "$source_dir/CMake/install-packages.sh"
install_packages "${analysis_packages[@]}"

cd "$source_dir"
git ls-files '*.h' '*.cxx' '*.txx' | xargs clang-format --dry-run -Werror
git ls-files 'Filters/*.cxx' | xargs -P 2 -n 1 clang-tidy --quiet -p "$build_dir"
