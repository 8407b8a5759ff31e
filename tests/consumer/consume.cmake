# cmake -D SOURCE=... -D WORK=... -D BUILD=... -D HOW=installed|subdirectory -P consume.cmake
# Extracts the README's first C++ program and its output, builds the program as a consumer would,
# runs it, and compares.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()

# The text between the first line "```${language}" and the line "```" that ends it.
function(code_block language variable)
  file(READ ${SOURCE}/README.md text)
  string(FIND "${text}" "```${language}\n" begin)
  if(begin EQUAL -1)
    message(FATAL_ERROR "README.md has no block of ${language}")
  endif()
  string(LENGTH "```${language}\n" skip)
  math(EXPR begin "${begin} + ${skip}")
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(FIND "${text}" "```" end)
  string(SUBSTRING "${text}" 0 ${end} text)
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
code_block(cpp program)
code_block(output expected)
file(WRITE ${WORK}/readme.cpp "${program}")

set(arguments -S ${SOURCE}/tests/consumer -B ${WORK}/build -D CMAKE_BUILD_TYPE=Release
  -D CONSUMER_SOURCE=${WORK}/readme.cpp)
if(HOW STREQUAL "installed")
  run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
  list(APPEND arguments -D CONSUMER_LAYER=wellspaced -D CMAKE_PREFIX_PATH=${WORK}/prefix)
else()
  list(APPEND arguments -D CONSUMER_LAYER=algorithms -D WELLSPACED_SOURCE=${SOURCE})
endif()
run(${CMAKE_COMMAND} ${arguments})
run(${CMAKE_COMMAND} --build ${WORK}/build --target consumer --parallel 2)
execute_process(COMMAND ${WORK}/build/consumer RESULT_VARIABLE result OUTPUT_VARIABLE printed)
if(NOT result EQUAL 0 OR NOT printed STREQUAL expected)
  message(FATAL_ERROR "The README's program exits with ${result} and prints\n${printed}"
    "instead of\n${expected}")
endif()
