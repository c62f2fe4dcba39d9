# Sourced by run.sh and run-on.sh: installs what all tests with ParaView need.
. "$(dirname "${BASH_SOURCE[0]}")/../CMake/install-packages.sh"
install_build_packages "${display_packages[@]}" "${test_packages[@]}" "${parallel_packages[@]}"
install_if_available python3-pyvista
