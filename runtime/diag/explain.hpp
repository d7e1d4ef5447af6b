// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Explanations of the codes of diagnostics: embedded texts, one file for each code.
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
    std::string text;   ///< the rest; indented lines are code

    std::string firstParagraph() const;
};

struct Explainer {
    std::string name;       ///< the program that the user called
    std::string badOption;  ///< its code for an invalid command line; may be empty
};

/// The explanations of one program.
class Explanations {
public:
    explicit Explanations(const EmbeddedFiles& files);

    /// All explanations, ordered by code.
    const std::vector<Explanation>& all() const { return all_; }

    /// The explanation of a code, whose case does not matter; null if there is none.
    const Explanation* of(const std::string& code) const;

    /// Carries out --explain of `program`: prints the texts of these codes, or a list of all if no code is given.
    /// Unknown codes are errors.
    void print(const std::vector<std::string>& codes, const Explainer& program, std::ostream& out, Sink& sink) const;

private:
    std::vector<Explanation> all_;
};

}  // namespace oroforge::diag

#endif
