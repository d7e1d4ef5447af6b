# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(port_bench SOURCES port_bench.cpp LIBS orocos-rtt)
oroforge_add_bench(event_port_bench SOURCES event_port_bench.cpp LIBS orocos-rtt)
oroforge_add_bench(footprint_bench SOURCES footprint_bench.cpp LIBS orocos-rtt)
