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
include(LaplacianMeshPetsc)

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

include(LaplacianMeshPython)
include(LaplacianMeshPlugin)
include(LaplacianMeshInstall)
include(LaplacianMeshTests)
