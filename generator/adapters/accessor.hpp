// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Parses how an adapter reaches a part of an object: "x()", "M", "data[2]", "(row, column)", "setX(value)".
#ifndef OROFORGE_GENERATOR_ADAPTERS_ACCESSOR_HPP
#define OROFORGE_GENERATOR_ADAPTERS_ACCESSOR_HPP

#include <map>
#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::adapters {

/// A step from an object to a part of it.
struct Step {
    enum class Kind { Name, Call, Index };
    Kind kind = Kind::Name;
    std::string name;                    ///< of a member
    std::vector<std::string> arguments;  ///< of a call or index: numbers, and words such as "value" and "row"
};

struct Accessor {
    std::string text;         ///< as written; empty if not given
    diag::Location where;     ///< of the text
    std::vector<Step> steps;  ///< empty if it is only a number
    std::string number;       ///< digits, or a "$variable" for digits

    bool given() const { return !text.empty(); }
    bool uses(const std::string& word) const;
};

/// `words` are arguments allowed besides numbers and variables. Malformed text gives errors TK071 and no steps.
Accessor parseAccessor(const std::string& text, const diag::Location& where, const std::vector<std::string>& words,
                       diag::Sink& sink);

/// Returns the accessor with its variables replaced.
Accessor bound(const Accessor& accessor, const std::map<std::string, std::string>& variables);

/// Returns the C++ that follows an object's name: ".x()", "[index]".
std::string cppOf(const Accessor& accessor);

}  // namespace oroforge::adapters

#endif
