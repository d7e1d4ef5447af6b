# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# State machines.
set(quiet ENVIRONMENT ORO_LOGLEVEL=0 ORO_LOGFILE=/dev/null)

# The order of things, with programs and conditions that write down what is executed.
oroforge_add_test(machine_core_test LABELS unit LIBS rtt-scripting oroforge_diag ${quiet}
  SOURCES machine_command_table_test.cpp machine_command_test.cpp machine_detour_test.cpp machine_order_test.cpp
    machine_request_test.cpp)
oroforge_add_test(machine_script_test LABELS unit concurrent LIBS rtt-scripting oroforge_diag
  ENVIRONMENT ORO_LOGFILE=/dev/null
  SOURCES machine_script_test.cpp machine_failure_test.cpp machine_part_test.cpp machine_thread_test.cpp ../flow/log_capture.cpp
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
oroforge_add_test(machine_real_time_test LABELS unit LIBS rtt-scripting oroforge_diag oroforge_real_time_trap
  ENVIRONMENT ORO_LOGFILE=/dev/null
  SOURCES machine_real_time_test.cpp ../flow/log_capture.cpp
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" DEPENDS rtt-typekit)
