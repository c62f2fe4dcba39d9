#!/usr/bin/env bash
# Builds the benchmark in build/ and runs all of it, which takes an hour or two; writes build/benchmark.csv and
# Documentation/benchmark.md. Installs what it needs on Debian and Ubuntu. Arguments go to the
# benchmark: bash Testing/Benchmarks/run.sh --meshes 'icosphere*' --markdown build/icosphere.md
#   --quick              only the smallest meshes; writes build/benchmark.md instead
#   LMO_REAL_MESHES=DIR  folder of real meshes that are measured too
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build_dir="$source_dir/build"

markdown="$source_dir/Documentation/benchmark.md"
arguments=()
for argument in "$@"; do
  if [ "$argument" = --quick ]; then
    markdown="$build_dir/benchmark.md"
    arguments+=(--meshes icosphere-10k,isosurface-10k)
  else
    arguments+=("$argument")
  fi
done

. "$source_dir/CMake/install-packages.sh"
install_build_packages libcgal-dev
cmake -S "$source_dir" -B "$build_dir" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 \
  -DLMO_BENCHMARKS=ON >/dev/null
cmake --build "$build_dir" -j2 --target LaplacianMeshBenchmark

machine="$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"
machine+=", $(nproc) processors, $(awk '/^MemTotal/ { printf "%.0f", $2 / 1048576 }' /proc/meminfo) GiB"
data=()
[ -z "${LMO_REAL_MESHES:-}" ] || data=(--data "$LMO_REAL_MESHES")
"$build_dir/bin/LaplacianMeshBenchmark" --machine "$machine" "${data[@]}" \
  --csv "$build_dir/benchmark.csv" --markdown "$markdown" "${arguments[@]}"
