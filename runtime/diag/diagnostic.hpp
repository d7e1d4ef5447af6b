// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What is said about user input: where, how bad, in which words.
#ifndef OROFORGE_DIAG_DIAGNOSTIC_HPP
#define OROFORGE_DIAG_DIAGNOSTIC_HPP

#include <string>
#include <utility>
#include <vector>

#include <diag/shared_text.hpp>

namespace oroforge::diag {

/// Every place in a file refers to the same name.
using FileName = SharedText;

/// A place in a text. Lines and columns count from 1, columns in bytes; 0 means unknown.
/// `file` may also name a program, for complaints about its command line.
struct Location {
    FileName file;
    unsigned line = 0;
    unsigned column = 0;
};

bool operator==(const Location& a, const Location& b);
inline bool operator!=(const Location& a, const Location& b) { return !(a == b); }

/// Order of reading: by file, line, column.
bool operator<(const Location& a, const Location& b);

enum class Severity { Error, Warning, Note };

/// One change of a text: what stands from `begin` up to, but not including, `end` becomes `replacement`. Both lie in the
/// file of `begin`; where they are equal, the replacement is inserted.
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
    std::vector<Fix> fixes = {};  ///< a way out that the user may take, or not
};

struct Diagnostic {
    Severity severity = Severity::Error;
    std::string code;  ///< for example "OM003"; empty if the message has none
    Location where;
    std::string message;  ///< lower case, no final full stop
    std::vector<Note> notes = {};
    std::vector<Fix> fixes = {};  ///< all of them together repair it, and nothing else is meant

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
