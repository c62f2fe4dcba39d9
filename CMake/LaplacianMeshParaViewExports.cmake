# Debian's paraview-dev 5.13 and later names ParaView's Python modules, to which nothing here links,
# without the suffix that their files have, and find_package(ParaView) fails. For these targets, a
# directory in the variable that the export files of CMake 3.28 and later look at leaves the check
# of the file out.
#
# Does nothing for modules whose files are there, and with other CMakes.
file(GLOB lmo_exports
  "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-*/ParaViewPython*-targets-*.cmake"
  "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/paraview-*/vtk/VTKPython-targets-*.cmake")
foreach (lmo_export IN LISTS lmo_exports)
  file(STRINGS "${lmo_export}" lmo_lines REGEX "_cmake_import_check_files_for_")
  foreach (lmo_line IN LISTS lmo_lines)
    if (NOT lmo_line MATCHES "_cmake_import_check_files_for_([^ ]+) \"\\\${_IMPORT_PREFIX}([^\"]+)\"")
      continue ()
    endif ()
    if (NOT EXISTS "/usr${CMAKE_MATCH_2}")
      set("_cmake_import_check_xcframework_for_${CMAKE_MATCH_1}" "${CMAKE_CURRENT_LIST_DIR}")
    endif ()
  endforeach ()
endforeach ()
