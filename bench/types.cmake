# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Loading a large typekit: typegen makes it of the header that typegen_bench.py measures typegen with.
if(OROFORGE_BUILD_TOOLS)
  set(dir ${PROJECT_BINARY_DIR}/bench/measured)
  set(header ${dir}/include/measured/measured.hpp)
  set(sources ${dir}/Plugin.cpp)
  foreach(i RANGE 1 16)
    list(APPEND sources ${dir}/types_measured_${i}.cpp)
  endforeach()
  add_custom_command(OUTPUT ${sources}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${dir}/include/measured
    COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/typegen_bench.py --header 200 > ${header}
    COMMAND typegen -o ${dir} --pieces=${header}=16 measured ${header}
    DEPENDS typegen typegen_bench.py
    VERBATIM)
  add_library(measured-typekit MODULE EXCLUDE_FROM_ALL ${sources})
  target_include_directories(measured-typekit PRIVATE ${dir} ${dir}/include)
  target_link_libraries(measured-typekit PRIVATE orocos-rtt)
  target_link_options(measured-typekit PRIVATE -Wl,-Bsymbolic)  # as orocos_typegen_headers() does
  set_target_properties(measured-typekit PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${dir}/types)
  oroforge_add_bench(typekit_import_bench SOURCES typekit_import_bench.cpp LIBS orocos-rtt
    DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" MEASURED_TYPEKIT_FILE="$<TARGET_FILE:measured-typekit>"
    DEPENDS rtt-typekit measured-typekit)
endif()
