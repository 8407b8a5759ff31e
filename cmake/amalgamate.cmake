# Writes the library, or its kernel alone, as two files:
#   cmake -D SOURCE=<tree> -D OUTPUT=<folder> -D NAME=wellspaced -D FILES="a.cpp;b.cpp;..."
#     -P amalgamate.cmake
# NAME.hpp holds the headers that FILES include, each once and after those that it includes itself;
# NAME.cpp holds FILES. Both are plain concatenations without the includes between them.
cmake_minimum_required(VERSION 3.25)

set(project_include "#include \"wellspaced/([^\"]+)\"")
file(MAKE_DIRECTORY ${OUTPUT})
set(header ${OUTPUT}/${NAME}.hpp)
set(source ${OUTPUT}/${NAME}.cpp)
file(STRINGS ${SOURCE}/CMakeLists.txt version REGEX "^project\\(" LIMIT_COUNT 1)
string(REGEX REPLACE ".*VERSION ([0-9.]+).*" "\\1" version "${version}")
set(banner "// wellspaced ${version} in two files. Made by cmake/amalgamate.cmake; do not edit.\n")
file(READ ${SOURCE}/LICENSE licence)
string(STRIP "${licence}" licence)
string(REPLACE "\n" "\n// " licence "${licence}")
file(WRITE ${header} "${banner}//\n// ${licence}\n#pragma once\n")
file(WRITE ${source} "${banner}#include \"${NAME}.hpp\"\n")

# append(FILE TEXT TITLE): without project includes and #pragma once.
function(append file text title)
  string(REGEX REPLACE "${project_include}[^\n]*\n" "" text "${text}")
  string(REPLACE "#pragma once\n" "" text "${text}")
  file(APPEND ${file} "\n// ---- ${title}\n\n${text}")
endfunction()

# append_headers_of(TEXT): the headers that it includes, unless they are there already.
function(append_headers_of text)
  string(REGEX MATCHALL "${project_include}" includes "${text}")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "${project_include}" "\\1" path "${include}")
    get_property(done GLOBAL PROPERTY done_${path})
    if(NOT done)
      set_property(GLOBAL PROPERTY done_${path} TRUE)
      file(READ ${SOURCE}/${path} contents)
      append_headers_of("${contents}")
      append(${header} "${contents}" ${path})
    endif()
  endforeach()
endfunction()

foreach(path IN LISTS FILES)
  file(READ ${path} contents)
  append_headers_of("${contents}")
  cmake_path(GET path FILENAME title)
  append(${source} "${contents}" ${title})
endforeach()
