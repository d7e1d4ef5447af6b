// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds places for new code in a class or beside its definitions.
#ifndef OROFORGE_GENERATOR_MERGE_INSERTION_HPP
#define OROFORGE_GENERATOR_MERGE_INSERTION_HPP

#include <string>
#include <vector>

#include <merge/edits.hpp>
#include <model/user_code.hpp>

namespace oroforge::merge {

struct Place {
    std::string file;
    std::size_t at = 0;
    const model::UserFunction* near = nullptr;  ///< the function before the place
    bool known = false;
};

/// An item that new code may follow.
struct Neighbour {
    std::string file;
    model::Span whole;
    model::Span scope;  ///< the new code must stay inside
    const model::UserFunction* function = nullptr;
};

Neighbour neighbour(const model::UserFunction& function);

/// Returns the place after the first neighbour outside #if … #endif; if all are inside, after the #endif of the first
/// one. Conditional lines that hold all definitions of the class in a file, or the scope itself, do not count.
Place placeBehind(const std::vector<Neighbour>& neighbours, const model::UserClass& type, const model::UserCode& code);

/// Inserts whole lines at a place, which may be inside a line.
void insertLines(Edits& edits, const std::string& text, const std::string& file, std::size_t at,
                 const std::string& lines, const std::string& lineEnd, bool blankAbove);

/// True if lines inside `scope` that the compiler skipped contain the name.
bool skippedLinesMention(const model::UserCode& code, const std::string& file, model::Span scope,
                         const std::string& name);

}  // namespace oroforge::merge

#endif
