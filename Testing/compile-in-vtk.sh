#!/usr/bin/env bash
# Compiles the module as a part of VTK's own build, with the warnings on; a warning is an error.
#   bash Testing/compile-in-vtk.sh VTK_SOURCE
#   VTK_SOURCE  folder of VTK's sources; what is committed here is copied into its Remote/
# Only the module is compiled, in build-in-vtk/, which takes minutes; its libraries are not linked.
set -euo pipefail
if [ $# -ne 1 ] || [ ! -d "$1/Remote" ]; then
  sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0"
  exit 2
fi
vtk_dir=$(cd "$1" && pwd)
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir="$source_dir/build-in-vtk"

. "$source_dir/CMake/install-packages.sh"
install_packages "${tool_packages[@]}"

copy="$vtk_dir/Remote/LaplacianMesh"
rm -rf "$copy"
mkdir "$copy"
trap 'rm -rf "$copy"' EXIT
git -C "$source_dir" archive HEAD Filters Testing CMake CMakeLists.txt vtk.module | tar -x -C "$copy"

cmake -S "$vtk_dir" -B "$build_dir" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror' -DVTK_DEBUG_LEAKS=OFF -DVTK_BUILD_TESTING=OFF \
  -DVTK_GROUP_ENABLE_StandAlone=DONT_WANT -DVTK_GROUP_ENABLE_Rendering=DONT_WANT \
  -DVTK_MODULE_ENABLE_VTK_FiltersLaplacianMesh=YES \
  -DVTK_MODULE_ENABLE_VTK_FiltersLaplacianMeshParallel=NO >/dev/null

# The headers that VTK generates are there now, so its libraries need not be built first.
python3 - "$build_dir/compile_commands.json" "$copy/Filters/" <<'PYTHON'
import concurrent.futures
import json
import os
import shlex
import subprocess
import sys

commands, folder = sys.argv[1:]
units = [unit for unit in json.load(open(commands)) if unit["file"].startswith(folder)]


def compiles(unit):
    command = shlex.split(unit["command"])
    command[command.index("-o") + 1] = os.devnull
    return subprocess.run(command, cwd=unit["directory"]).returncode == 0


with concurrent.futures.ThreadPoolExecutor(2) as pool:
    good = sum(pool.map(compiles, units))
print(f"{good} of {len(units)} files of the module compile in VTK without a warning.")
sys.exit(good < len(units) or not units)
PYTHON
