// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Changes at several places of a text, collected while its parts are still where they were.
#ifndef ORO_TEXT_EDIT_HPP
#define ORO_TEXT_EDIT_HPP

#include <string>
#include <vector>

namespace RTT {
namespace marsh {

class TextEdit {
public:
    /** `text` must live until result(). */
    explicit TextEdit(const std::string& text);

    /** The bytes from `begin` up to `end` become `by`; ranges must come in order and not overlap. */
    void replace(std::size_t begin, std::size_t end, std::string by);
    void insert(std::size_t at, std::string what) { replace(at, at, std::move(what)); }
    /** With the blanks before it, up to and including the end of the line before. */
    void removeWithIndent(std::size_t begin, std::size_t end);

    /** `at`, or the place behind the last letter before it, but not before `lowest`. */
    std::size_t beforeBlanks(std::size_t at, std::size_t lowest) const;
    /** How wide the blanks are that the line begins with in which `at` is, a tab being 3; `otherwise` if there are letters
        before `at`. */
    std::size_t indentAt(std::size_t at, std::size_t otherwise) const;

    bool hasLineEnd(std::size_t begin, std::size_t end) const;

    /** What is inserted gets the line ends of the text, and is indented by tabs if the text is. */
    std::string result() const;

private:
    struct Change {
        std::size_t begin, end;
        std::string by;
    };
    void append(const std::string& inserted, std::string& made) const;

    const std::string& text_;
    const bool crLf_, tabs_;
    std::vector<Change> changes_;
};

}  // namespace marsh
}  // namespace RTT

#endif
