# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The headers have vectors of Eigen.
find_package(Eigen3 REQUIRED QUIET NO_MODULE)
get_target_property(_rtt_rosparam_eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
list(APPEND rtt_rosparam_INCLUDE_DIRS ${_rtt_rosparam_eigen})
list(REMOVE_DUPLICATES rtt_rosparam_INCLUDE_DIRS)
