// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_REPORT_FILE_HPP
#define ORO_OCL_REPORTING_REPORT_FILE_HPP

#include <string>

namespace OCL::reporting {

/** The text of `errno`. */
std::string systemError();

bool isRegular(int file);

/** Empties a regular file for this reporter alone, until it is closed. Returns why that fails, or nothing. */
std::string claim(int file);

/** Begins a file anew, or opens a pipe that somebody reads. Returns a descriptor that appends, or −1 with the reason if
    it cannot be opened or any process writes a report to it. */
int openReport(const std::string& name, std::string& error);

}  // namespace OCL::reporting

#endif
