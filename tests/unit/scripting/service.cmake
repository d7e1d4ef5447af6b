# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# The service "scripting" and its requester, as C++ and operations show them.
oroforge_add_test(scripting_service_test
  SOURCES service_script_test.cpp service_program_test.cpp service_machine_test.cpp service_requester_test.cpp
    service_check_test.cpp service_function_test.cpp service_peer_test.cpp service_host.cpp ../flow/log_capture.cpp
  LIBS rtt-scripting oroforge_test_support ENVIRONMENT ORO_LOGFILE=/dev/null
  DEFINITIONS RTT_TYPEKIT_FILE="$<TARGET_FILE:rtt-typekit>" RTT_SCRIPTING_FILE="$<TARGET_FILE:rtt-scripting>"
  DEPENDS rtt-typekit)
