// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/detail/scanner.hpp>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <xml/detail/references.hpp>

namespace oroforge::xml::detail {

namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool isNameStart(char c) {
    const auto u = static_cast<unsigned char>(c);
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' || u >= 0x80U;
}

bool isNameLetter(char c) { return isNameStart(c) || (c >= '0' && c <= '9') || c == '-' || c == '.'; }

/// Replaces the line ends of other systems by '\n'.
std::string withPlainLineEnds(std::string_view raw) {
    std::string text(raw);
    if (text.find('\r') == std::string::npos) return text;
    std::size_t to = 0;
    for (std::size_t at = 0; at != text.size(); ++at) {
        if (text[at] == '\r' && at + 1 != text.size() && text[at + 1] == '\n') continue;
        text[to++] = text[at] == '\r' ? '\n' : text[at];
    }
    text.resize(to);
    return text;
}

/// The value of an attribute from its source text.
std::string attributeValue(std::string_view raw) {
    const auto isSpecial = [](char c) { return c == '&' || c == '\r'; };
    if (std::none_of(raw.begin(), raw.end(), isSpecial)) return std::string(raw);
    return resolved(withPlainLineEnds(raw).c_str());
}

class Scanner {
public:
    Scanner(const std::string& text, const std::string& file, diag::Sink& sink, const Building& building)
        : text_(text), file_(file), sink_(sink), building_(building) {}

    std::optional<Element> run() {
        if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0) position_ = lineStart_ = 3;
        while (position_ < text_.size()) {
            if (text_[position_] == '<' ? !markup() : !characters()) return std::nullopt;
        }
        if (!open_.empty()) {
            const Element& tag = open_.back().element;
            report(tag.where, "XML003", "<" + tag.name + "> is never closed; expected </" + tag.name + ">");
            return std::nullopt;
        }
        if (!root_) fail(here(), "XML005", "found no element; expected one root element");
        return std::move(root_);
    }

private:
    struct Open {
        Element element;
        TextCollector text;
    };

    diag::Location here() const { return {file_, line_, static_cast<unsigned>(position_ - lineStart_ + 1)}; }

    diag::Diagnostic& report(const diag::Location& where, const char* code, const std::string& message) {
        return sink_.error(where, code, message);
    }
    bool fail(const diag::Location& where, const char* code, const std::string& message) {
        report(where, code, message);
        return false;
    }

    Offset offset() const { return static_cast<Offset>(position_); }

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

    /// Shares equal names, for most files have few. If a file has many, only the first ones are shared.
    diag::SharedText shared(std::string_view name) {
        const auto known = names_.find(name);
        if (known != names_.end()) return known->second;
        diag::SharedText made = std::string(name);
        if (names_.size() < maxSharedNames) names_.emplace(name, made);
        return made;
    }

    bool characters() {
        const std::size_t begin = position_;
        skipSpace();
        if (position_ == text_.size() || text_[position_] == '<') return true;
        if (open_.empty()) return fail(here(), "XML004", "found text outside of the root element");
        beginText();
        advanceTo(std::min(text_.find('<', position_), text_.size()));
        open_.back().text.addText(withPlainLineEnds(between(begin, position_)).c_str());
        return true;
    }

    std::string_view between(std::size_t begin, std::size_t end) const {
        return std::string_view(text_).substr(begin, end - begin);
    }

    void beginText() {
        diag::Location& textWhere = open_.back().element.textWhere;
        if (textWhere.line == 0) textWhere = here();
    }

    bool markup() {
        const char kind = position_ + 1 < text_.size() ? text_[position_ + 1] : '\0';
        if (kind == '/') return endTag();
        if (kind == '?') return skipPast(2, "?>", "processing instruction");
        if (startsWith("<!DOCTYPE")) return documentType();
        if (kind != '!') return startTag();
        if (startsWith("<!--")) return skipPast(4, "-->", "comment");
        if (startsWith("<![CDATA[")) {
            if (open_.empty()) return fail(here(), "XML004", "found a CDATA section outside of the root element");
            beginText();
            const std::size_t begin = position_ + 9;
            if (!skipPast(9, "]]>", "CDATA section")) return false;
            open_.back().text.addCdata(withPlainLineEnds(between(begin, position_ - 3)).c_str());
            return true;
        }
        return skipPast(2, ">", "declaration");
    }

    /// Skips <!DOCTYPE …>. Its declarations in brackets, quoted texts and comments may contain a '>'.
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

    /// Skips a construct that ends with `end`; `begin` is the length of its opening.
    bool skipPast(std::size_t begin, std::string_view end, const char* what) {
        const std::size_t found = text_.find(end, position_ + begin);
        if (found == std::string::npos) {
            return fail(here(), "XML003", str(what) + " is never closed; expected '" + str(end) + "'");
        }
        advanceTo(found + end.size());
        return true;
    }

