# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The name under which downstream packages include the macros.
include(${CMAKE_CURRENT_LIST_DIR}/UseOrocos.cmake)
