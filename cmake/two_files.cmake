# The target wellspaced_two_files: the library, and its kernel alone, as two files each.

# layer_files(RESULT LAYERS...): the sources of those layers, in the order of their lists.
function(layer_files result)
  set(files "")
  foreach(layer IN LISTS ARGN)
    get_target_property(sources wellspaced_${layer} SOURCES)
    get_target_property(folder wellspaced_${layer} SOURCE_DIR)
    foreach(source IN LISTS sources)
      cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder})
      list(APPEND files ${source})
    endforeach()
  endforeach()
  set(${result} ${files} PARENT_SCOPE)
endfunction()

layer_files(kernel_files kernel)
layer_files(all_files kernel algorithms io)
list(APPEND all_files ${PROJECT_SOURCE_DIR}/io/c/wellspaced_c.cpp)
set(amalgamate ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D OUTPUT=${PROJECT_BINARY_DIR}/two_files)
add_custom_target(wellspaced_two_files
  COMMAND ${amalgamate} -D NAME=wellspaced_kernel "-DFILES=${kernel_files}"
    -P ${PROJECT_SOURCE_DIR}/cmake/amalgamate.cmake
  COMMAND ${amalgamate} -D NAME=wellspaced "-DFILES=${all_files}"
    -P ${PROJECT_SOURCE_DIR}/cmake/amalgamate.cmake
  DEPENDS ${report_templates}
  VERBATIM)
