# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
#
# cmake -D FAULTS=<file> -D SOURCE=<runtime> -D OUT=<directory> -P plant.cmake
#
# Copies sources of the runtime to OUT, with switches for planted faults. FAULTS is a script that calls
#
#   under_test(<file>…)                     the sources whose copies are compiled, relative to SOURCE
#   adapt(<file> <code> <instead>)          a change for all runs: a smaller capacity, Plain<T> around a variable
#   faulty_value(<name> <file> <code> <instead>)      a fault that the checker must find: an expression,
#   faulty_statement(<name> <file> <code> <instead>)  or statements, differ while it is switched on
#
# While all faults are switched off the copy does what the source does. <code> must occur exactly once: if the source
# has changed, the build of the test fails here. `@{` and `}@` in it enclose the part that is replaced; the rest only
# says where.
# A second fault in the same statement names what the first one put in front of it: `else { @{…}@`.
# With SOURCES_ONLY the files are only collected, in `sources`.
function(under_test)
  foreach(file ${ARGN})
    list(APPEND sources ${file})
    if(NOT SOURCES_ONLY)
      file(READ ${SOURCE}/${file} content)
      set(text_of_${file} "${content}" PARENT_SCOPE)
    endif()
  endforeach()
  set(sources ${sources} PARENT_SCOPE)
endfunction()

# `before` and `after` go around the part that is replaced; with `keep` that part stays between them.
function(_change file code before after keep)
  if(SOURCES_ONLY)
    return()
  endif()
  string(FIND "${code}" "@{" open)
  string(FIND "${code}" "}@" close)
  set(head "")
  set(part "${code}")
  set(tail "")
  if(NOT open EQUAL -1)
    string(SUBSTRING "${code}" 0 ${open} head)
    math(EXPR begin "${open} + 2")
    math(EXPR length "${close} - ${begin}")
    string(SUBSTRING "${code}" ${begin} ${length} part)
    math(EXPR begin "${close} + 2")
    string(SUBSTRING "${code}" ${begin} -1 tail)
  endif()
  set(text "${text_of_${file}}")
  string(FIND "${text}" "${head}${part}${tail}" first)
  string(FIND "${text}" "${head}${part}${tail}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "${FAULTS}: the source has changed, adapt this pattern: it is not exactly once in "
      "${file}:\n${head}${part}${tail}")
  endif()
  if(NOT keep)
    set(part "")
  endif()
  string(SUBSTRING "${text}" 0 ${first} front)
  string(LENGTH "${code}" length)
  if(NOT open EQUAL -1)
    math(EXPR length "${length} - 4")
  endif()
  math(EXPR rest "${first} + ${length}")
  string(SUBSTRING "${text}" ${rest} -1 rear)
  set(text_of_${file} "${front}${head}${before}${part}${after}${tail}${rear}" PARENT_SCOPE)
endfunction()

function(adapt file code instead)
  _change(${file} "${code}" "${instead}" "" FALSE)
  set(text_of_${file} "${text_of_${file}}" PARENT_SCOPE)
endfunction()
function(faulty_value name file code instead)
  _change(${file} "${code}" "(MODEL_FAULT(${name}) ? (${instead}) : (" "))" TRUE)
  set(text_of_${file} "${text_of_${file}}" PARENT_SCOPE)
endfunction()
function(faulty_statement name file code instead)
  _change(${file} "${code}" "{ if (MODEL_FAULT(${name})) { ${instead} } else { " "\n} }" TRUE)
  set(text_of_${file} "${text_of_${file}}" PARENT_SCOPE)
endfunction()

include(${FAULTS})

if(NOT SOURCES_ONLY)
  foreach(file ${sources})
    file(WRITE ${OUT}/${file} "${text_of_${file}}")
  endforeach()
endif()
