# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Programs, and functions as operations.
oroforge_add_test(program_test LABELS unit concurrent
  SOURCES program_test.cpp program_failure_test.cpp function_test.cpp function_send_test.cpp script_bench.cpp ../flow/log_capture.cpp
  LIBS rtt-scripting oroforge_diag ENVIRONMENT ORO_LOGFILE=/dev/null
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
oroforge_add_test(program_stress_test LABELS unit concurrent TIMEOUT 300
  SOURCES program_stress_test.cpp script_bench.cpp
  LIBS rtt-scripting oroforge_diag ENVIRONMENT ORO_LOGLEVEL=0 ORO_LOGFILE=/dev/null
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
oroforge_add_test(program_real_time_test LABELS unit
  SOURCES program_real_time_test.cpp script_bench.cpp
  LIBS rtt-scripting oroforge_diag oroforge_real_time_trap ENVIRONMENT ORO_LOGLEVEL=0 ORO_LOGFILE=/dev/null
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
