# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(property_bench SOURCES property_bench.cpp LIBS rtt-marshalling
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
