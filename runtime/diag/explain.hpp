// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What the codes of diagnostics mean, at length: embedded texts, one file for each code.
#ifndef OROFORGE_DIAG_EXPLAIN_HPP
#define OROFORGE_DIAG_EXPLAIN_HPP

#include <diag/embedded_files.hpp>
#include <diag/sink.hpp>

#include <iosfwd>
#include <string>
#include <vector>

namespace oroforge::diag {

struct Explanation {
    std::string code;
    std::string title;  ///< the first line of the file
    std::string text;   ///< all that follows; indented lines are code

    std::string firstParagraph() const;
};

struct Explainer {
    std::string name;       ///< of the program that the user called
    std::string badOption;  ///< its code for a command line that makes no sense; may be empty
};

/// The explanations that one program has.
class Explanations {
public:
    explicit Explanations(const EmbeddedFiles& files);

    /// In the order of their codes.
    const std::vector<Explanation>& all() const { return all_; }

    /// Null if there is none. Upper and lower case are the same.
    const Explanation* of(const std::string& code) const;

    /// What the user of `program` asked for with --explain: the texts of these codes, or a list of all if there are
    /// none. Codes that do not exist are errors.
    void print(const std::vector<std::string>& codes, const Explainer& program, std::ostream& out, Sink& sink) const;

private:
    std::vector<Explanation> all_;
};

}  // namespace oroforge::diag

#endif
