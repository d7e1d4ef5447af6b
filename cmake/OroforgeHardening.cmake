# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# oroforge_harden(): protects code of this directory and below against overwritten memory: read-only tables of functions,
# guarded stacks, checked copies of blocks, marked jump targets (CET). Only for code that is installed, so not in debug builds,
# and not with sanitizers, which find more and do not work together with it.
option(OROFORGE_HARDENED "Optimised builds defend themselves against overwritten memory" ON)
function(oroforge_harden)
  if(OROFORGE_SANITIZE OR NOT OROFORGE_HARDENED)
    return()
  endif()
  set(optimised $<CONFIG:Release,RelWithDebInfo,MinSizeRel>)
  # As one option, because CMake drops the second of two equal ones, and a target may have -U_FORTIFY_SOURCE itself.
  add_compile_options("$<${optimised}:SHELL:-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2>" $<${optimised}:-fstack-protector-strong>)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    add_compile_options($<${optimised}:-fcf-protection>)
  endif()
  add_link_options($<${optimised}:-Wl,-z,relro,-z,now>)
endfunction()
