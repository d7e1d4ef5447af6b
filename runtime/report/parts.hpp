// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What the formats for programs have in common.
#ifndef OROFORGE_REPORT_PARTS_HPP
#define OROFORGE_REPORT_PARTS_HPP

#include <string>

#include <diag/source_cache.hpp>
#include <report/report.hpp>

namespace oroforge::report {

const char* severityName(diag::Severity severity);
std::string codeOf(const diag::Diagnostic& diagnostic, const Tool& tool);

/// A complaint about the command line stands at the name of the program, which is no file.
bool isFile(const diag::Location& where, const Tool& tool);

bool isHint(const diag::Note& note);

/// All hints, one a line; empty if there are none.
std::string hintOf(const diag::Diagnostic& diagnostic);

/// "a%20b/c.hpp"; "file:///…" for absolute paths.
std::string uriOf(const std::string& path);

/// The column in characters instead of bytes; 0 stays 0. As it is, if the file cannot be read.
unsigned characterColumn(const diag::Location& where, diag::SourceCache& sources);

}  // namespace oroforge::report

#endif
