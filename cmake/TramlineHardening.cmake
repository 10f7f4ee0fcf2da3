# Release builds are hardened: code that can be loaded anywhere, loader tables that are read-only from the start, guarded
# stacks, and checked calls of the C library. tests/hardening reads the program that comes of it.

option(TRAMLINE_HARDENED "Harden release builds" ON)
if(TRAMLINE_HARDENED)
  add_compile_options("$<$<CONFIG:Release>:-fPIE;-fstack-protector-strong;-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>")
  add_link_options("$<$<CONFIG:Release>:-pie;-Wl,-z,relro;-Wl,-z,now>")
endif()
