# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Included by generator/CMakeLists.txt: the library that reads C++ with clang.
find_package(LLVM REQUIRED CONFIG PATHS /usr/lib/llvm-19 NO_DEFAULT_PATH)
find_package(Clang REQUIRED CONFIG PATHS /usr/lib/llvm-19 NO_DEFAULT_PATH)
# Imported targets are known only in their folder, but libraries of other folders link these.
set_target_properties(clang-cpp LLVM PROPERTIES IMPORTED_GLOBAL TRUE)

# The package libclang-common-19-dev puts clang's own headers here; typegen looks for them again when it runs.
set(OROFORGE_CLANG_RESOURCE_DIR ${LLVM_LIBRARY_DIR}/clang/${LLVM_VERSION_MAJOR}
  CACHE PATH "Folder of clang's builtin headers (holds include/stddef.h)")

# Each room is a library, and a unity build: parsing clang's headers takes longer than compiling a file of the room.
function(oroforge_clang_library room)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FILES;LIBS")
  set(name oroforge_clang_${room})
  add_library(${name} STATIC)
  list(TRANSFORM arg_FILES REPLACE "(.+)" "clang/${room}/\\1.cpp" OUTPUT_VARIABLE files)
  oroforge_unit(${name} clang_${room} ${PROJECT_SOURCE_DIR}/generator ${files})
  target_include_directories(${name} SYSTEM PRIVATE ${CLANG_INCLUDE_DIRS} ${LLVM_INCLUDE_DIRS})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/generator)
  target_compile_definitions(${name} PRIVATE OROFORGE_CLANG_RESOURCE_DIR="${OROFORGE_CLANG_RESOURCE_DIR}")
  # Debian's LLVM has no run-time type information, and classes here derive from its classes.
  # GCC 12 warns of null pointers in clang's inline functions by mistake.
  target_compile_options(${name} PRIVATE -fno-rtti $<$<CXX_COMPILER_ID:GNU>:-Wno-nonnull>)
  target_link_libraries(${name} PUBLIC ${arg_LIBS} PRIVATE clang-cpp LLVM)
endfunction()

# Reads files: flags, places, messages, names of types.
oroforge_clang_library(base
  FILES check_headers diagnostic_bridge header_edit header_needs include_watch large_stack lean_library missing_header
        needed_files nesting_limit parse_files resource_dir source_places standard_include toolchain_flags type_names
  LIBS oroforge_diag)
# Describes types.
oroforge_clang_library(types
  FILES accessor_check adapter_match attributes check_type classify classify_standard collect_fields constant_text
        cpp_type_text describe_adapted describe_constructors describe_type doc_comment field_fixes field_forms
        find_accessors find_names find_roots hidden_fields leave_out rejection side_notes sound_types type_reader
  LIBS oroforge_clang_base oroforge_gen_types oroforge_gen_adapters oroforge_diag oroforge_xml)
# typegen reads no manifests, so it does not link this library.
oroforge_unit(oroforge_clang_types clang_lookup ${PROJECT_SOURCE_DIR}/generator clang/types/manifest_types.cpp)
# Finds components in sources, and follows their code. typegen links neither this library nor the next.
oroforge_clang_library(describe
  FILES activity_calls call_stack calls component_reader containers describe_component element_calls expressions
        find_components findings follow interface_calls interface_result known_objects known_types late_calls memory
        objects service_calls statements texts typekit_headers
  LIBS oroforge_clang_types)
# Finds the user's classes: which bytes of the sources are which part.
oroforge_clang_library(update
  FILES conditional_watch format_inserted function_spans registrations source_run user_class
  LIBS oroforge_clang_base)
