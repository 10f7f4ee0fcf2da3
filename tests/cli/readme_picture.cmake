# Draws the picture of `make demo` and compares it with the one in the README, byte by byte.
execute_process(
  COMMAND ${TRAMLINE} plan ${ROOT}/examples/riverside.geojson --width 3 --radius 6 --quiet --picture ${OUT}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${OUT} ${ROOT}/docs/images/riverside.png RESULT_VARIABLE differs)
if(differs)
  message(FATAL_ERROR "docs/images/riverside.png is not what make demo draws: look at ${OUT} and copy it there")
endif()
