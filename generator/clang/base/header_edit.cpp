// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "header_edit.hpp"

#include <algorithm>

namespace oroforge::cxx {

namespace {

constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";

/// A line "# keyword rest" without blanks around its parts; other lines have no keyword.
struct Directive {
    std::string keyword;
    std::string rest;
};

Directive parseDirective(const std::string& line) {
    const char* const blanks = " \t\r";
    const std::size_t sign = line.find_first_not_of(blanks);
    if (sign == std::string::npos || line[sign] != '#') return {};
    const std::size_t word = line.find_first_not_of(blanks, sign + 1);
    if (word == std::string::npos) return {};
    const std::size_t end = std::min(line.find_first_of(" \t\r<\"", word), line.size());
    const std::size_t rest = line.find_first_not_of(blanks, end);
    if (rest == std::string::npos) return {line.substr(word, end - word), ""};
    const std::size_t last = line.find_last_not_of(blanks);
    return {line.substr(word, end - word), line.substr(rest, last + 1 - rest)};
}

std::string firstWord(const std::string& text) { return text.substr(0, text.find_first_of(" \t/")); }

class GuardReader {
public:
    /// `next` is the offset of the line after this one.
    void take(const Directive& line, std::size_t start, std::size_t next) {
        if (closed_ && !line.keyword.empty()) guard_.clear();
        if (line.keyword.compare(0, 2, "if") == 0) {
            if (!anyDirective_ && line.keyword == "ifndef") guard_ = firstWord(line.rest);
            ++depth_;
        } else if (line.keyword == "endif") {
            --depth_;
            closed_ = closed_ || depth_ == 0;
        } else if (line.keyword == "define" && depth_ == 1 && !guard_.empty() && firstWord(line.rest) == guard_) {
            guardDepth_ = 1;
            afterGuard = next;
        } else if (line.keyword == "pragma" && firstWord(line.rest) == "once") {
            afterGuard = next;
        } else if (line.keyword == "include" && !firstInclude && depth_ == guardDepth_) {
            firstInclude = start;
        }
        if (!line.keyword.empty()) anyDirective_ = true;
    }

    std::string guard() const { return closed_ && guardDepth_ == 1 ? guard_ : ""; }

    std::optional<std::size_t> firstInclude;
    std::optional<std::size_t> afterGuard;

private:
    bool closed_ = false;  // by the #endif of the first condition
    int depth_ = 0;
    int guardDepth_ = 0;
    bool anyDirective_ = false;
    std::string guard_;
};

/// Calls take(directive, start of its line, start of the next line).
template <class Take>
void forEachLine(const std::string& header, Take&& take) {
    for (std::size_t start = placeForPragmaOnce(header); start < header.size();) {
        const std::size_t end = std::min(header.find('\n', start), header.size());
        take(parseDirective(header.substr(start, end - start)), start, std::min(end + 1, header.size()));
        start = end + 1;
    }
}

}  // namespace

std::size_t placeForPragmaOnce(const std::string& header) { return header.compare(0, 3, kByteOrderMark) == 0 ? 3 : 0; }

std::optional<std::size_t> placeForInclude(const std::string& header, const std::string& name) {
    GuardReader reader;
    bool there = false;
    forEachLine(header, [&](const Directive& line, std::size_t start, std::size_t next) {
        there = there || (line.keyword == "include" && line.rest.compare(0, name.size() + 2, "<" + name + ">") == 0);
        reader.take(line, start, next);
    });
    if (there) return std::nullopt;
    if (reader.firstInclude) return reader.firstInclude;
    return reader.afterGuard.value_or(placeForPragmaOnce(header));
}

std::string guardOf(const std::string& header) {
    GuardReader reader;
    forEachLine(header,
                [&](const Directive& line, std::size_t start, std::size_t next) { reader.take(line, start, next); });
    return reader.guard();
}

}  // namespace oroforge::cxx
