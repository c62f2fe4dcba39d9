# The Python package. Sets lmo_python_dir, its place below the prefix, and LMO_PYTHON_DESTINATION.
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
