# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_test(script_compiler_test
  SOURCES script_arithmetic_test.cpp script_call_test.cpp script_expression_test.cpp script_send_test.cpp
    script_statement_test.cpp script_names_test.cpp script_alias_test.cpp script_order_test.cpp
    script_small_number_test.cpp script_port_sample_test.cpp script_enum_test.cpp
  LIBS rtt-scripting oroforge_diag
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>"
  DEPENDS rtt-typekit)
