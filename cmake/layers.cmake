# One static library per layer. A layer's folder appears under
# <build>/include/wellspaced/ as a link, so that the include line is
# "wellspaced/kernel/..." inside the tree, by add_subdirectory and installed.
set(WELLSPACED_INCLUDE_DIR ${CMAKE_CURRENT_BINARY_DIR}/include)

# wellspaced_private_options(TARGET): what our own sources are compiled with.
# -ffp-contract=off: the same bits come out with and without FMA hardware.
function(wellspaced_private_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wshadow
    $<$<BOOL:${WELLSPACED_WERROR}>:-Werror>)
endfunction()

# wellspaced_compile_as_one(TARGET): its sources as one file, so that headers and instantiations are
# compiled once (-DCMAKE_UNITY_BUILD=OFF: one by one, better for edit and build, and on many cores);
# it waits for no library.
function(wellspaced_compile_as_one target)
  if(NOT DEFINED CMAKE_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
  set_target_properties(${target} PROPERTIES OPTIMIZE_DEPENDENCIES ON)
  # gcc collects its garbage as if memory were scarce; seldomer, a large file compiles a twelfth faster.
  target_compile_options(${target} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-expand=200 --param ggc-min-heapsize=300000>")
endfunction()

# wellspaced_layer(NAME SOURCES ... DEPENDS ...): the library wellspaced::NAME.
function(wellspaced_layer name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  file(MAKE_DIRECTORY ${WELLSPACED_INCLUDE_DIR}/wellspaced)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${WELLSPACED_INCLUDE_DIR}/wellspaced/${name}
    SYMBOLIC COPY_ON_ERROR)
  add_library(wellspaced_${name} STATIC ${ARG_SOURCES})
  add_library(wellspaced::${name} ALIAS wellspaced_${name})
  set_target_properties(wellspaced_${name} PROPERTIES EXPORT_NAME ${name}
    POSITION_INDEPENDENT_CODE ON)
  wellspaced_compile_as_one(wellspaced_${name})
  wellspaced_private_options(wellspaced_${name})
  target_include_directories(wellspaced_${name} PUBLIC
    $<BUILD_INTERFACE:${WELLSPACED_INCLUDE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(wellspaced_${name} PUBLIC ${ARG_DEPENDS})
endfunction()
