# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
if(TARGET orocos-ocl-logging)
  oroforge_add_bench(category_bench SOURCES category_bench.cpp LIBS orocos-ocl-logging)
endif()
