# Code that can be loaded anywhere: the libraries are part of the program and of the Python module alike. Nobody replaces
# a function of theirs when they are loaded, so calls between them cost no more than in a program of its own.
add_compile_options(-fPIC -fno-semantic-interposition)

# Release builds are hardened: loader tables that are read-only from the start, guarded stacks, and checked calls of the
# C library. tests/hardening reads the program that comes of it.

option(TRAMLINE_HARDENED "Harden release builds" ON)
if(TRAMLINE_HARDENED)
  add_compile_options("$<$<CONFIG:Release>:-fstack-protector-strong;-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>")
  add_link_options("$<$<AND:$<CONFIG:Release>,$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>>:-pie>"
                   "$<$<CONFIG:Release>:-Wl,-z,relro;-Wl,-z,now>")
endif()
