# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The deployer of several processes, and its programs.
if(NOT TARGET orocos-rtt-corba)
  return()
endif()

add_library(orocos-ocl-deployment-corba SHARED deployment/CorbaDeploymentComponent.cpp)
target_link_libraries(orocos-ocl-deployment-corba PUBLIC orocos-ocl-deployment orocos-rtt-corba)
set_target_properties(orocos-ocl-deployment-corba PROPERTIES
  OUTPUT_NAME orocos-ocl-deployment-corba-${OROCOS_TARGET} VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  INSTALL_RPATH "$ORIGIN;$ORIGIN/orocos/${OROCOS_TARGET}/plugins")

add_library(oroforge_corba_program OBJECT bin/corba_program.cpp)
target_link_libraries(oroforge_corba_program PUBLIC oroforge_deployer_program orocos-ocl-deployment-corba)

foreach(program cdeployer deployer-corba rttscript-corba)
  string(REPLACE - _ source ${program})
  oroforge_target_program(${program} bin/${source}.cpp)
  target_link_libraries(${program} PRIVATE oroforge_corba_program oroforge_deployer_program)
endforeach()
oroforge_target_program(ctaskbrowser bin/ctaskbrowser.cpp)
target_link_libraries(deployer-corba PRIVATE oroforge_console_stay orocos-ocl-taskbrowser)
target_link_libraries(ctaskbrowser PRIVATE orocos-ocl-taskbrowser orocos-rtt-corba)
