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

cmake -S "$vtk_dir" -B "$build_dir" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror' -DVTK_DEBUG_LEAKS=OFF -DVTK_BUILD_TESTING=OFF \
  -DVTK_GROUP_ENABLE_StandAlone=DONT_WANT -DVTK_GROUP_ENABLE_Rendering=DONT_WANT \
  -DVTK_MODULE_ENABLE_VTK_FiltersLaplacianMesh=YES \
  -DVTK_MODULE_ENABLE_VTK_FiltersLaplacianMeshParallel=NO >/dev/null
objects=$(ninja -C "$build_dir" -t targets all |
  sed -n 's/^\([^:]*\(FiltersLaplacianMesh\|lmoCore\)\.dir[^:]*\.cxx\.o\):.*/\1/p')
ninja -C "$build_dir" -j2 $objects
echo "Compiled $(wc -w <<<"$objects") files of the module in VTK" \
  "$(sed -n 's/^#define VTK_VERSION_FULL "\(.*\)"/\1/p' "$build_dir"/Common/Core/vtkVersionFull.h 2>/dev/null || true)."
