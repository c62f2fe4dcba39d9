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

is_installed() {
  dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q 'ok installed'
}

# install_packages PACKAGE...: installs what is missing, on Debian and Ubuntu.
install_packages() {
  local missing=()
  local package
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  echo "Installing ${#missing[@]} packages: ${missing[*]}"
  quietly as_root apt-get update -qq
  quietly as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

# install_if_available PACKAGE...: of these, what the distribution has.
install_if_available() {
  local package
  for package in "$@"; do
    ! apt-cache show "$package" >/dev/null 2>&1 || install_packages "$package"
  done
}

# install_build_packages [PACKAGE...]: what a build against ParaView needs, and other packages.
install_build_packages() {
  install_packages "${build_packages[@]}" "$@"
  # Where ParaView stands on the distribution's VTK, paraview-dev does not ask for its headers.
  if dpkg-query -W -f='${Depends}' python3-paraview | grep -q python3-vtk9; then
    install_packages libvtk9-dev
  fi
  # The tools with which ParaView makes the client's help, of the Qt that it has.
  if [ -n "$(dependencies paraview '^libqt6')" ]; then
    install_if_available qt6-tools-dev qt6-documentation-tools xsltproc
  else
    install_if_available qttools5-dev qtxmlpatterns5-dev-tools xsltproc
  fi
}

# dependencies PACKAGE PATTERN: the packages that it depends on and whose names match.
dependencies() {
  apt-cache depends --important "$1" | sed -n 's/^ *|\{0,1\}Depends: \([^<]*\)$/\1/p' | grep "$2"
}

# unpack_vtk PREFIX: the distribution's VTK in a folder, for where it conflicts with ParaView.
unpack_vtk() {
  local downloads
  local library
  local package
  quietly as_root apt-get update -qq
  library=$(dependencies libvtk9-dev '^libvtk9\.')
  install_packages $(dependencies "$library" '^lib' | grep -v vtk9)
  downloads=$(mktemp -d)
  mkdir -p "$1"
  (cd "$downloads" && quietly apt-get download -qq libvtk9-dev $(dependencies libvtk9-dev vtk9))
  for package in "$downloads"/*.deb; do
    dpkg -x "$package" "$1"
  done
  rm -rf "$downloads"
}

# use_vtk PREFIX: makes the distribution's VTK ready to build against, unpacked in PREFIX if it is
# not installed. Sets VTK_DIR, and then LD_LIBRARY_PATH and PYTHONPATH too.
use_vtk() {
  local root=
  local libraries
  libraries=usr/lib/$(gcc -dumpmachine)
  if ! is_installed libvtk9-dev; then
    root=$1
    [ -e "$root/usr" ] || unpack_vtk "$root"
    export LD_LIBRARY_PATH="$root/$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
    export PYTHONPATH="$root/usr/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}"
  fi
  VTK_DIR=$(echo "$root/$libraries/cmake/vtk-"*)
  export VTK_DIR
}

# What a build against ParaView needs, what running it without a screen needs, and what the tests need.
tool_packages=(g++ cmake ninja-build libeigen3-dev libmetis-dev python3-dev python3-numpy)
build_packages=("${tool_packages[@]}" paraview-dev python3-paraview libopenmpi-dev
  libdouble-conversion-dev)
display_packages=(xvfb xauth libgl1-mesa-dri)
test_packages=(paraview mpi-default-bin imagemagick dpkg-dev file python3-pip python3-venv)
analysis_packages=(clang clang-format clang-tidy libclang-rt-dev)

# For surfaces over several processes; without them, the plugin works in one.
parallel_packages=(libpetsc-real-dev pkg-config)
