# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Reporters: components that write down what others send.
oroforge_component_library(reporting
  reporting/ConsoleReporting.cpp
  reporting/FileReporting.cpp
  reporting/ReportingComponent.cpp
  reporting/TcpReporting.cpp
  reporting/columns.cpp
  reporting/components.cpp
  reporting/fields.cpp
  reporting/frame_text.cpp
  reporting/leaf_kinds.cpp
  reporting/other_value.cpp
  reporting/record_queue.cpp
  reporting/record_ring.cpp
  reporting/report_entries.cpp
  reporting/report_file.cpp
  reporting/row_text.cpp
  reporting/row_writer.cpp
  reporting/running_report.cpp
  reporting/screen.cpp
  reporting/source.cpp
  reporting/tcp_client.cpp
  reporting/tcp_listener.cpp
  reporting/tcp_server.cpp
  reporting/tcp_session.cpp
  reporting/text_sink.cpp
  reporting/text_target.cpp
  reporting/value_tree.cpp)
target_link_libraries(orocos-ocl-reporting PRIVATE $<BUILD_INTERFACE:oroforge_diag>)
oroforge_precompile(orocos-ocl-reporting <rtt/TaskContext.hpp>)
