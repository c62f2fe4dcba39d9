#!/usr/bin/env bash
# Makes a bare Debian system in a folder and runs both commands of the README in it as a new user
# would, on what is committed here:
#   bash Testing/run-on.sh SYSTEM [CTEST_ARGUMENT...]
#   SYSTEM  a release of Debian: trixie, bookworm, forky, stable, testing ...
#   LMO_SYSTEMS=DIR  folder where the systems are kept for the next time (default: build-on)
#   LMO_TARGETS=T... as for run.sh
#   LMO_PREPARE=1    makes the system and installs the packages, and leaves the rest for later
# The picture that the first command made is left in build-on/SYSTEM.png.
set -euo pipefail
if [ $# -eq 0 ]; then
  sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0"
  exit 2
fi
system=$1
shift
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
project=/project # in the system
root="${LMO_SYSTEMS:-$source_dir/build-on}/$system"

. "$source_dir/CMake/install-packages.sh"
install_packages debootstrap git util-linux

if [ ! -e "$root/etc/debian_version" ] || [ -e "$root/debootstrap" ]; then
  as_root rm -rf "$root"
  mkdir -p "$root"
  # The script of Debian's unstable release makes all releases, those too that this system's
  # debootstrap has no name for.
  quietly as_root debootstrap --variant=minbase "$system" "$root" "" sid
  # Nothing is lost with a system that is made in minutes.
  echo force-unsafe-io | as_root tee "$root/etc/dpkg/dpkg.cfg.d/unsafe-io" >/dev/null
  # A mirror that is not up to date serves as well.
  echo 'Acquire::Check-Valid-Until "false";' |
    as_root tee "$root/etc/apt/apt.conf.d/no-expiry" >/dev/null
fi

# in_system COMMAND...: in the system, with nothing of this one's environment.
in_system() {
  as_root unshare --mount --pid --fork bash -c '
    set -e
    root=$1
    shift
    mount -t proc proc "$root/proc"
    mount -t sysfs sysfs "$root/sys"
    mount -t tmpfs tmpfs "$root/dev/shm"
    # Not by exec: the first process of a namespace takes no signals, which xvfb-run waits for.
    chroot "$root" env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"
    exit $?
  ' - "$root" "$@"
}

as_root rm -rf "$root$project"
as_root git clone -q "file://$source_dir" "$root$project"
as_root mkdir -p "$root/dev/shm"

if [ -n "${LMO_PREPARE:-}" ]; then
  in_system bash -c "cd $project && . Testing/install-test-packages.sh"
  exit
fi

echo "--- $system: bash Examples/optimize.sh --output optimized.vtp --image optimized.png"
in_system bash -c "cd $project && bash Examples/optimize.sh --output optimized.vtp --image optimized.png"
mkdir -p "$source_dir/build-on"
cp "$root$project/optimized.png" "$source_dir/build-on/$system.png"
echo "--- $system: bash Testing/run.sh $*"
in_system env LMO_TARGETS="${LMO_TARGETS:-}" bash -c "cd $project && exec bash Testing/run.sh \"\$@\"" - "$@"
