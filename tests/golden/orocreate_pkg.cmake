# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_test(orocreate-pkg-golden
  SOURCES orocreate_pkg_golden_test.cpp
  LIBS oroforge_test_support LABELS golden
  DEFINITIONS OROCREATE_PKG="$<TARGET_FILE:orocreate-pkg>"
  DEPENDS orocreate-pkg)

# Every component golden is compiled with more warnings than our own code, as a component library that the interface test
# of its package is linked to and that is then loaded. All sources of a library are one translation unit: the headers
# cost the same only once.
function(oroforge_add_component_golden case)
  set(files ${CMAKE_CURRENT_SOURCE_DIR}/component/${case}/expected/files)
  file(GLOB sources CONFIGURE_DEPENDS ${files}/*/src/*.cpp ${files}/generated/*/*.cpp ${files}/generated/*/services/*/*Base.cpp)
  # Each makes a library of its own: their entry points have one name.
  file(GLOB plugins CONFIGURE_DEPENDS ${files}/generated/*/services/*/registration.cpp ${files}/*/src/*-*.cpp)
  list(REMOVE_ITEM sources ${plugins})
  file(GLOB tests CONFIGURE_DEPENDS ${files}/*/tests/*.cpp)
  if(NOT sources)
    return()
  endif()
  file(GLOB packages ${files}/*/package.xml)
  list(TRANSFORM packages REPLACE "/package.xml$" "")
  get_target_property(rtt_includes orocos-rtt INTERFACE_INCLUDE_DIRECTORIES)

  set(library golden-${case})
  add_library(${library} SHARED ${sources})
  set_target_properties(${library} PROPERTIES OUTPUT_NAME ${library}-${OROCOS_TARGET}
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests/golden_components)
  target_compile_definitions(${library} PRIVATE RTT_COMPONENT)
  target_include_directories(${library} PUBLIC ${packages}/src ${packages}/include ${files}/generated)
  target_link_libraries(${library} PUBLIC orocos-rtt)
  oroforge_add_test(golden-${case}-interface NO_MAIN OWN_HEADERS SOURCES ${tests} LIBS ${library} LABELS golden)
  if(plugins)
    add_library(${library}-plugins OBJECT ${plugins})
    target_link_libraries(${library}-plugins PRIVATE ${library})
    add_dependencies(golden-${case}-interface ${library}-plugins)
    target_compile_options(${library}-plugins PRIVATE -Wall -Wextra -Wconversion -Werror)
    target_include_directories(${library}-plugins SYSTEM PRIVATE ${rtt_includes})
  endif()
  foreach(target ${library} golden-${case}-interface)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Werror)
    target_include_directories(${target} SYSTEM PRIVATE ${rtt_includes})
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endforeach()
endfunction()

if(TARGET orocos-rtt)
  file(GLOB cases CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/component ${CMAKE_CURRENT_SOURCE_DIR}/component/*)
  foreach(case IN LISTS cases)
    oroforge_add_component_golden(${case})
  endforeach()
  oroforge_add_test(golden-service-range SOURCES service_range_test.cpp LIBS golden-service_plugins LABELS golden)
  # The skeletons of all kinds compile, too; each is a plugin of its own, hence no single unit.
  set(files ${CMAKE_CURRENT_SOURCE_DIR}/package/all_kinds/expected/files/my-pkg)
  file(GLOB sources CONFIGURE_DEPENDS ${files}/src/*.cpp ${files}/tests/my-pkg*.cpp)
  get_target_property(rtt_includes orocos-rtt INTERFACE_INCLUDE_DIRECTORIES)
  add_library(golden-skeletons OBJECT ${sources})
  target_compile_options(golden-skeletons PRIVATE -Wall -Wextra -Wconversion -Werror)
  target_compile_definitions(golden-skeletons PRIVATE RTT_COMPONENT)
  target_include_directories(golden-skeletons PRIVATE ${files}/src ${files}/include)
  target_include_directories(golden-skeletons SYSTEM PRIVATE ${rtt_includes})
  target_link_libraries(golden-skeletons PRIVATE orocos-rtt GTest::gtest)

  set(libraries "")
  foreach(case IN LISTS cases)
    if(TARGET golden-${case})  # not before its expected files are written
      list(APPEND libraries golden-${case})
    endif()
  endforeach()
  oroforge_add_test(golden-component-loading SOURCES component_loading_test.cpp LIBS orocos-rtt LABELS golden
    DEFINITIONS GOLDEN_COMPONENTS="${PROJECT_BINARY_DIR}/tests/golden_components" TARGET_SUFFIX="${OROCOS_TARGET}"
    DEPENDS ${libraries})
endif()
