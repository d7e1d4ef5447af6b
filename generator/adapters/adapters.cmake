# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Included by generator/CMakeLists.txt: reads adapter files. Shipped ones are compiled in, and installed as examples.
oroforge_generator_library(oroforge_gen_adapters
  SOURCES adapters/accessor.cpp adapters/adapter_rules.cpp adapters/name_pattern.cpp adapters/read_adapters.cpp
  LIBS oroforge_diag oroforge_xml)
oroforge_embed_texts(oroforge_gen_adapters shippedAdapters share/adapters xml)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/share/adapters/ DESTINATION share/oroforge/adapters COMPONENT tools
        FILES_MATCHING PATTERN *.xml)
