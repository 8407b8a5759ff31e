# Makes the two files, compiles them with PROGRAM as a user would, without exceptions and RTTI, and
# runs the result.
include(${SOURCE}/cmake/amalgamate.cmake)
set(binary ${OUTPUT}/program)
if(RUNNER)
  string(APPEND binary .js)
endif()
execute_process(COMMAND ${COMPILER} -std=c++20 ${FLAGS} -fno-exceptions -fno-rtti -Wall -Wextra -Werror
  -I ${OUTPUT} ${OUTPUT}/${NAME}.cpp ${PROGRAM} -o ${binary} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${RUNNER} ${binary} COMMAND_ERROR_IS_FATAL ANY)
