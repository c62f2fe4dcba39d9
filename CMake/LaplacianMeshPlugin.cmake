# The ParaView plugin. Sets lmo_plugin_dir, its place below the prefix.
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
