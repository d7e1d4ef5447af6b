# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(operation_bench SOURCES operation_bench.cpp LIBS orocos-rtt)
