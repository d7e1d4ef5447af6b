// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// How a program tells its user, or the user's tools, what it found: as text, as JSON, or as SARIF 2.1.0.
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

/// What is reported without a code comes from the compiler that typegen is built on.
inline constexpr const char* kCompilerCode = "clang";

struct Tool {
    std::string name;
    std::string version;
    const diag::Explanations* codes = nullptr;  ///< what they mean; null: it is not known
    std::string unnamed = kCompilerCode;        ///< stands for the code of what has none
    std::optional<int> exitStatus = {};         ///< none: 1 if there are errors, else 0
};

/// Names for the command line.
const std::vector<std::string>& formatNames();
std::optional<Format> formatOf(const std::string& name);

/// The last valid "--format=NAME" or "--format NAME" in a command line, which may be wrong in other places.
Format wantedFormat(const std::vector<std::string>& words);

/// Text goes to `err`, the other formats, which are for programs, to `out`. False if it could not be written.
bool write(Format format, const Tool& tool, const diag::Sink& sink, std::ostream& out, std::ostream& err);

/// The documents, ordered by place and without repeats; they end with a newline. Paths appear as they were given.
std::string jsonReport(const Tool& tool, const diag::Sink& sink);
std::string sarifReport(const Tool& tool, const diag::Sink& sink);

}  // namespace oroforge::report

#endif
