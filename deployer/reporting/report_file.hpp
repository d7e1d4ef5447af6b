// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPORTING_REPORT_FILE_HPP
#define OROFORGE_REPORTING_REPORT_FILE_HPP

#include <string>

namespace OCL::reporting {

/** Begins a file anew, or opens a pipe that somebody reads. Returns a descriptor that appends, or −1 with the reason if
    it cannot be opened or any process writes a report to it. */
int openReport(const std::string& name, std::string& error);

}  // namespace OCL::reporting

#endif
