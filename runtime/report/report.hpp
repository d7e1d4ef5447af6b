// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Writes what a program found, as text for its user or as JSON or SARIF 2.1.0 for tools.
#ifndef OROFORGE_REPORT_REPORT_HPP
#define OROFORGE_REPORT_REPORT_HPP

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <diag/explain.hpp>
#include <diag/sink.hpp>

namespace oroforge::report {

enum class Format { Text, Json, Sarif };

/// The code of diagnostics without one, which come from the compiler that typegen uses.
inline constexpr const char* kCompilerCode = "clang";

struct Tool {
    std::string name;
    std::string version;
    const diag::Explanations* codes = nullptr;  ///< explanations of the codes; may be null
    std::string unnamed = kCompilerCode;        ///< the code of diagnostics that have none
    std::optional<int> exitStatus = {};         ///< none: 1 if there are errors, else 0
};

/// The names that --format takes.
const std::vector<std::string>& formatNames();
std::optional<Format> formatOf(const std::string& name);

/// The last valid "--format=NAME" or "--format NAME" in a command line, whose other words may be invalid.
Format wantedFormat(const std::vector<std::string>& words);

/// Writes text to `err`, and formats for programs to `out`. False if that failed.
bool write(Format format, const Tool& tool, const diag::Sink& sink, std::ostream& out, std::ostream& err);

/// The documents, with diagnostics ordered by place and without repeats, and with a newline at the end. Paths appear as
/// they were given.
std::string jsonReport(const Tool& tool, const diag::Sink& sink);
std::string sarifReport(const Tool& tool, const diag::Sink& sink);

}  // namespace oroforge::report

#endif
