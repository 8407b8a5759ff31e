# What `cmake --workflow --preset demo` shows: a wing section's mesh, coarsened by both methods. The
# tables go to the terminal; report.html and a picture of each level to the build folder.
add_custom_target(wellspaced_demo
  COMMAND wellspaced_program generate airfoil --nodes 20000 -o wing
  COMMAND wellspaced_program coarsen wing --method function,mis -o levels --format svg
  COMMAND wellspaced_program coarsen wing --method function,mis --stats full
    --report report.html --quiet
  COMMAND ${CMAKE_COMMAND} -E echo
    "Open ${PROJECT_BINARY_DIR}/report.html in a browser. Pictures: levels/function, levels/mis"
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
  VERBATIM USES_TERMINAL)
