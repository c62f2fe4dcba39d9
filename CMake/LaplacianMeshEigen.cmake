# Eigen, 3.4 or later: a version range does not do, as Eigen's version file accepts one major
# version only. Not vtk_module_find_package(): VTK's own FindEigen3.cmake makes Eigen3::Eigen3, the
# package's config file makes Eigen3::Eigen.
find_package(Eigen3 REQUIRED NO_MODULE)
if (Eigen3_VERSION VERSION_LESS 3.4)
  message(FATAL_ERROR "Eigen ${Eigen3_VERSION} was found in ${Eigen3_DIR}, but 3.4 or later is needed.")
endif ()
