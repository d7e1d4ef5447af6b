// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What the codes of diagnostics mean, at length: the texts of generator/explain/, one file for each code.
#ifndef OROFORGE_GENERATOR_REPORT_EXPLAIN_HPP
#define OROFORGE_GENERATOR_REPORT_EXPLAIN_HPP

#include <iosfwd>
#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::report {

struct Explanation {
    std::string code;
    std::string title;  ///< the first line of the file
    std::string text;   ///< all that follows; indented lines are code

    std::string firstParagraph() const;
};

/// In the order of their codes.
const std::vector<Explanation>& explanations();

/// Null if there is none. Upper and lower case are the same.
const Explanation* explanationOf(const std::string& code);

struct Explainer {
    std::string name;       ///< of the program that the user called
    std::string badOption;  ///< its code for a command line that makes no sense
};

/// What the user of `program` asked for with --explain: the texts of these codes, or a list of all if there are none.
/// Codes that do not exist are errors.
void explain(const std::vector<std::string>& codes, const Explainer& program, std::ostream& out, diag::Sink& sink);

}  // namespace oroforge::report

#endif