    bool endTag() {
        const diag::Location at = here();
        const std::size_t begin = position_;
        advanceTo(position_ + 2);
        const std::string_view closed = name();
        if (open_.empty()) return fail(at, "XML003", "found </" + str(closed) + ">, but no element is open");
        Element& element = open_.back().element;
        if (closed != element.name.str()) {
            report(at, "XML003", "found </" + str(closed) + ">, expected </" + element.name + ">")
                .note(element.where, "<" + element.name + "> opened here");
            return false;
        }
        skipSpace();
        if (current() != '>') return fail(here(), "XML002", "expected '>' at the end of </" + str(closed) + ">");
        advance();
        element.extent.contentEnd = static_cast<Offset>(begin);
        element.extent.end = offset();
        close();
        return true;
    }

    /// Gives the innermost element to its parent, or to the consumer.
    void close() {
        Open closed = std::move(open_.back());
        open_.pop_back();
        Element& element = closed.element;
        element.text = closed.text.finish();
        if (element.textWhere.line == 0) element.textWhere = element.where;
        if (open_.empty())
            root_ = std::move(element);
        else if (building_.take && open_.size() == 1)
            building_.take(open_.front().element, std::move(element));
        else if (building_.keep)
            open_.back().element.children.push_back(std::move(element));
    }

    bool startTag() {
        Element tag;
        tag.where = here();
        tag.extent.begin = offset();
        if (open_.size() == maxDepth) return fail(tag.where, "XML007", "elements are nested too deeply");
        advance();
        tag.name = shared(name());
        if (tag.name.empty())
            return fail(tag.where, "XML002", "found '<' without an element name; write '&lt;' for the character");
        if (root_) {
            report(tag.where, "XML005", "found a second root element <" + tag.name + ">, expected only one")
                .note(root_->where, "<" + root_->name + "> is the first");
            return false;
        }
        for (;;) {
            const bool spaced = isSpace(current());
            skipSpace();
            if (current() == '>' || startsWith("/>")) break;
            if (position_ >= text_.size() || current() == '<')
                return fail(tag.where, "XML002", "start tag <" + tag.name + " is not finished; expected '>'");
            if (!spaced) return fail(here(), "XML002", "expected white space before the next attribute");
            if (!attribute(tag)) return false;
        }
        const bool empty = current() == '/';
        advanceTo(position_ + (empty ? 2 : 1));
        tag.extent.contentBegin = tag.extent.contentEnd = tag.extent.end = offset();
        tag.attributes.shrink_to_fit();
        open_.push_back({std::move(tag), TextCollector(building_.blanks == Blanks::condensed)});
        if (empty) close();
        return true;
    }

    bool attribute(Element& tag) {
        Attribute attribute;
        attribute.where = here();
        attribute.name = shared(name());
        if (attribute.name.empty()) {
            return fail(here(), "XML002",
                        std::string("found '") + current() + "' in <" + tag.name + ">, expected an attribute name");
        }
        if (const Attribute* const other = tag.attribute(attribute.name)) {
            report(attribute.where, "XML006", "attribute '" + attribute.name + "' is given twice")
                .note(other->where, "first given here");
            return false;
        }
        if (tag.attributes.size() == maxAttributes) {
            return fail(attribute.where, "XML008",
                        "<" + tag.name + "> has more than " + std::to_string(maxAttributes) + " attributes");
        }
        skipSpace();
        if (current() != '=') return fail(here(), "XML002", "expected '=' after attribute '" + attribute.name + "'");
        advance();
        skipSpace();
        const char quote = current();
        if (quote != '"' && quote != '\'') {
            return fail(here(), "XML002", "the value of attribute '" + attribute.name + "' is not in quotes");
        }
        const std::size_t end = text_.find(quote, position_ + 1);
        const std::string_view value = between(position_ + 1, end == std::string::npos ? text_.size() : end);
        if (end == std::string::npos || value.find('<') != std::string_view::npos) {
            return fail(here(), "XML002",
                        "the value of attribute '" + attribute.name + "' has no closing quote before the next '<'");
        }
        advance();
        attribute.valueWhere = here();
        attribute.valueBegin = offset();
        attribute.valueEnd = static_cast<Offset>(end);
        attribute.value = attributeValue(value);
        advanceTo(end + 1);
        if (tag.attributes.empty()) tag.attributes.reserve(2);  // name and type, in most files
        tag.attributes.push_back(std::move(attribute));
        return true;
    }

    const std::string& text_;
    const diag::FileName file_;  // shared by all places
    diag::Sink& sink_;
    const Building& building_;
    std::unordered_map<std::string_view, diag::SharedText> names_;
    std::vector<Open> open_;  // outermost first
    std::optional<Element> root_;
    std::size_t position_ = 0;
    std::size_t lineStart_ = 0;
    unsigned line_ = 1;
};

}  // namespace

std::optional<Element> scan(const std::string& text, const std::string& file, diag::Sink& sink,
                            const Building& building) {
    return Scanner(text, file, sink, building).run();
}

}  // namespace oroforge::xml::detail
