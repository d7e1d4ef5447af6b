# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# use_orocos([<component>…]): the runtime of this installation and the macros orocos_component() and so on, with these parts
# of it besides rtt-marshalling and rtt-scripting. find_package(rtt_ros) calls it, so that packages need not; a second call
# asks for more parts.
macro(use_orocos)
  find_package(OROCOS-RTT REQUIRED QUIET COMPONENTS rtt-marshalling rtt-scripting ${ARGN}
    HINTS ${rtt_ros_PREFIX}/lib/cmake/orocos-rtt)
  include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
endmacro()
use_orocos()
