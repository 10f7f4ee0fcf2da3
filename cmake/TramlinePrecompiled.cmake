# The standard headers, parsed once for each kind of target instead of once for each source.
# Sources include what they use all the same: the clang preset is built without precompiled headers.

# CMake passes absolute paths that clang-tidy would look for, so only GCC gets precompiled headers unasked.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  option(TRAMLINE_PRECOMPILE "Precompile the headers that most sources include" ON)
else()
  option(TRAMLINE_PRECOMPILE "Precompile the headers that most sources include" OFF)
endif()

set(TRAMLINE_STANDARD_HEADERS <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <set>
                              <span> <string> <utility> <vector> <fmt/format.h>)

# tramline_precompiled(<kind> [LEVEL <-O>] HEADERS ... [LINKS ...]): makes the headers that
# tramline_use_precompiled(<target> <kind>) gives. LEVEL: that of the targets, where they are compiled quickly.
function(tramline_precompiled kind)
  cmake_parse_arguments(ARG "" "LEVEL" "HEADERS;LINKS" ${ARGN})
  if(NOT TRAMLINE_PRECOMPILE)
    return()
  endif()
  set(source "${CMAKE_CURRENT_BINARY_DIR}/precompiled_${kind}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "// Only its precompiled header is wanted.\n")
  add_library(precompiled_${kind} OBJECT "${source}")
  target_link_libraries(precompiled_${kind} PRIVATE fmt::fmt ${ARG_LINKS})
  tramline_compile_options(precompiled_${kind})
  if(ARG_LEVEL)
    tramline_compile_quickly(precompiled_${kind} LEVEL ${ARG_LEVEL})
  endif()
  # GCC says nothing of a precompiled header in what it preprocesses unless asked to, and ccache needs to know.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(precompiled_${kind} PRIVATE -fpch-preprocess)
  endif()
  target_precompile_headers(precompiled_${kind} PRIVATE ${ARG_HEADERS})
endfunction()

function(tramline_use_precompiled target kind)
  if(TRAMLINE_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM precompiled_${kind})
    # GCC takes a precompiled header only where the macros that fmt looks at are the same.
    target_compile_definitions(${target} PRIVATE "$<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>")
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE -fpch-preprocess)
    endif()
  endif()
endfunction()
