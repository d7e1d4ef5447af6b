# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(encoding_bench SOURCES encoding_bench.cpp LIBS orocos-rtt orocos-rtt-encoding
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
