# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Included by generator/CMakeLists.txt: the library that reads C++ with clang.
find_package(LLVM REQUIRED CONFIG PATHS /usr/lib/llvm-19 NO_DEFAULT_PATH)
find_package(Clang REQUIRED CONFIG PATHS /usr/lib/llvm-19 NO_DEFAULT_PATH)
# Libraries that link this one live in other folders; imported targets are known per folder.
set_target_properties(clang-cpp LLVM PROPERTIES IMPORTED_GLOBAL TRUE)

# Where the package libclang-common-19-dev puts clang's own headers; looked for again when typegen runs.
set(OROFORGE_CLANG_RESOURCE_DIR ${LLVM_LIBRARY_DIR}/clang/${LLVM_VERSION_MAJOR}
  CACHE PATH "Folder of clang's builtin headers (holds include/stddef.h)")

add_library(oroforge_gen_clang STATIC
  ${CMAKE_CURRENT_LIST_DIR}/accessor_check.cpp
  ${CMAKE_CURRENT_LIST_DIR}/adapter_match.cpp
  ${CMAKE_CURRENT_LIST_DIR}/attributes.cpp
  ${CMAKE_CURRENT_LIST_DIR}/check_headers.cpp
  ${CMAKE_CURRENT_LIST_DIR}/check_type.cpp
  ${CMAKE_CURRENT_LIST_DIR}/classify.cpp
  ${CMAKE_CURRENT_LIST_DIR}/classify_standard.cpp
  ${CMAKE_CURRENT_LIST_DIR}/collect_fields.cpp
  ${CMAKE_CURRENT_LIST_DIR}/conditional_watch.cpp
  ${CMAKE_CURRENT_LIST_DIR}/component_reader.cpp
  ${CMAKE_CURRENT_LIST_DIR}/constant_text.cpp
  ${CMAKE_CURRENT_LIST_DIR}/cpp_type_text.cpp
  ${CMAKE_CURRENT_LIST_DIR}/describe_adapted.cpp
  ${CMAKE_CURRENT_LIST_DIR}/describe_component.cpp
  ${CMAKE_CURRENT_LIST_DIR}/describe_constructors.cpp
  ${CMAKE_CURRENT_LIST_DIR}/describe_type.cpp
  ${CMAKE_CURRENT_LIST_DIR}/diagnostic_bridge.cpp
  ${CMAKE_CURRENT_LIST_DIR}/doc_comment.cpp
  ${CMAKE_CURRENT_LIST_DIR}/field_forms.cpp
  ${CMAKE_CURRENT_LIST_DIR}/find_accessors.cpp
  ${CMAKE_CURRENT_LIST_DIR}/find_components.cpp
  ${CMAKE_CURRENT_LIST_DIR}/find_roots.cpp
  ${CMAKE_CURRENT_LIST_DIR}/fix_it.cpp
  ${CMAKE_CURRENT_LIST_DIR}/function_spans.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_calls.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_containers.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_interface.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_late.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_library.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_memory.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_objects.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_result.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_services.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_statements.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_texts.cpp
  ${CMAKE_CURRENT_LIST_DIR}/follow_values.cpp
  ${CMAKE_CURRENT_LIST_DIR}/header_edit.cpp
  ${CMAKE_CURRENT_LIST_DIR}/header_needs.cpp
  ${CMAKE_CURRENT_LIST_DIR}/hidden_fields.cpp
  ${CMAKE_CURRENT_LIST_DIR}/include_watch.cpp
  ${CMAKE_CURRENT_LIST_DIR}/lean_library.cpp
  ${CMAKE_CURRENT_LIST_DIR}/needed_files.cpp
  ${CMAKE_CURRENT_LIST_DIR}/registrations.cpp
  ${CMAKE_CURRENT_LIST_DIR}/parse_files.cpp
  ${CMAKE_CURRENT_LIST_DIR}/rejection.cpp
  ${CMAKE_CURRENT_LIST_DIR}/resource_dir.cpp
  ${CMAKE_CURRENT_LIST_DIR}/side_notes.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sound_types.cpp
  ${CMAKE_CURRENT_LIST_DIR}/source_run.cpp
  ${CMAKE_CURRENT_LIST_DIR}/source_places.cpp
  ${CMAKE_CURRENT_LIST_DIR}/toolchain_flags.cpp
  ${CMAKE_CURRENT_LIST_DIR}/type_names.cpp
  ${CMAKE_CURRENT_LIST_DIR}/type_reader.cpp
  ${CMAKE_CURRENT_LIST_DIR}/typekit_headers.cpp
  ${CMAKE_CURRENT_LIST_DIR}/user_class.cpp)
target_include_directories(oroforge_gen_clang SYSTEM PRIVATE ${CLANG_INCLUDE_DIRS} ${LLVM_INCLUDE_DIRS})
target_include_directories(oroforge_gen_clang PUBLIC ${PROJECT_SOURCE_DIR}/generator)
target_compile_definitions(oroforge_gen_clang PRIVATE OROFORGE_CLANG_RESOURCE_DIR="${OROFORGE_CLANG_RESOURCE_DIR}")
# Debian's LLVM is built without run-time type information, and classes here derive from its classes.
# GCC 12 sees null pointers in clang's inline functions where there are none.
target_compile_options(oroforge_gen_clang PRIVATE -fno-rtti $<$<CXX_COMPILER_ID:GNU>:-Wno-nonnull>)
# By a name without the folder of this clone, so that ccache has it for all.
target_precompile_headers(oroforge_gen_clang PRIVATE <clang/llvm_compat.hpp>)
target_link_libraries(oroforge_gen_clang PUBLIC oroforge_gen_types oroforge_gen_adapters oroforge_diag PRIVATE clang-cpp LLVM)
