// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Changes of texts, collected first and made together.
#ifndef OROFORGE_GENERATOR_MERGE_EDITS_HPP
#define OROFORGE_GENERATOR_MERGE_EDITS_HPP

#include <map>
#include <string>
#include <vector>

#include <model/user_code.hpp>

namespace oroforge::merge {

/// The bytes of `span` become `text`; an empty span is a place to insert at.
struct Edit {
    model::Span span;
    std::string text;
};

class Edits {
public:
    void replace(const std::string& file, model::Span span, const std::string& text);
    /// What is inserted first at a place stands first.
    void insert(const std::string& file, std::size_t at, const std::string& text);

    bool empty() const { return byFile_.empty(); }
    /// Of each file, by place.
    const std::map<std::string, std::vector<Edit>>& byFile() const { return byFile_; }

private:
    std::map<std::string, std::vector<Edit>> byFile_;
};

/// The text with all edits made. They do not overlap.
std::string applied(const std::string& text, const std::vector<Edit>& edits);

/// What the edits make, turned back into what it was made of: shows that nothing else was touched.
std::string undone(const std::string& changed, const std::string& before, const std::vector<Edit>& edits);

/// Where a place of the text before stands behind the edits.
diag::Location moved(const diag::Location& where, const std::string& before, const std::vector<Edit>& edits);

}  // namespace oroforge::merge

#endif
