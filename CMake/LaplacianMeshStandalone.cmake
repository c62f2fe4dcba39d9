# The build when this repository is the top-level project.
include(CMakeDependentOption)
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif ()

option(BUILD_SHARED_LIBS "Build shared libraries; the plugin needs them" ON)
option(LMO_PARAVIEW "Build against ParaView and its VTK, with the plugin; OFF: against VTK alone" ON)
option(LMO_BENCHMARKS "Build the benchmark; the tests build it anyway" OFF)
set(LMO_REAL_MESHES "" CACHE PATH "Folder of real meshes that the tests measure too; may be empty")

# VTK's roots set these, its module system does not.
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# --- VTK, or ParaView with its own -------------------------------------------------------------
set(lmo_vtk_components CommonCore CommonDataModel CommonExecutionModel FiltersExtraction)
set(lmo_parallel_components FiltersParallelDIY2 ParallelCore ParallelMPI)
set(lmo_testing_components
  FiltersCore FiltersModeling FiltersSources ImagingCore IOGeometry IOPLY IOXML TestingCore)
set(lmo_paraview_components
  RemotingCore RemotingClientServerStream RemotingServerManager WrapClientServer ProcessXML)
# vtk_module_install_headers() passes an empty list on, which CMake 3.31 and later warn of.
set(CMAKE_POLICY_DEFAULT_CMP0174 OLD)
if (LMO_PARAVIEW)
  include(LaplacianMeshParaViewExports)
  find_package(ParaView 5.11 REQUIRED COMPONENTS ${lmo_paraview_components})
  cmake_dependent_option(LMO_WRAP_PYTHON "Wrap the filters for Python" ON
    "PARAVIEW_USE_PYTHON" OFF)
else ()
  find_package(VTK 9.1 REQUIRED
    COMPONENTS ${lmo_vtk_components}
    OPTIONAL_COMPONENTS ${lmo_testing_components} ${lmo_parallel_components} Python WrappingPythonCore)
  cmake_dependent_option(LMO_WRAP_PYTHON "Wrap the filters for Python" ON
    "TARGET VTK::WrappingPythonCore" OFF)
endif ()

include(CTest)

# --- PETSc, for surfaces over several processes -------------------------------------------------
set(LMO_USE_PETSC "AUTO" CACHE STRING
  "Build the module for surfaces over several MPI processes: AUTO, ON or OFF")
set_property(CACHE LMO_USE_PETSC PROPERTY STRINGS AUTO ON OFF)
set(lmo_parallel OFF)
if (LMO_USE_PETSC)
  set(lmo_missing "")
  find_package(PkgConfig QUIET)
  if (PkgConfig_FOUND)
    pkg_check_modules(PETSC QUIET IMPORTED_TARGET GLOBAL PETSc)
  endif ()
  if (NOT TARGET PkgConfig::PETSC)
    string(APPEND lmo_missing " PETSc (pkg-config; libpetsc-real-dev)")
  endif ()
  if (NOT TARGET VTK::ParallelMPI OR NOT TARGET VTK::FiltersParallelDIY2)
    string(APPEND lmo_missing " VTK or ParaView with MPI")
  endif ()
  if (NOT lmo_missing)
    set(lmo_parallel ON)
  elseif (NOT LMO_USE_PETSC STREQUAL "AUTO")
    message(FATAL_ERROR "LMO_USE_PETSC is ON, but this was not found:${lmo_missing}")
  endif ()
endif ()

# The build tree has the install tree's layout.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
if (UNIX AND NOT APPLE)
  list(APPEND CMAKE_INSTALL_RPATH "$ORIGIN")
endif ()

# --- The module --------------------------------------------------------------------------------
# vtk_module_build() refuses a vtk.module in the root: its binary directory would be the root's. It
# gets a stand-in directory with a copy, which leads to the same Filters/ and Testing/.
set(lmo_module_dir "${PROJECT_BINARY_DIR}/CMakeFiles/module")
configure_file(vtk.module "${lmo_module_dir}/vtk.module" COPYONLY)
file(CONFIGURE OUTPUT "${lmo_module_dir}/CMakeLists.txt" @ONLY CONTENT
  "add_subdirectory([==[@PROJECT_SOURCE_DIR@/Filters]==] Filters)\n")
file(CONFIGURE OUTPUT "${lmo_module_dir}/Testing/CMakeLists.txt" @ONLY CONTENT
  "add_subdirectory([==[@PROJECT_SOURCE_DIR@/Testing]==] Testing)\n")

set(lmo_module_files "${lmo_module_dir}/vtk.module")
set(lmo_requested_modules VTK::FiltersLaplacianMesh)
if (lmo_parallel)
  list(APPEND lmo_module_files "${PROJECT_SOURCE_DIR}/Filters/Parallel/vtk.module")
  list(APPEND lmo_requested_modules VTK::FiltersLaplacianMeshParallel)
endif ()
vtk_module_scan(
  MODULE_FILES      ${lmo_module_files}
  REQUEST_MODULES   ${lmo_requested_modules}
  PROVIDES_MODULES  lmo_modules
  REQUIRES_MODULES  lmo_required
  HIDE_MODULES_FROM_CACHE ON
  ENABLE_TESTS      "${BUILD_TESTING}")

