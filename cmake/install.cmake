include(CMakePackageConfigHelpers)

install(TARGETS wellspaced_kernel wellspaced_algorithms wellspaced_io wellspaced_all wellspaced_c
  EXPORT wellspaced-targets)
if(TARGET wellspaced_program)
  install(TARGETS wellspaced_program)
endif()
foreach(layer kernel algorithms io)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${layer}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/wellspaced FILES_MATCHING PATTERN "*.hpp" PATTERN "wellspaced.h")
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/io/c/wellspaced.py DESTINATION ${CMAKE_INSTALL_DATADIR}/wellspaced)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/wellspaced)
install(EXPORT wellspaced-targets NAMESPACE wellspaced:: DESTINATION ${package_dir}
  FILE wellspaced-config.cmake)
write_basic_package_version_file(wellspaced-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/wellspaced-config-version.cmake
  DESTINATION ${package_dir})
