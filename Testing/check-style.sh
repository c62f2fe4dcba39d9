#!/usr/bin/env bash
# Checks the format of the C++ code and, with the compile commands of a configured build, analyses
# it; what that finds is an error.
#   bash Testing/check-style.sh [BUILD_DIR]
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

. "$source_dir/CMake/install-packages.sh"
install_packages "${analysis_packages[@]}"

cd "$source_dir"
git ls-files '*.h' '*.cxx' '*.txx' | xargs clang-format --dry-run -Werror
if [ $# -gt 0 ]; then
  git ls-files 'Filters/*.cxx' | xargs -P 2 -n 1 clang-tidy --quiet -p "$1"
fi
