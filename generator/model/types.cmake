# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Included by generator/CMakeLists.txt: the model of user types.
add_library(oroforge_gen_types STATIC
  ${CMAKE_CURRENT_LIST_DIR}/field_access.cpp ${CMAKE_CURRENT_LIST_DIR}/shown_name.cpp
  ${CMAKE_CURRENT_LIST_DIR}/type_model.cpp)
target_include_directories(oroforge_gen_types PUBLIC ${PROJECT_SOURCE_DIR}/generator)
target_link_libraries(oroforge_gen_types PUBLIC oroforge_diag)
