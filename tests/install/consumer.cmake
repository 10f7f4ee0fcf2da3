# Installs into a folder of the build, builds the consumer against that and nothing else, and runs it.

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}: ${result}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/stage")
run("${CMAKE_COMMAND}" -S "${SOURCE}" -B "${WORK}/build" -G "${GENERATOR}" "-DCMAKE_PREFIX_PATH=${WORK}/stage"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_BUILD_TYPE=${CONFIG}"
    "-DEXPECTED_VERSION=${VERSION}")
run("${CMAKE_COMMAND}" --build "${WORK}/build")
run("${WORK}/build/consumer" "${WORK}/plan.gpkg")
if(NOT output STREQUAL "tracks: 10\n")
  message(FATAL_ERROR "the consumer should have planned 10 tracks; it said:\n${output}")
endif()
run("${WORK}/stage/bin/tramline" check "${WORK}/plan.gpkg")

# The lines of Python that the README shows, with the package that was installed and no other.
if(PYTHON)
  file(GLOB package "${WORK}/stage/lib/python*/*-packages")
  file(COPY "${ROOT}/examples" DESTINATION "${WORK}/python")
  execute_process(COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${package}"
                          "${PYTHON}" -B "${CMAKE_CURRENT_LIST_DIR}/readme_lines.py" "${ROOT}/README.md"
                  WORKING_DIRECTORY "${WORK}/python" COMMAND_ERROR_IS_FATAL ANY)
endif()
