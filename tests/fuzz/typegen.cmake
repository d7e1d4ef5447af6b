# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Included by CMakeLists.txt: typegen under libFuzzer, once what it reads besides C++, once all of it.
if(NOT TARGET oroforge_typekit_gen OR NOT OROFORGE_UNITS_BY_SUBJECT)
  return()
endif()
set(generator ${PROJECT_SOURCE_DIR}/generator)
set(typekit_gen ${PROJECT_SOURCE_DIR}/typekit_gen)
file(GLOB parts CONFIGURE_DEPENDS ${generator}/adapters/*.cpp ${generator}/emit/*.cpp ${generator}/flags/*.cpp
  ${generator}/model/*.cpp ${generator}/render/*.cpp ${typekit_gen}/collect/*.cpp ${typekit_gen}/diff/*.cpp
  ${typekit_gen}/driver/*.cpp ${typekit_gen}/plan/*.cpp ${runtime}/diag/*.cpp ${runtime}/report/*.cpp)
list(FILTER parts EXCLUDE REGEX "/driver/main.cpp$")
# The rooms of generator/clang that typegen links, each one unit.
set(units ${PROJECT_BINARY_DIR}/generator)
set(clang_parts ${units}/clang_base.cpp ${units}/clang_types.cpp typegen/source_check.cpp)
set(options -I${generator} -I${typekit_gen} -DOROFORGE_VERSION="fuzz")
# LLVM has no run-time type information.
get_target_property(clang_includes oroforge_clang_types INCLUDE_DIRECTORIES)
list(TRANSFORM clang_includes PREPEND -isystem)
set(clang_options ${options} -fno-rtti ${clang_includes} -Wno-everything
  -DOROFORGE_CLANG_RESOURCE_DIR="${OROFORGE_CLANG_RESOURCE_DIR}")
set(prefix ${CMAKE_CURRENT_BINARY_DIR}/typegen)
oroforge_fuzz_objects(clang_objects ${prefix} OPTIONS ${clang_options} SOURCES ${clang_parts})
oroforge_fuzz_objects(objects ${prefix} OPTIONS ${options} SOURCES ${parts} ${xml})
add_custom_command(OUTPUT ${prefix}.a
  COMMAND ${CMAKE_COMMAND} -E rm -f ${prefix}.a
  COMMAND ${CMAKE_AR} qcs ${prefix}.a ${clang_objects} ${objects}
  DEPENDS ${clang_objects} ${objects} COMMENT "Linking typegen for fuzzing" VERBATIM)

# The libraries of the build have the texts that are compiled in.
set(common DEFINITIONS ${clang_options} -DFUZZ_SMALL_STD="${CMAKE_CURRENT_SOURCE_DIR}/typegen/small_std.hpp"
  LIBS oroforge_typekit_gen oroforge_gen_adapters oroforge_gen_explain clang-cpp LLVM LINK ${prefix}.a)
oroforge_add_fuzzer(typegen_text_fuzz CORPUS typegen_text RUNS 2000 SOURCES typegen_text_fuzz.cpp ${common})
# What clang allocates for a header that is broken it does not always give back.
oroforge_add_fuzzer(typegen_fuzz CORPUS typegen RUNS 600 SOURCES typegen_fuzz.cpp ${common}
  ARGUMENTS -detect_leaks=0 -dict=${CMAKE_CURRENT_SOURCE_DIR}/typegen/words.dict)
