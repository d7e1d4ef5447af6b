# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Downstream packages include the macros by this name.
include(${CMAKE_CURRENT_LIST_DIR}/UseOrocos.cmake)
