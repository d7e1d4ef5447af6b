# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(mqueue_bench SOURCES mqueue_bench.cpp LIBS orocos-rtt DEPENDS rtt-typekit rtt-transport-mqueue)
