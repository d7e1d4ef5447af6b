// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "text_edit.hpp"

namespace RTT {
namespace marsh {

namespace {
bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
}  // namespace

TextEdit::TextEdit(const std::string& text) : text_(text) {}

void TextEdit::replace(std::size_t begin, std::size_t end, std::string by) {
    changes_.push_back(Change{begin, end, std::move(by)});
}

void TextEdit::removeWithIndent(std::size_t begin, std::size_t end) {
    std::size_t from = begin;
    while (from != 0 && (text_[from - 1] == ' ' || text_[from - 1] == '\t')) --from;
    const bool atLineBegin = from != 0 && text_[from - 1] == '\n';
    if (atLineBegin) from -= from > 1 && text_[from - 2] == '\r' ? 2 : 1;
    replace(atLineBegin ? from : begin, end, "");
}

std::size_t TextEdit::beforeBlanks(std::size_t at, std::size_t lowest) const {
    while (at > lowest && isBlank(text_[at - 1])) --at;
    return at;
}

std::size_t TextEdit::indentAt(std::size_t at, std::size_t otherwise) const {
    std::size_t begin = at;
    while (begin != 0 && (text_[begin - 1] == ' ' || text_[begin - 1] == '\t')) --begin;
    return begin == 0 || text_[begin - 1] == '\n' ? at - begin : otherwise;
}

bool TextEdit::hasLineEnd(std::size_t begin, std::size_t end) const {
    const std::size_t at = text_.find('\n', begin);
    return at != std::string::npos && at < end;
}

std::string TextEdit::result() const {
    const bool crLf = text_.find("\r\n") != std::string::npos;
    std::string made;
    std::size_t at = 0;
    for (const Change& change : changes_) {
        made.append(text_, at, change.begin - at);
        for (const char c : change.by) {
            if (c == '\n' && crLf) made += '\r';
            made += c;
        }
        at = change.end;
    }
    return made.append(text_, at, std::string::npos);
}

}  // namespace marsh
}  // namespace RTT
