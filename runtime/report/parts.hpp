// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Functions that the formats for programs share.
#ifndef OROFORGE_REPORT_PARTS_HPP
#define OROFORGE_REPORT_PARTS_HPP

#include <string>

#include <diag/source_cache.hpp>
#include <report/report.hpp>

namespace oroforge::report {

const char* severityName(diag::Severity severity);
std::string codeOf(const diag::Diagnostic& diagnostic, const Tool& tool);

/// False for the place of an error in the command line, which has the name of the program instead of a file.
bool isFile(const diag::Location& where, const Tool& tool);

bool isHint(const diag::Note& note);

/// All hints, one on a line; empty if there are none.
std::string hintOf(const diag::Diagnostic& diagnostic);

/// "a%20b/c.hpp"; "file:///…" for absolute paths.
std::string uriOf(const std::string& path);

/// The column in characters instead of bytes; 0 stays 0. If the file cannot be read, the column in bytes.
unsigned characterColumn(const diag::Location& where, diag::SourceCache& sources);

}  // namespace oroforge::report

#endif
