# Installs what the browser test needs: Node.js, npm and Chromium by apt-get where they are missing
# and that is possible, and playwright-core by npm into the folder NODE_FOLDER.
#   cmake -DSOURCE_DIR=<this folder> -DNODE_FOLDER=<folder> -P install.cmake
foreach(program node npm chromium)
  find_program(${program}_path ${program} NO_CACHE)
  if(NOT ${program}_path)
    list(APPEND missing ${program})
  endif()
endforeach()

if(missing)
  message(STATUS "not found: ${missing}; trying apt-get")
  execute_process(COMMAND apt-get update)
  execute_process(COMMAND apt-get install -y --no-install-recommends nodejs npm chromium
    RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "install Node.js, npm and Chromium, then run this test again")
  endif()
endif()

file(MAKE_DIRECTORY ${NODE_FOLDER})
file(COPY ${SOURCE_DIR}/package.json ${SOURCE_DIR}/package-lock.json DESTINATION ${NODE_FOLDER})
find_program(npm npm REQUIRED NO_CACHE)
execute_process(COMMAND ${npm} ci --no-audit --no-fund WORKING_DIRECTORY ${NODE_FOLDER}
  COMMAND_ERROR_IS_FATAL ANY)
