# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(port_bench SOURCES port_bench.cpp LIBS orocos-rtt)
