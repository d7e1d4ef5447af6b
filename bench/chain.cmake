# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(chain_bench SOURCES chain_bench.cpp LIBS orocos-ocl-common)
