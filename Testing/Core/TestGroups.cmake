# The groups of properties of a test, which are the calls of Groups::Run (Checks.h) in its source,
# each on a line of its own that begins with the name.
function (read_test_groups source result)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
  file(STRINGS "${source}" groups REGEX "^  groups\\.Run\\(")
  list(TRANSFORM groups REPLACE "^  groups\\.Run\\(\"([A-Za-z]+)\",.*" "\\1")
  foreach (group IN LISTS groups)
    if (NOT group MATCHES "^[A-Za-z]+$")
      message(FATAL_ERROR "${source}: the name of a group stands on the line of its call: ${group}")
    endif ()
  endforeach ()
  set("${result}" "${groups}" PARENT_SCOPE)
endfunction ()
