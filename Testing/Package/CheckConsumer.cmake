# Installs the build into a prefix, or unpacks its Debian package, then configures, builds and runs
# a program against it.
function (run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  message("${output}")
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGV}")
  endif ()
endfunction ()

set(consumer "${WORK_DIR}/consumer")
file(REMOVE_RECURSE "${WORK_DIR}")
if (CPACK)
  set(prefix "${WORK_DIR}/unpacked/usr")
  run("${CPACK}" --config "${BUILD_DIR}/CPackConfig.cmake" -G DEB -B "${WORK_DIR}/package")
  file(GLOB package "${WORK_DIR}/package/*.deb")
  run(dpkg-deb --extract "${package}" "${WORK_DIR}/unpacked")
else ()
  set(prefix "${WORK_DIR}/prefix")
  run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
endif ()
run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${consumer}" -G "${GENERATOR}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DLaplacianMesh_DIR=${prefix}/${PACKAGE_DIR}"
  "-D${BASE_PACKAGE}_DIR=${BASE_PACKAGE_DIR}")
run("${CMAKE_COMMAND}" --build "${consumer}")
run("${consumer}/OptimizeMesh")
