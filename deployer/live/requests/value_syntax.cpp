// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "value_syntax.hpp"

#include "failure.hpp"

#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr unsigned kDeepest = 60;  // a little less than requests may nest

class Parser {
public:
    explicit Parser(const std::string& text) : text_(text) {}

    json whole() {
        json made = value(0);
        skip();
        if (at_ != text_.size()) wrong("the end");
        return made;
    }

private:
    void skip() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    }
    char next() {
        skip();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char c) {
        if (next() != c || at_ == text_.size()) return false;
        ++at_;
        return true;
    }
    [[noreturn]] void wrong(const char* expected) const {
        const std::string found = at_ >= text_.size()               ? "the end of the value"
                                  : text_.compare(at_, 3, "…") == 0 ? "a value that was cut"
                                                                    : "'" + letter() + "'";
        throw Failure(kWrongValue, "letter " + std::to_string(at_ + 1) + ": found " + found + ", expected " + expected);
    }

    /** The whole letter of UTF-8. */
    std::string letter() const {
        std::size_t end = at_ + 1;
        while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xc0) == 0x80) ++end;
        return text_.substr(at_, end - at_);
    }

    json value(unsigned depth) {
        if (depth > kDeepest) throw Failure(kWrongValue, "the value nests too deeply");
        switch (next()) {
            case '{': return structure(depth);
            case '[': return sequence(depth);
            case '"': return quoted('"');
            case '\'': return quoted('\'');
            default: return word();
        }
    }

    json structure(unsigned depth) {
        ++at_;
        json made = json::object();
        if (take('}')) return made;
        do {
            const std::string name = next() == '"' ? quoted('"') : bare();
            if (name.empty()) wrong("the name of a field");
            if (!take('=') && !take(':')) wrong("'='");
            if (made.contains(name)) throw Failure(kWrongValue, "field '" + name + "' has two values");
            made[name] = value(depth + 1);
        } while (take(','));
        if (!take('}')) wrong("',' or '}'");
        return made;
    }

    json sequence(unsigned depth) {
        ++at_;
        json made = json::array();
        if (take(']')) return made;
        do made.push_back(value(depth + 1));
        while (take(','));
        if (!take(']')) wrong("',' or ']'");
        return made;
    }

    std::string bare() {
        skip();
        const std::size_t begin = at_;
        while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_' ||
                                      text_[at_] == '.' || text_[at_] == '+' || text_[at_] == '-'))
            ++at_;
        return text_.substr(begin, at_ - begin);
    }

    json word() {
        const std::string name = bare();
        if (name.empty()) wrong("a value");
        if (name == "true") return true;
        if (name == "false") return false;
        if (name == "null") return nullptr;
        if (name == "nan" || name == "-nan") return "NaN";
        if (name == "inf" || name == "+inf") return "Infinity";
        if (name == "-inf") return "-Infinity";
        return number(name);
    }

    static json number(const std::string& name) {
        const bool minus = name[0] == '-';
        const std::size_t sign = minus || name[0] == '+' ? 1 : 0;
        const bool hex =
            name.size() > sign + 2 && name[sign] == '0' && (name[sign + 1] == 'x' || name[sign + 1] == 'X');
        const char *const first = name.data() + sign + (hex ? 2 : 0), *const last = name.data() + name.size();
        std::uint64_t whole = 0;
        const auto [end, error] = std::from_chars(first, last, whole, hex ? 16 : 10);
        if (error == std::errc() && end == last && first != last) {
            constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
            if (!minus) return whole;
            if (whole <= most) return -static_cast<std::int64_t>(whole);
            if (whole == most + 1) return std::numeric_limits<std::int64_t>::min();
        }
        double real = 0;
        const auto [realEnd, realError] = std::from_chars(name.data() + (name[0] == '+' ? 1 : 0), last, real);
        if (realError == std::errc() && realEnd == last &&
            std::isdigit(static_cast<unsigned char>(name[sign + (name[sign] == '.' ? 1 : 0)])))
            return real;
        return name;
    }

    static int digit(char c) {
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                      : -1;
    }

    /** The number that so many hexadecimal digits are. */
    unsigned digits(unsigned count) {
        unsigned made = 0;
        for (unsigned i = 0; i != count; ++i, ++at_) {
            const int each = at_ < text_.size() ? digit(text_[at_]) : -1;
            if (each < 0) wrong("a hexadecimal digit");
            made = made * 16 + static_cast<unsigned>(each);
        }
        return made;
    }

    static void addLetter(std::string& to, unsigned code) {
        const auto byte = [&](unsigned value) { to += static_cast<char>(static_cast<unsigned char>(value)); };
        if (code < 0x80)
            byte(code);
        else if (code < 0x800)
            byte(0xc0 | code >> 6), byte(0x80 | (code & 0x3f));
        else if (code < 0x10000)
            byte(0xe0 | code >> 12), byte(0x80 | (code >> 6 & 0x3f)), byte(0x80 | (code & 0x3f));
        else
            byte(0xf0 | code >> 18), byte(0x80 | (code >> 12 & 0x3f)), byte(0x80 | (code >> 6 & 0x3f)),
                byte(0x80 | (code & 0x3f));
    }

    /** \uXXXX as in JSON, where letters beyond 16 bits are two of these. */
    void escapedLetter(std::string& to) {
        unsigned code = digits(4);
        if (code >= 0xd800 && code < 0xdc00 && text_.compare(at_, 2, "\\u") == 0) {
            at_ += 2;
            const unsigned low = digits(4);
            if (low >= 0xdc00 && low < 0xe000) code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
        }
        if (code >= 0xd800 && code < 0xe000) wrong("both halves of a letter beyond 16 bits");
        addLetter(to, code);
    }

    std::string quoted(char quote) {
        ++at_;
        std::string made;
        for (; at_ < text_.size();) {
            const char c = text_[at_++];
            if (c == quote) return made;
            if (c != '\\') {
                made += c;
                continue;
            }
            const char escaped = at_ < text_.size() ? text_[at_++] : '\0';
            switch (escaped) {
                case 'n': made += '\n'; break;
                case 't': made += '\t'; break;
                case 'r': made += '\r'; break;
                case 'b': made += '\b'; break;
                case 'f': made += '\f'; break;
                case '0': made += '\0'; break;
                case 'x': made += static_cast<char>(static_cast<unsigned char>(digits(2))); break;
                case 'u': escapedLetter(made); break;
                default: made += escaped;
            }
        }
        wrong(quote == '"' ? "'\"' at the end of the text" : "\"'\" at the end of the letter");
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

}  // namespace

json parseValue(const std::string& text) { return Parser(text).whole(); }

}  // namespace OCL::live
