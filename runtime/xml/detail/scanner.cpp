// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/detail/scanner.hpp>

#include <cctype>
#include <cstddef>

namespace oroforge::xml::detail {

namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool isNameStart(char c) {
    const auto u = static_cast<unsigned char>(c);
    return std::isalpha(u) != 0 || c == '_' || c == ':' || u >= 0x80U;
}

bool isNameLetter(char c) {
    return isNameStart(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.';
}

class Scanner {
public:
    Scanner(const std::string& text, const std::string& file, diag::Sink& sink, std::vector<TagPlace>& tags)
        : text_(text), file_(file), sink_(sink), tags_(tags) {}

    bool run() {
        if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0) position_ = lineStart_ = 3;
        while (position_ < text_.size()) {
            if (text_[position_] == '<' ? !markup() : !characters()) return false;
        }
        if (!open_.empty()) {
            const TagPlace& tag = tags_[open_.back()];
            return fail(tag.at, "XML003", "<" + tag.name + "> is never closed; expected </" + tag.name + ">");
        }
        if (tags_.empty()) return fail(here(), "XML005", "found no element; expected one root element");
        return true;
    }

private:
    diag::Location here() const { return {file_, line_, static_cast<unsigned>(position_ - lineStart_ + 1)}; }

    bool fail(const diag::Location& where, const char* code, const std::string& message) {
        sink_.error(where, code, message);
        return false;
    }

    bool startsWith(const char* word) const { return text_.compare(position_, std::string(word).size(), word) == 0; }
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
    std::string name() {
        const std::size_t begin = position_;
        if (position_ < text_.size() && isNameStart(text_[position_])) {
            while (position_ < text_.size() && isNameLetter(text_[position_])) advance();
        }
        return text_.substr(begin, position_ - begin);
    }

    bool characters() {
        if (!isSpace(text_[position_])) {
            if (open_.empty()) return fail(here(), "XML004", "found text outside of the root element");
            TagPlace& tag = tags_[open_.back()];
            if (tag.text_at.line == 0) tag.text_at = here();
        }
        advance();
        return true;
    }

    bool markup() {
        if (startsWith("<!--")) return skipPast("-->", "comment");
        if (startsWith("<![CDATA[")) {
            if (open_.empty()) return fail(here(), "XML004", "found a CDATA section outside of the root element");
            TagPlace& tag = tags_[open_.back()];
            if (tag.text_at.line == 0) tag.text_at = here();
            return skipPast("]]>", "CDATA section");
        }
        if (startsWith("<?")) return skipPast("?>", "processing instruction");
        if (startsWith("<!")) return skipPast(">", "declaration");
        if (startsWith("</")) return endTag();
        return startTag();
    }

    bool skipPast(const std::string& end, const std::string& what) {
        const std::size_t found = text_.find(end, position_ + 2);
        if (found == std::string::npos) {
            return fail(here(), "XML003", what + " is never closed; expected '" + end + "'");
        }
        advanceTo(found + end.size());
        return true;
    }

    bool endTag() {
        const diag::Location at = here();
        advanceTo(position_ + 2);
        const std::string closed = name();
        if (open_.empty()) return fail(at, "XML003", "found </" + closed + ">, but no element is open");
        const TagPlace& tag = tags_[open_.back()];
        if (closed != tag.name) {
            sink_.error(at, "XML003", "found </" + closed + ">, expected </" + tag.name + ">")
                .note(tag.at, "<" + tag.name + "> opened here");
            return false;
        }
        skipSpace();
        if (current() != '>') return fail(here(), "XML002", "expected '>' at the end of </" + closed + ">");
        advance();
        open_.pop_back();
        return true;
    }

    bool startTag() {
        TagPlace tag;
        tag.at = here();
        advance();
        tag.name = name();
        if (tag.name.empty())
            return fail(tag.at, "XML002", "found '<' without an element name; write '&lt;' for the character");
        if (open_.empty() && !tags_.empty()) {
            sink_.error(tag.at, "XML005", "found a second root element <" + tag.name + ">, expected only one")
                .note(tags_.front().at, "<" + tags_.front().name + "> is the first");
            return false;
        }
        for (;;) {
            const bool spaced = isSpace(current());
            skipSpace();
            if (current() == '>' || startsWith("/>")) break;
            if (position_ >= text_.size() || current() == '<') {
                return fail(tag.at, "XML002", "start tag <" + tag.name + " is not finished; expected '>'");
            }
            if (!spaced) return fail(here(), "XML002", "expected white space before the next attribute");
            if (!attribute(tag)) return false;
        }
        const bool empty = current() == '/';
        advanceTo(position_ + (empty ? 2 : 1));
        tags_.push_back(tag);
        if (!empty) open_.push_back(tags_.size() - 1);
        return true;
    }

    bool attribute(TagPlace& tag) {
        AttributePlace place;
        place.name_at = here();
        place.name = name();
        if (place.name.empty()) {
            return fail(here(), "XML002",
                        std::string("found '") + current() + "' in <" + tag.name + ">, expected an attribute name");
        }
        for (const AttributePlace& other : tag.attributes) {
            if (other.name != place.name) continue;
            sink_.error(place.name_at, "XML006", "attribute '" + place.name + "' is given twice")
                .note(other.name_at, "first given here");
            return false;
        }
        skipSpace();
        if (current() != '=') return fail(here(), "XML002", "expected '=' after attribute '" + place.name + "'");
        advance();
        skipSpace();
        const char quote = current();
        if (quote != '"' && quote != '\'') {
            return fail(here(), "XML002", "the value of attribute '" + place.name + "' is not in quotes");
        }
        const std::size_t end = text_.find(quote, position_ + 1);
        const std::size_t bad = text_.find('<', position_ + 1);
        if (end == std::string::npos || bad < end) {
            return fail(here(), "XML002",
                        "the value of attribute '" + place.name + "' has no closing quote before the next '<'");
        }
        advance();
        place.value_at = here();
        advanceTo(end + 1);
        tag.attributes.push_back(place);
        return true;
    }

    const std::string& text_;
    const std::string& file_;
    diag::Sink& sink_;
    std::vector<TagPlace>& tags_;
    std::vector<std::size_t> open_;  // indices into tags_, outermost first
    std::size_t position_ = 0;
    std::size_t lineStart_ = 0;
    unsigned line_ = 1;
};

}  // namespace

bool scan(const std::string& text, const std::string& file, diag::Sink& sink, std::vector<TagPlace>& tags) {
    return Scanner(text, file, sink, tags).run();
}

}  // namespace oroforge::xml::detail
