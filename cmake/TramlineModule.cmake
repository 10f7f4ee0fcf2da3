# Each room of the house is one static library that links only what it may include.

set(TRAMLINE_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast
                      -Woverloaded-virtual -Wnull-dereference)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports null dereferences inside libstdc++ when it inlines deeply.
  list(REMOVE_ITEM TRAMLINE_WARNINGS -Wnull-dereference)
endif()
if(TRAMLINE_WERROR)
  list(APPEND TRAMLINE_WARNINGS -Werror)
endif()

function(tramline_compile_options target)
  target_compile_options(${target} PRIVATE ${TRAMLINE_WARNINGS})
  # The same input gives the same bytes on every compiler: no fused multiply-add behind our back.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
endfunction()

# For what spends its time in others' code, and would gain nothing from the third more that -O2 takes to compile.
# What reads command lines and writes words says -Og: a quarter less than -O1. Tests, which are compiled once for each
# time that they run, say -O0: a third less again, and less still of long sources.
function(tramline_compile_quickly target)
  cmake_parse_arguments(ARG "" "LEVEL" "" ${ARGN})
  if(NOT ARG_LEVEL)
    set(ARG_LEVEL -O1)
  endif()
  target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:${ARG_LEVEL}>")
  if(ARG_LEVEL STREQUAL -O0)
    # Checked calls of the C library need optimisation.
    target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:-U_FORTIFY_SOURCE>")
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 at -O1 takes the room that std::string + "..." has inside of the string for all there is, and at -Og
    # parts of std::regex for uninitialised.
    target_compile_options(${target} PRIVATE
      "$<$<CONFIG:Release>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-maybe-uninitialized>")
  endif()
endfunction()

include(TramlinePrecompiled)

# tramline_module(<name> [QUICKLY] [PRECOMPILED <kind>] SOURCES ... [LINKS public libraries ...] [PRIVATE_LINKS ...])
# QUICKLY: see tramline_compile_quickly(). The kind of precompiled headers is `standard` where none is named.
function(tramline_module name)
  cmake_parse_arguments(ARG "QUICKLY" "PRECOMPILED" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  if(NOT ARG_PRECOMPILED)
    set(ARG_PRECOMPILED standard)
  endif()
  add_library(tramline_${name} STATIC ${ARG_SOURCES})
  add_library(tramline::${name} ALIAS tramline_${name})
  target_include_directories(tramline_${name} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>"
                                                     "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>"
                                                     "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  target_link_libraries(tramline_${name} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  tramline_compile_options(tramline_${name})
  if(ARG_QUICKLY)
    tramline_compile_quickly(tramline_${name})
  endif()
  tramline_use_precompiled(tramline_${name} ${ARG_PRECOMPILED})
  set_target_properties(tramline_${name} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS tramline_${name} EXPORT tramlineTargets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  set_property(GLOBAL APPEND PROPERTY TRAMLINE_MODULES tramline_${name})
endfunction()
