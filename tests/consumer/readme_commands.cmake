# cmake -D SOURCE=... -D WORK=... -D PROGRAM=... -P readme_commands.cmake
# Runs the README's lines that begin with "wellspaced" in an empty folder, one after the other.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
file(WRITE ${WORK}/domain.poly "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n")
file(WRITE ${WORK}/part.off "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
  "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")
file(STRINGS ${SOURCE}/README.md lines REGEX "^wellspaced ")
list(LENGTH lines count)
if(count LESS 5)
  message(FATAL_ERROR "README.md has only ${count} commands")
endif()
foreach(line IN LISTS lines)
  string(REGEX REPLACE "#.*" "" line "${line}")
  separate_arguments(arguments UNIX_COMMAND "${line}")
  list(POP_FRONT arguments)
  execute_process(COMMAND ${PROGRAM} ${arguments} WORKING_DIRECTORY ${WORK}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${line}\nexits with ${result}\n${output}")
  endif()
endforeach()