# Known in VTK's own build only: what the modules' headers include to register object factories.
set_property(GLOBAL PROPERTY _vtk_module_autoinit_include "\"vtkAutoInit.h\"")
set(lmo_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/LaplacianMesh")
vtk_module_build(
  MODULES             ${lmo_modules}
  PACKAGE             LaplacianMesh
  INSTALL_EXPORT      LaplacianMesh
  INSTALL_HEADERS     ON
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/LaplacianMesh"
  CMAKE_DESTINATION   "${lmo_cmake_destination}"
  VERSION             "${PROJECT_VERSION}"
  SOVERSION           "1")
vtk_module_export_find_packages(
  CMAKE_DESTINATION "${lmo_cmake_destination}"
  FILE_NAME         "LaplacianMesh-vtk-module-find-packages.cmake"
  MODULES           ${lmo_modules})

# --- Python ------------------------------------------------------------------------------------
set(lmo_python_dir "")
if (LMO_WRAP_PYTHON)
  if (NOT DEFINED LMO_PYTHON_DESTINATION)
    if (EXISTS /etc/debian_version)
      # Where Debian's python3 looks below /usr.
      set(LMO_PYTHON_DESTINATION "lib/python3/dist-packages")
    else ()
      vtk_module_python_default_destination(LMO_PYTHON_DESTINATION)
    endif ()
  endif ()
  set(lmo_python_dir "${LMO_PYTHON_DESTINATION}")
  vtk_module_wrap_python(
    MODULES             ${lmo_modules}
    TARGET              LaplacianMesh::FiltersLaplacianMeshPython
    PYTHON_PACKAGE      laplacianmesh
    MODULE_DESTINATION  "${LMO_PYTHON_DESTINATION}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    CMAKE_DESTINATION   "${lmo_cmake_destination}"
    BUILD_STATIC        OFF
    INSTALL_HEADERS     OFF)
  set(lmo_python_init "${PROJECT_BINARY_DIR}/${LMO_PYTHON_DESTINATION}/laplacianmesh/__init__.py")
  set(lmo_python_imports "from .vtkFiltersLaplacianMesh import *\n")
  if (lmo_parallel)
    string(APPEND lmo_python_imports "from .vtkFiltersLaplacianMeshParallel import *\n")
  endif ()
  file(CONFIGURE OUTPUT "${lmo_python_init}" @ONLY CONTENT
    "@lmo_python_imports@\n__version__ = '@PROJECT_VERSION@'\n")
  configure_file(Filters/Python/pyvista.py
    "${PROJECT_BINARY_DIR}/${LMO_PYTHON_DESTINATION}/laplacianmesh/pyvista.py" COPYONLY)
  install(FILES "${lmo_python_init}" Filters/Python/pyvista.py
    DESTINATION "${LMO_PYTHON_DESTINATION}/laplacianmesh")
endif ()

# --- The ParaView plugin -----------------------------------------------------------------------
set(lmo_plugin_dir "")
if (LMO_PARAVIEW)
  paraview_plugin_scan(
    PLUGIN_FILES      "${PROJECT_SOURCE_DIR}/Plugin/paraview.plugin"
    PROVIDES_PLUGINS  lmo_plugins
    REQUIRES_MODULES  lmo_plugin_required
    ENABLE_BY_DEFAULT ON
    HIDE_PLUGINS_FROM_CACHE ON)
  paraview_plugin_build(
    PLUGINS              ${lmo_plugins}
    PLUGINS_FILE_NAME    "LaplacianMeshOptimization.plugins.xml"
    RUNTIME_DESTINATION  "${CMAKE_INSTALL_BINDIR}"
    LIBRARY_DESTINATION  "${CMAKE_INSTALL_LIBDIR}"
    LIBRARY_SUBDIRECTORY "${PARAVIEW_PLUGIN_SUBDIR}")
  set(lmo_plugin_dir
    "${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}/LaplacianMeshOptimization")
  # paraview.simple.LoadPlugin() takes a file: this one has the plugin's name.
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/${lmo_plugin_dir}")
  set(lmo_plugin_link "${PROJECT_BINARY_DIR}/${lmo_plugin_dir}/LaplacianMeshOptimization")
  file(CREATE_LINK "LaplacianMeshOptimization${CMAKE_SHARED_MODULE_SUFFIX}" "${lmo_plugin_link}"
    SYMBOLIC)
  install(FILES "${lmo_plugin_link}" DESTINATION "${lmo_plugin_dir}")
endif ()

# --- The environment in which python, pvpython and LoadPlugin find what was built ----------------
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

# --- Tests that need the whole build -------------------------------------------------------------
if (BUILD_TESTING)
  add_subdirectory(Testing/Package)
  if (lmo_parallel)
    # The processes may be more than the processors: those that wait let the others run.
    find_package(MPI REQUIRED COMPONENTS C)
    set(lmo_mpirun "${MPIEXEC_EXECUTABLE}" --allow-run-as-root --oversubscribe
      --mca mpi_yield_when_idle 1)
    add_subdirectory(Testing/Parallel)
  endif ()
  if (LMO_WRAP_PYTHON)
    add_subdirectory(Testing/Python)
  endif ()
  if (LMO_PARAVIEW)
    add_subdirectory(Testing/ParaView)
  endif ()
endif ()

# --- The benchmark -------------------------------------------------------------------------------
if (LMO_BENCHMARKS OR BUILD_TESTING)
  add_subdirectory(Testing/Benchmarks)
endif ()
