# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The headers have vectors of Eigen.
find_package(Eigen3 QUIET NO_MODULE)
if(NOT Eigen3_FOUND)
  set(rtt_rosparam_FOUND FALSE)
  set(rtt_rosparam_NOT_FOUND_MESSAGE "rtt_rosparam needs Eigen; install it (Debian: libeigen3-dev)")
  return()
endif()
get_target_property(_rtt_rosparam_eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
list(APPEND rtt_rosparam_INCLUDE_DIRS ${_rtt_rosparam_eigen})
list(REMOVE_DUPLICATES rtt_rosparam_INCLUDE_DIRS)
