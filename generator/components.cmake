# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The libraries that turn a manifest into components, and the program orocreate-pkg.
find_package(CLI11 REQUIRED)

oroforge_generator_library(oroforge_gen_manifest
  SOURCES manifest/reader.cpp manifest/schema.cpp manifest/schema_text.cpp manifest/structure.cpp manifest/writer.cpp
  LIBS oroforge_gen_model oroforge_xml)
oroforge_generator_library(oroforge_gen_check
  SOURCES check/activities.cpp check/check.cpp check/duplicates.cpp check/names.cpp check/ports.cpp check/types.cpp
          check/values.cpp
  LIBS oroforge_gen_model)
oroforge_generator_library(oroforge_gen_view
  SOURCES view/component_view.cpp view/cpp_text.cpp view/interface_view.cpp view/package_view.cpp
          view/reference_view.cpp view/skeleton_view.cpp
  LIBS oroforge_gen_model oroforge_gen_emit oroforge_xml nlohmann_json::nlohmann_json)
oroforge_generator_library(oroforge_gen_merge
  SOURCES merge/argument_list.cpp merge/change_method.cpp merge/edits.cpp merge/insertion.cpp merge/method_style.cpp
          merge/new_members.cpp merge/new_methods.cpp merge/plan.cpp merge/plan_members.cpp merge/plan_methods.cpp
          merge/plan_registration.cpp merge/record.cpp merge/text_places.cpp merge/unified_diff.cpp merge/wanted.cpp
  LIBS oroforge_gen_model nlohmann_json::nlohmann_json)
oroforge_generator_library(oroforge_gen_driver
  SOURCES driver/add.cpp driver/build_file.cpp driver/compiler_words.cpp driver/create.cpp driver/describe.cpp driver/generate.cpp driver/kinds.cpp driver/manifest_types.cpp driver/options.cpp driver/package_files.cpp
          driver/new_classes.cpp driver/package_sources.cpp driver/update.cpp driver/upgrade.cpp driver/wanted_classes.cpp
  LIBS oroforge_gen_manifest oroforge_gen_check oroforge_clang_describe oroforge_clang_update oroforge_gen_merge oroforge_gen_view oroforge_gen_render oroforge_gen_emit
       oroforge_gen_explain oroforge_gen_flags oroforge_report CLI11::CLI11)
target_compile_definitions(oroforge_gen_driver PRIVATE OROFORGE_VERSION="${PROJECT_VERSION}")
oroforge_embed_templates(oroforge_gen_driver componentTemplates component package partials service)

add_executable(orocreate-pkg driver/main.cpp)
target_link_libraries(orocreate-pkg PRIVATE oroforge_gen_driver)
target_compile_definitions(orocreate-pkg PRIVATE OROFORGE_VERSION="${PROJECT_VERSION}")
set_target_properties(orocreate-pkg PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")
install(TARGETS orocreate-pkg RUNTIME DESTINATION bin COMPONENT tools)
install(FILES ${PROJECT_SOURCE_DIR}/share/component_manifest.xsd DESTINATION share/oroforge COMPONENT tools)
install(CODE "execute_process(COMMAND \${CMAKE_COMMAND} -E create_symlink orocreate-pkg
  \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin/orocreate-catkin-pkg)" COMPONENT tools)
