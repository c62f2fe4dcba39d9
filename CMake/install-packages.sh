# Sourced by the scripts.

# quietly COMMAND...: shows the command's output only if it fails.
quietly() {
  local log
  log=$(mktemp)
  if ! "$@" >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    return 1
  fi
  rm -f "$log"
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

# install_packages PACKAGE...: installs what is missing, on Debian and Ubuntu.
install_packages() {
  local missing=()
  local package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  echo "Installing ${#missing[@]} packages: ${missing[*]}"
  quietly as_root apt-get update -qq
  quietly as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

# unpack_vtk PREFIX: Debian's VTK 9.1 in a folder, as libvtk9-dev cannot be installed beside ParaView.
# Sets VTK_DIR and adds the libraries to LD_LIBRARY_PATH.
unpack_vtk() {
  local prefix=$1
  local downloads
  local package
  if [ ! -e "$prefix/usr" ]; then
    downloads=$(mktemp -d)
    mkdir -p "$prefix"
    quietly as_root apt-get update -qq
    (cd "$downloads" &&
      quietly apt-get download -qq libvtk9-dev libvtk9.1 python3-vtk9 vtk9 libvtk9-java)
    for package in "$downloads"/*.deb; do
      dpkg -x "$package" "$prefix"
    done
    rm -rf "$downloads"
  fi
  export LD_LIBRARY_PATH="$prefix/usr/lib/$(gcc -dumpmachine)${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
  export VTK_DIR="$prefix/usr/lib/$(gcc -dumpmachine)/cmake/vtk-9.1"
}

# What a build against ParaView needs, what running it without a screen needs, and what the tests need.
build_packages=(g++ cmake ninja-build libeigen3-dev libmetis-dev paraview-dev python3-paraview
  python3-dev python3-numpy libopenmpi-dev libdouble-conversion-dev)
display_packages=(xvfb xauth libgl1-mesa-dri)
test_packages=(paraview mpi-default-bin imagemagick dpkg-dev file)
analysis_packages=(clang clang-format clang-tidy libclang-rt-dev)

# For surfaces over several processes; without them, the plugin works in one.
parallel_packages=(libpetsc-real-dev pkg-config)
