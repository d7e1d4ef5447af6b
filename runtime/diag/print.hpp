// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Writes diagnostics as a compiler does:
///
///     tank.xml:7:20: error: [OM012] port name 'level' is already used
///         <port name="level" …/>
///                    ^
///     tank.xml:6:20: note: first used here
///
/// The replacement of a fix is below the caret, and each fix has a line of its own:
///
///     types.hpp:4:5: fix-it: replace 'const char*' with 'std::string'
///
/// Unknown parts (file, line, column, code) are left out.
#ifndef OROFORGE_DIAG_PRINT_HPP
#define OROFORGE_DIAG_PRINT_HPP

#include <iosfwd>
#include <string>

#include <diag/sink.hpp>
#include <diag/source_cache.hpp>

namespace oroforge::diag {

void print(std::ostream& out, const Diagnostic& diagnostic, SourceCache& sources);

/// Prints all diagnostics, ordered by place and without repeats.
void print(std::ostream& out, const Sink& sink, SourceCache& sources);
void print(std::ostream& out, const Sink& sink);

/// "file:line:col" as far as known; empty if nothing is.
std::string toString(const Location& where);

/// One line, "error: [CODE] message" with its place in front, for logs.
std::string toString(const Diagnostic& diagnostic);

/// Flushes `out`. If something could not be written, prints a diagnostic of `program` to `err` and returns false. Call
/// it at the end of a program; nothing before it notices a full disk.
bool arrived(std::ostream& out, std::ostream& err, const std::string& program, const std::string& code = {});

}  // namespace oroforge::diag

#endif
