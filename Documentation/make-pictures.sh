#!/usr/bin/env bash
# Makes the pictures of guide.md in Documentation/images. Installs what it needs on Debian and
# Ubuntu, and builds the module in build/ first. Takes some minutes.
#   LMO_REAL_MESHES=DIR  also prints the guide's table for these meshes
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir="$source_dir/build"
scripts="$source_dir/Documentation/scripts"
images="$source_dir/Documentation/images"

. "$source_dir/CMake/install-packages.sh"
install_build_packages "${display_packages[@]}" \
  python3-matplotlib python3-pil libcgal-dev
if [ ! -e "$build_dir/setup-env.sh" ]; then
  cmake -S "$source_dir" -B "$build_dir" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 \
    -DBUILD_TESTING=OFF >/dev/null
fi
cmake --build "$build_dir"
g++ -std=c++17 -O2 "$scripts/relax.cxx" -o "$build_dir/relax" -lmpfr -lgmp
. "$build_dir/setup-env.sh"
export PYTHONDONTWRITEBYTECODE=1

draw() {
  xvfb-run -a -s '-screen 0 1600x1200x24 -noreset' /usr/bin/python3 "$@"
}
draw "$scripts/examples.py"
draw "$scripts/parameters.py"
draw "$scripts/budget.py" --relax "$build_dir/relax"
if [ -n "${LMO_REAL_MESHES:-}" ]; then
  draw "$scripts/budget.py" --meshes "$LMO_REAL_MESHES"
fi
