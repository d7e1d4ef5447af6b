// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Where something new can stand in a class or beside its definitions.
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
    const model::UserFunction* near = nullptr;  ///< what it stands behind
    bool known = false;
};

/// Something that the new thing may stand behind.
struct Neighbour {
    std::string file;
    model::Span whole;
    model::Span scope;  ///< it must not leave
    const model::UserFunction* function = nullptr;
};

Neighbour neighbour(const model::UserFunction& function);

/// Behind the first neighbour that does not stand between #if and #endif; if all do, behind the #endif of the first one.
/// Lines between #if and #endif that hold all definitions of the class in a file, or the scope itself, count as none.
Place placeBehind(const std::vector<Neighbour>& neighbours, const model::UserClass& type, const model::UserCode& code);

/// Puts whole lines at a place, which may lie inside of a line.
void insertLines(Edits& edits, const std::string& text, const std::string& file, std::size_t at,
                 const std::string& lines, const std::string& lineEnd, bool blankAbove);

/// Whether lines that the compiler skipped, inside of `scope`, have the name.
bool skippedLinesMention(const model::UserCode& code, const std::string& file, model::Span scope,
                         const std::string& name);

}  // namespace oroforge::merge

#endif
