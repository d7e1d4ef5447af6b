// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Collects changes at several places of a text and then applies them; places refer to the unchanged text.
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

    /** Replaces the bytes from `begin` up to `end` with `by`; ranges must come in order and not overlap. */
    void replace(std::size_t begin, std::size_t end, std::string by);
    void insert(std::size_t at, std::string what) { replace(at, at, std::move(what)); }
    /** Removes the bytes, the blanks before them and the preceding line end. */
    void removeWithIndent(std::size_t begin, std::size_t end);

    /** The first of the blanks that end at `at`, but not before `lowest`. */
    std::size_t beforeBlanks(std::size_t at, std::size_t lowest) const;
    /** The indentation of the line at `at`, where a tab counts 3; `otherwise` if the line has letters before `at`. */
    std::size_t indentAt(std::size_t at, std::size_t otherwise) const;

    bool hasLineEnd(std::size_t begin, std::size_t end) const;

    /** The changed text. Insertions get the line ends of the text, and tabs if it is indented by tabs. */
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
