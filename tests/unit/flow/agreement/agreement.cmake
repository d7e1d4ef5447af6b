# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# A table of changes, each in two versions of one header; two plugins are built with what typegen makes of these.
set(agreement_dir ${CMAKE_CURRENT_BINARY_DIR}/agreement)
set(table ${CMAKE_CURRENT_SOURCE_DIR}/agreement/changes.txt)
add_custom_command(OUTPUT ${agreement_dir}/old/changes.hpp ${agreement_dir}/new/changes.hpp ${agreement_dir}/schemas.inc
  COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/agreement/make_headers.py ${table} ${agreement_dir}
  DEPENDS ${table} ${CMAKE_CURRENT_SOURCE_DIR}/agreement/make_headers.py VERBATIM)
foreach(version old new)
  set(header ${agreement_dir}/${version}/changes.hpp)
  set(output ${agreement_dir}/${version}_typekit)
  set(types ${output}/types/changes/typekit/Types.hpp)
  add_custom_command(OUTPUT ${types}
    COMMAND typegen -I ${agreement_dir}/${version} -o ${output} changes ${header} DEPENDS typegen ${header} VERBATIM)
  add_library(agreement_${version} MODULE agreement/schemas.cpp ${types} ${agreement_dir}/schemas.inc)
  target_include_directories(agreement_${version} PRIVATE ${output}/types ${agreement_dir}/${version} ${agreement_dir})
  target_compile_options(agreement_${version} PRIVATE -O0 -g0)
  target_link_libraries(agreement_${version} PRIVATE orocos-rtt)
  set_target_properties(agreement_${version} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${agreement_dir})
endforeach()

oroforge_add_test(agreement_test
  SOURCES agreement_test.cpp
  LIBS oroforge_typekit_gen orocos-rtt ${CMAKE_DL_LIBS}
  DEFINITIONS AGREEMENT_TABLE="${table}" AGREEMENT_DIR="${agreement_dir}"
    AGREEMENT_OLD="$<TARGET_FILE:agreement_old>" AGREEMENT_NEW="$<TARGET_FILE:agreement_new>"
  DEPENDS agreement_old agreement_new)
