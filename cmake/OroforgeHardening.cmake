# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# oroforge_harden(): what is compiled in this directory and below defends itself against overwritten memory: tables of
# functions that cannot be written to, guarded stacks, checked copies of blocks, marked targets of jumps (CET). For what is
# installed, so not in debug builds; sanitizers look closer, and want to be alone.
option(OROFORGE_HARDENED "Optimised builds defend themselves against overwritten memory" ON)
function(oroforge_harden)
  if(OROFORGE_SANITIZE OR NOT OROFORGE_HARDENED)
    return()
  endif()
  set(optimised $<CONFIG:Release,RelWithDebInfo,MinSizeRel>)
  # As one option: CMake drops the second of two equal ones, and a target may say -U_FORTIFY_SOURCE itself.
  add_compile_options("$<${optimised}:SHELL:-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2>" $<${optimised}:-fstack-protector-strong>)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    add_compile_options($<${optimised}:-fcf-protection>)
  endif()
  add_link_options($<${optimised}:-Wl,-z,relro,-z,now>)
endfunction()
