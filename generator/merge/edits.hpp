// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Collects changes of texts, and makes them together.
#ifndef OROFORGE_GENERATOR_MERGE_EDITS_HPP
#define OROFORGE_GENERATOR_MERGE_EDITS_HPP

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <model/user_code.hpp>

namespace oroforge::merge {

/// Replaces the bytes of `span` by `text`; an empty span inserts.
struct Edit {
    model::Span span;
    std::string text;
    bool isLines = false;  ///< whole declarations, definitions or statements; any other may hold words of the user
};

/// Returns the new text of each of `inserted`, which are bytes of `text` in `file`.
using Formatter = std::function<std::vector<std::string>(const std::string& file, const std::string& text,
                                                         const std::vector<model::Span>& inserted)>;

class Edits {
public:
    void replace(const std::string& file, model::Span span, const std::string& text);
    /// Inserts lines. Insertions at the same place keep the order of the calls.
    void insert(const std::string& file, std::size_t at, const std::string& text);
    /// Formats the inserted lines where they will be. `texts` has the files before the edits.
    void format(const std::map<std::string, std::string>& texts, const Formatter& formatter);

    bool empty() const { return byFile_.empty(); }
    /// By file; sorted by place.
    const std::map<std::string, std::vector<Edit>>& byFile() const { return byFile_; }

private:
    std::map<std::string, std::vector<Edit>> byFile_;
};

/// Returns the text with all edits made. Edits must not overlap.
std::string applied(const std::string& text, const std::vector<Edit>& edits);

/// Returns the place after the edits of a place in the text before them.
diag::Location moved(const diag::Location& where, const std::string& before, const std::vector<Edit>& edits);

}  // namespace oroforge::merge

#endif
