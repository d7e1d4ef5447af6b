// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "text_edit.hpp"

namespace RTT::marsh {

namespace {
constexpr std::size_t kTab = 3;  // as wide as one indentation of the writer

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/** Looks at the first indented line. */
bool isIndentedByTabs(const std::string& text) {
    const std::size_t tab = text.find("\n\t");
    return tab != std::string::npos && tab < text.find("\n ");
}
}  // namespace

TextEdit::TextEdit(const std::string& text)
    : text_(text), crLf_(text.find("\r\n") != std::string::npos), tabs_(isIndentedByTabs(text)) {}

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
    if (begin != 0 && text_[begin - 1] != '\n') return otherwise;
    std::size_t width = 0;
    for (std::size_t i = begin; i != at; ++i) width += text_[i] == '\t' ? kTab : 1;
    return width;
}

bool TextEdit::hasLineEnd(std::size_t begin, std::size_t end) const {
    const std::size_t at = text_.find('\n', begin);
    return at != std::string::npos && at < end;
}

void TextEdit::append(const std::string& inserted, std::string& made) const {
    std::size_t at = 0;
    while (at != inserted.size()) {
        const char c = inserted[at++];
        if (c == '\n' && crLf_) made += '\r';
        made += c;
        while (c == '\n' && tabs_ && inserted.compare(at, kTab, "   ") == 0) {
            made += '\t';
            at += kTab;
        }
    }
}

std::string TextEdit::result() const {
    std::string made;
    std::size_t at = 0;
    for (const Change& change : changes_) {
        made.append(text_, at, change.begin - at);
        append(change.by, made);
        at = change.end;
    }
    return made.append(text_, at, std::string::npos);
}

}  // namespace RTT::marsh
