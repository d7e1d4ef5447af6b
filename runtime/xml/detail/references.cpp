// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/detail/references.hpp>

#include <cstring>

namespace oroforge::xml::detail {

namespace {

struct Entity {
    const char* reference;
    char character;
};

constexpr Entity entities[] = {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}};

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

void appendUtf8(unsigned long code, std::string& to) {
    if (code < 0x80) {
        to += static_cast<char>(code);
        return;
    }
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    static constexpr unsigned char first[] = {0, 0xC0, 0xE0, 0xF0};
    to += static_cast<char>(first[more] | (code >> (6 * more)));
    for (int i = more - 1; i >= 0; --i) to += static_cast<char>(0x80 | ((code >> (6 * i)) & 0x3F));
}

int digitOf(char c, int base) {
    const int value = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : 16;
    return value < base ? value : -1;
}

/// `at` points to "&#".
std::size_t appendCharacter(const char* at, std::string& to) {
    const int base = at[2] == 'x' ? 16 : 10;
    const char* begin = at + (base == 16 ? 3 : 2);
    const char* p = begin;
    unsigned long code = 0;
    for (; digitOf(*p, base) >= 0; ++p) {
        code = code * static_cast<unsigned long>(base) + static_cast<unsigned long>(digitOf(*p, base));
        if (code > 0x10FFFF) return 0;
    }
    if (p == begin || *p != ';') return 0;
    appendUtf8(code, to);
    return static_cast<std::size_t>(p + 1 - at);
}

}  // namespace

std::size_t appendReference(const char* at, std::string& to) {
    if (at[1] == '#') return appendCharacter(at, to);
    for (const Entity& entity : entities) {
        const std::size_t length = std::strlen(entity.reference);
        if (std::strncmp(at, entity.reference, length) != 0) continue;
        to += entity.character;
        return length;
    }
    return 0;
}

std::string resolved(const char* raw) {
    std::string text;
    while (*raw != '\0') {
        const std::size_t plain = std::strcspn(raw, "&");
        text.append(raw, plain);
        raw += plain;
        if (*raw == '\0') break;
        const std::size_t length = appendReference(raw, text);
        if (length == 0) text += *raw;
        raw += length == 0 ? 1 : length;
    }
    return text;
}

void TextCollector::beginLetter() {
    if (blank_) text_ += ' ';
    blank_ = false;
    started_ = true;
}

void TextCollector::addText(const char* raw) {
    while (*raw != '\0') {
        if (isBlank(*raw)) {
            if (started_ && condense_) blank_ = true;
            if (started_ && !condense_) text_ += *raw;
            ++raw;
            continue;
        }
        beginLetter();
        const std::size_t length = *raw == '&' ? appendReference(raw, text_) : 0;
        if (length == 0) {
            const char* word = raw++;
            while (*raw != '\0' && *raw != '&' && !isBlank(*raw)) ++raw;
            text_.append(word, raw);
        }
        raw += length;
        kept_ = text_.size();
    }
}

void TextCollector::addCdata(const char* text) {
    beginLetter();
    text_ += text;
    kept_ = text_.size();
}

std::string TextCollector::finish() {
    text_.resize(kept_);
    return std::move(text_);
}

}  // namespace oroforge::xml::detail
