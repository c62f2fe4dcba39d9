# The environment script, the CMake package and the Debian package.
function (lmo_write_environment file path_to_root)
  set(LMO_PATH_TO_ROOT "${path_to_root}")
  set(LMO_LIBRARY_DIR "${CMAKE_INSTALL_LIBDIR}")
  set(LMO_PYTHON_DIR "${lmo_python_dir}")
  set(LMO_PLUGIN_DIR "${lmo_plugin_dir}")
  configure_file("${PROJECT_SOURCE_DIR}/CMake/setup-env.sh.in" "${file}" @ONLY)
endfunction ()
lmo_write_environment("${PROJECT_BINARY_DIR}/setup-env.sh" ".")
lmo_write_environment("${PROJECT_BINARY_DIR}/CMakeFiles/installed/setup-env.sh" "../..")
install(FILES "${PROJECT_BINARY_DIR}/CMakeFiles/installed/setup-env.sh"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/LaplacianMesh")

# --- The CMake package -------------------------------------------------------------------------
configure_package_config_file(CMake/LaplacianMeshConfig.cmake.in
  "${PROJECT_BINARY_DIR}/${lmo_cmake_destination}/LaplacianMeshConfig.cmake"
  INSTALL_DESTINATION "${lmo_cmake_destination}")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/${lmo_cmake_destination}/LaplacianMeshConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${PROJECT_BINARY_DIR}/${lmo_cmake_destination}/LaplacianMeshConfig.cmake"
    "${PROJECT_BINARY_DIR}/${lmo_cmake_destination}/LaplacianMeshConfigVersion.cmake"
    CMake/LaplacianMeshParaViewExports.cmake
  DESTINATION "${lmo_cmake_destination}")

install(FILES LICENSE CHANGELOG.md CITATION.cff DESTINATION "${CMAKE_INSTALL_DOCDIR}")
include(LaplacianMeshPackage)
