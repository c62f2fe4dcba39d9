#!/usr/bin/env bash
# Optimises a mesh, reports what changed and makes a picture of before and after. Installs what it
# needs and builds the plugin first. See optimize.py for the work itself and its options:
#   bash Examples/optimize.sh --help
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source_dir=$(dirname "$here")
build_dir="$source_dir/build"

for argument in "$@"; do
  if [ "$argument" = --help ] || [ "$argument" = -h ]; then
    sed -n '/^"""/,/^"""/p' "$here/optimize.py" | sed 's/"""//'
    exit 0
  fi
done

. "$source_dir/CMake/install-packages.sh"
install_build_packages "${display_packages[@]}"
if [ ! -e "$build_dir/setup-env.sh" ]; then
  cmake -S "$source_dir" -B "$build_dir" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 \
    -DBUILD_TESTING=OFF >/dev/null
fi
cmake --build "$build_dir" | grep -v 'no work to do' || true
. "$build_dir/setup-env.sh"

runner=()
[ -n "${DISPLAY:-}" ] || runner=(xvfb-run -a -s '-screen 0 1600x1200x24 -noreset')
exec "${runner[@]}" pvpython "$here/optimize.py" "$@"
