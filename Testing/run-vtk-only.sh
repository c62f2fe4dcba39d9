#!/usr/bin/env bash
# Builds the module against VTK alone (Debian's 9.1) in build-vtk/ and runs its C++ and Python tests.
# Debian's libvtk9-dev cannot be installed beside ParaView, so its files are unpacked into a prefix.
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir="$source_dir/build-vtk"
prefix="$build_dir/vtk"

. "$source_dir/CMake/install-packages.sh"
install_packages "${build_packages[@]}" libtbb-dev
if [ ! -e "$prefix/usr" ]; then
  mkdir -p "$prefix" "$build_dir/packages"
  quietly as_root apt-get update -qq
  (cd "$build_dir/packages" &&
    quietly apt-get download -qq libvtk9-dev libvtk9.1 python3-vtk9 vtk9 libvtk9-java)
  for package in "$build_dir"/packages/*.deb; do
    dpkg -x "$package" "$prefix"
  done
fi
triplet=$(gcc -dumpmachine)
export LD_LIBRARY_PATH="$prefix/usr/lib/$triplet"
export PYTHONPATH="$prefix/usr/lib/python3/dist-packages"

cmake -S "$source_dir" -B "$build_dir" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 \
  -DLMO_PARAVIEW=OFF -DVTK_DIR="$prefix/usr/lib/$triplet/cmake/vtk-9.1" \
  -DBUILD_TESTING=ON >/dev/null
cmake --build "$build_dir" -j2
ctest --test-dir "$build_dir" --output-on-failure "$@"
