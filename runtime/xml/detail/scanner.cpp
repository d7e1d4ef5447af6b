// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/detail/scanner.hpp>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace oroforge::xml::detail {

namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool isNameStart(char c) {
    const auto u = static_cast<unsigned char>(c);
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' || u >= 0x80U;
}

bool isNameLetter(char c) { return isNameStart(c) || (c >= '0' && c <= '9') || c == '-' || c == '.'; }

class Scanner {
public:
    Scanner(const std::string& text, const std::string& file, diag::Sink& sink, Places& places)
        : text_(text),
          file_(file),
          sink_(sink),
          tags_(places.tags),
          attributes_(places.attributes),
          instructions_(places.instructions) {}

    bool run() {
        if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0) position_ = lineStart_ = 3;
        tags_.reserve(static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '<')) / 2);
        while (position_ < text_.size()) {
            if (text_[position_] == '<' ? !markup() : !characters()) return false;
        }
        if (!open_.empty()) {
            const TagPlace& tag = tags_[open_.back()];
            return fail(tag.at, "XML003", '<' + str(tag.name) + "> is never closed; expected </" + str(tag.name) + ">");
        }
        if (tags_.empty()) return fail(here(), "XML005", "found no element; expected one root element");
        return true;
    }

private:
    Place here() const { return {line_, static_cast<unsigned>(position_ - lineStart_ + 1)}; }
    diag::Location inFile(const Place& place) const { return {file_, place.line, place.column}; }

    diag::Diagnostic& report(const Place& where, const char* code, const std::string& message) {
        return sink_.error(inFile(where), code, message);
    }
    bool fail(const Place& where, const char* code, const std::string& message) {
        report(where, code, message);
        return false;
    }

    bool startsWith(std::string_view word) const { return text_.compare(position_, word.size(), word) == 0; }
    char current() const { return position_ < text_.size() ? text_[position_] : '\0'; }

    void advance() {
        if (text_[position_++] == '\n') {
            ++line_;
            lineStart_ = position_;
        }
    }
    void advanceTo(std::size_t target) {
        while (position_ < target) advance();
    }
    void skipSpace() {
        while (position_ < text_.size() && isSpace(text_[position_])) advance();
    }
    static std::string str(std::string_view part) { return std::string(part); }

    std::string_view name() {
        const std::size_t begin = position_;
        if (position_ < text_.size() && isNameStart(text_[position_])) {
            while (position_ < text_.size() && isNameLetter(text_[position_])) advance();
        }
        return std::string_view(text_).substr(begin, position_ - begin);
    }

    bool characters() {
        skipSpace();
        if (position_ == text_.size() || text_[position_] == '<') return true;
        if (open_.empty()) return fail(here(), "XML004", "found text outside of the root element");
        TagPlace& tag = tags_[open_.back()];
        if (tag.text_at.line == 0) tag.text_at = here();
        advanceTo(std::min(text_.find('<', position_), text_.size()));
        return true;
    }

    bool markup() {
        const char kind = position_ + 1 < text_.size() ? text_[position_ + 1] : '\0';
        if (kind == '/') return endTag();
        if (kind == '?' || startsWith("<!DOCTYPE")) return instruction(kind);
        if (kind != '!') return startTag();
        if (startsWith("<!--")) return skipPast(4, "-->", "comment");
        if (startsWith("<![CDATA[")) {
            if (open_.empty()) return fail(here(), "XML004", "found a CDATA section outside of the root element");
            TagPlace& tag = tags_[open_.back()];
            if (tag.text_at.line == 0) tag.text_at = here();
            return skipPast(9, "]]>", "CDATA section");
        }
        return skipPast(2, ">", "declaration");
    }

    bool instruction(char kind) {
        const std::size_t begin = position_;
        if (kind == '?' ? !skipPast(2, "?>", "processing instruction") : !documentType()) return false;
        instructions_.push_back({begin, position_});
        return true;
    }

    /// It may have declarations between brackets; these, quoted text and comments may have ends like its own.
    bool documentType() {
        bool inner = false;
        for (std::size_t at = position_ + 2; at < text_.size(); ++at) {
            const char letter = text_[at];
            if (letter == '"' || letter == '\'')
                at = text_.find(letter, at + 1);
            else if (text_.compare(at, 4, "<!--") == 0)
                at = text_.find("-->", at + 4);
            else if (letter == '[' || letter == ']')
                inner = letter == '[';
            else if (letter == '>' && !inner)
                return skipPast(at - position_, ">", "declaration");
            if (at == std::string::npos) break;
        }
        return fail(here(), "XML003", "declaration is never closed; expected '>'");
    }

    /// `begin` is the length of what opens it.
    bool skipPast(std::size_t begin, std::string_view end, const char* what) {
        const std::size_t found = text_.find(end, position_ + begin);
        if (found == std::string::npos) {
            return fail(here(), "XML003", str(what) + " is never closed; expected '" + str(end) + "'");
        }
        advanceTo(found + end.size());
        return true;
    }

    bool endTag() {
        const Place at = here();
        const std::size_t begin = position_;
        advanceTo(position_ + 2);
        const std::string_view closed = name();
        if (open_.empty()) return fail(at, "XML003", "found </" + str(closed) + ">, but no element is open");
        TagPlace& tag = tags_[open_.back()];
        if (closed != tag.name) {
            report(at, "XML003", "found </" + str(closed) + ">, expected </" + str(tag.name) + ">")
                .note(inFile(tag.at), "<" + str(tag.name) + "> opened here");
            return false;
        }
        skipSpace();
        if (current() != '>') return fail(here(), "XML002", "expected '>' at the end of </" + str(closed) + ">");
        advance();
        tag.extent.contentEnd = begin;
        tag.extent.end = position_;
        open_.pop_back();
        return true;
    }

    bool startTag() {
        TagPlace tag;
        tag.at = here();
        tag.attributes_begin = attributes_.size();
        tag.extent.begin = position_;
        if (open_.size() == maxDepth) return fail(tag.at, "XML007", "elements are nested too deeply");
        advance();
        tag.name = name();
        if (tag.name.empty())
            return fail(tag.at, "XML002", "found '<' without an element name; write '&lt;' for the character");
        if (open_.empty() && !tags_.empty()) {
            report(tag.at, "XML005", "found a second root element <" + str(tag.name) + ">, expected only one")
                .note(inFile(tags_.front().at), "<" + str(tags_.front().name) + "> is the first");
            return false;
        }
        for (;;) {
            const bool spaced = isSpace(current());
            skipSpace();
            if (current() == '>' || startsWith("/>")) break;
            if (position_ >= text_.size() || current() == '<') {
                return fail(tag.at, "XML002", "start tag <" + str(tag.name) + " is not finished; expected '>'");
            }
            if (!spaced) return fail(here(), "XML002", "expected white space before the next attribute");
            if (!attribute(tag)) return false;
        }
        const bool empty = current() == '/';
        advanceTo(position_ + (empty ? 2 : 1));
        tag.extent.contentBegin = tag.extent.contentEnd = tag.extent.end = position_;
        tag.attributes_end = attributes_.size();
        tags_.push_back(tag);
        if (!empty) open_.push_back(tags_.size() - 1);
        return true;
    }

    bool attribute(const TagPlace& tag) {
        AttributePlace place;
        place.name_at = here();
        place.name = name();
        if (place.name.empty()) {
            return fail(
                here(), "XML002",
                std::string("found '") + current() + "' in <" + str(tag.name) + ">, expected an attribute name");
        }
        for (std::size_t i = tag.attributes_begin; i != attributes_.size(); ++i) {
            const AttributePlace& other = attributes_[i];
            if (other.name != place.name) continue;
            report(place.name_at, "XML006", "attribute '" + str(place.name) + "' is given twice")
                .note(inFile(other.name_at), "first given here");
            return false;
        }
        if (attributes_.size() - tag.attributes_begin == maxAttributes) {
            return fail(place.name_at, "XML008",
                        '<' + str(tag.name) + "> has more than " + std::to_string(maxAttributes) + " attributes");
        }
        skipSpace();
        if (current() != '=') return fail(here(), "XML002", "expected '=' after attribute '" + str(place.name) + "'");
        advance();
        skipSpace();
        const char quote = current();
        if (quote != '"' && quote != '\'') {
            return fail(here(), "XML002", "the value of attribute '" + str(place.name) + "' is not in quotes");
        }
        const std::size_t end = text_.find(quote, position_ + 1);
        const std::string_view value(text_.data() + position_ + 1,
                                     (end == std::string::npos ? text_.size() : end) - position_ - 1);
        if (end == std::string::npos || value.find('<') != std::string_view::npos) {
            return fail(here(), "XML002",
                        "the value of attribute '" + str(place.name) + "' has no closing quote before the next '<'");
        }
        advance();
        place.value_at = here();
        place.value_begin = position_;
        place.value_end = end;
        advanceTo(end + 1);
        attributes_.push_back(place);
        return true;
    }

    const std::string& text_;
    const std::string& file_;
    diag::Sink& sink_;
    std::vector<TagPlace>& tags_;
    std::vector<AttributePlace>& attributes_;
    std::vector<Span>& instructions_;
    std::vector<std::size_t> open_;  // indices into tags_, outermost first
    std::size_t position_ = 0;
    std::size_t lineStart_ = 0;
    unsigned line_ = 1;
};

}  // namespace

bool scan(const std::string& text, const std::string& file, diag::Sink& sink, Places& places) {
    return Scanner(text, file, sink, places).run();
}

}  // namespace oroforge::xml::detail
