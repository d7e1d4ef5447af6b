# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Private part of UseOrocos.cmake: helpers that macros of packages for the original toolchain call.

# oro_parse_arguments(prefix "KEY…" "OPTION…" word…): <prefix>_<KEY> is the list of words after each key, <prefix>_<OPTION>
# TRUE or FALSE, <prefix>_DEFAULT_ARGS the words before the first key.
macro(oro_parse_arguments prefix keys options)
  set(${prefix}_DEFAULT_ARGS "")
  foreach(_oro_key ${keys})
    set(${prefix}_${_oro_key} "")
  endforeach()
  foreach(_oro_key ${options})
    set(${prefix}_${_oro_key} FALSE)
  endforeach()
  set(_oro_current DEFAULT_ARGS)
  foreach(_oro_word ${ARGN})
    set(_oro_keys ${keys})
    set(_oro_options ${options})
    if("${_oro_word}" IN_LIST _oro_keys)
      set(_oro_current ${_oro_word})
    elseif("${_oro_word}" IN_LIST _oro_options)
      set(${prefix}_${_oro_word} TRUE)
    else()
      list(APPEND ${prefix}_${_oro_current} "${_oro_word}")
    endif()
  endforeach()
endmacro()

# _orocos_list_to_string(variable list): the words with blanks between. The list, or a variable that holds it.
function(_orocos_list_to_string result)
  set(_oro_words "${ARGN}")
  list(LENGTH _oro_words _oro_count)
  if(_oro_count EQUAL 1)
    if(DEFINED ${_oro_words})
      set(_oro_words "${${_oro_words}}")
    endif()
  endif()
  string(REPLACE ";" " " _oro_words "${_oro_words}")
  set(${result} "${_oro_words}" PARENT_SCOPE)
endfunction()
