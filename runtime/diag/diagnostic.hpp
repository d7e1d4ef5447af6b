// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// A diagnostic about user input: place, severity, message, notes and fixes.
#ifndef OROFORGE_DIAG_DIAGNOSTIC_HPP
#define OROFORGE_DIAG_DIAGNOSTIC_HPP

#include <string>
#include <utility>
#include <vector>

#include <diag/shared_text.hpp>

namespace oroforge::diag {

/// All places in a file share its name.
using FileName = SharedText;

/// A place in a text. Lines and columns count from 1, columns in bytes; 0 means unknown.
/// `file` may also name a program, for errors in its command line.
struct Location {
    FileName file;
    unsigned line = 0;
    unsigned column = 0;
};

bool operator==(const Location& a, const Location& b);
inline bool operator!=(const Location& a, const Location& b) { return !(a == b); }

/// By file, line, column.
bool operator<(const Location& a, const Location& b);

enum class Severity { Error, Warning, Note };

/// One change of a text: `replacement` takes the place of the bytes from `begin` up to, but not including, `end`, in
/// the file of `begin`. If both are equal, it is inserted.
struct Fix {
    Location begin;
    Location end;
    std::string replacement;
};

bool operator==(const Fix& a, const Fix& b);

/// A second place that explains a diagnostic ("first given here").
struct Note {
    Location where;
    std::string message;
    std::vector<Fix> fixes = {};  ///< a possible repair, which the user may choose
};

struct Diagnostic {
    Severity severity = Severity::Error;
    std::string code;  ///< for example "OM003"; empty if the message has none
    Location where;
    std::string message;  ///< lower case, no final full stop
    std::vector<Note> notes = {};
    std::vector<Fix> fixes = {};  ///< together, the one repair that the user can have meant

    /// Adds a note and returns *this, so that notes can be chained.
    Diagnostic& note(Location at, std::string text) {
        notes.push_back(Note{std::move(at), std::move(text), {}});
        return *this;
    }
    /// A hint without a place of its own.
    Diagnostic& hint(std::string text) { return note(Location{}, std::move(text)); }
};

}  // namespace oroforge::diag

#endif
