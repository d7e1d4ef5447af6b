// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What an adapter says to reach a part of an object: "x()", "M", "data[2]", "(row, column)", "setX(value)".
#ifndef OROFORGE_GENERATOR_ADAPTERS_ACCESSOR_HPP
#define OROFORGE_GENERATOR_ADAPTERS_ACCESSOR_HPP

#include <map>
#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::adapters {

/// One step from an object to a part of it.
struct Step {
    enum class Kind { Name, Call, Index };
    Kind kind = Kind::Name;
    std::string name;                    ///< of a member
    std::vector<std::string> arguments;  ///< of a call or index: numbers, and words such as "value" and "row"
};

struct Accessor {
    std::string text;         ///< as written; empty: there is none
    diag::Location where;     ///< of the text
    std::vector<Step> steps;  ///< empty if it is only a number
    std::string number;       ///< digits, or a "$variable" that stands for them

    bool given() const { return !text.empty(); }
    bool uses(const std::string& word) const;
};

/// `words`: the arguments that there may be besides numbers and variables. Nothing but errors TK071 in the sink if the text
/// is none; the accessor has no steps then.
Accessor parseAccessor(const std::string& text, const diag::Location& where, const std::vector<std::string>& words,
                       diag::Sink& sink);

/// The accessor with its variables replaced.
Accessor bound(const Accessor& accessor, const std::map<std::string, std::string>& variables);

/// As C++ behind the name of an object: ".x()", "[index]".
std::string cppOf(const Accessor& accessor);

}  // namespace oroforge::adapters

#endif
