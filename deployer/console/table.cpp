// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "table.hpp"

#include <algorithm>
#include <cctype>
#include <ostream>
#include <sstream>

namespace OCL::console {
namespace {

constexpr const char* kGap = "  ";
constexpr std::size_t kLeast = 4;          // letters of a cell that is cut
constexpr std::size_t kLeastWrapped = 16;  // letters in a column that is wrapped

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::string blanks(std::size_t count) { return std::string(count, ' '); }

}  // namespace

std::size_t widthOf(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

std::string shortened(const std::string& text, std::size_t width) {
    if (widthOf(text) <= width) return text;
    std::size_t end = 0;
    for (std::size_t letters = 0; end < text.size(); ++end)
        if (!continues(text[end]) && ++letters == width) break;
    return text.substr(0, end) + "…";
}

std::string oneLine(const std::string& text) {
    std::string line;
    for (const char c : text) {
        const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!blank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    if (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

std::string valueOnOneLine(const std::string& text) {
    std::string line;
    bool isQuoted = false;
    for (std::size_t at = 0; at != text.size(); ++at) {
        const char c = text[at];
        if (isQuoted && c == '\\' && at + 1 != text.size()) {
            line += c;
            line += text[++at];
        } else if (!isQuoted && text.compare(at, 3, "'\"'") == 0) {
            line += "'\"'";
            at += 2;
        } else if (isQuoted && c == ' ') {
            line += c;
        } else if (!std::isspace(static_cast<unsigned char>(c))) {
            isQuoted = isQuoted != (c == '"');
            line += c;
        } else if (!line.empty() && line.back() != ' ') {
            line += ' ';
        }
    }
    if (!isQuoted && !line.empty() && line.back() == ' ') line.pop_back();
    return line;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
    if (width == 0) return {text};
    std::vector<std::string> lines(1);
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (!lines.back().empty() && widthOf(lines.back()) + 1 + widthOf(word) > width) lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
    }
    return lines;
}

void Table::write(std::ostream& out, const Theme& theme, const std::string& indent, std::size_t width) const {
    std::vector<std::size_t> widths(styles_.size(), 0);
    for (const auto& row : rows_)
        for (std::size_t i = 0; i != row.size(); ++i) widths[i] = std::max(widths[i], widthOf(row[i]));
    for (const auto& row : rows_) {
        out << indent;
        std::size_t at = widthOf(indent), pending = 0;
        for (std::size_t i = 0; i != row.size(); ++i) {
            if (widths[i] == 0) continue;
            std::string cell = row[i];
            const std::size_t start = at + pending;
            if (overflow_ == Wrap && i + 1 == styles_.size() && width >= start + kLeastWrapped) {
                out << blanks(pending);
                const auto lines = wrapped(cell, width - start);
                for (std::size_t line = 0; line != lines.size(); ++line)
                    out << (line ? "\n" + blanks(start) : "") << theme.paint(styles_[i], lines[line]);
                break;
            }
            if (width != 0 && start + widthOf(cell) > width) {
                if (width < start + kLeast) break;
                cell = shortened(cell, width - start);
            }
            if (!cell.empty()) {
                out << blanks(pending) << theme.paint(styles_[i], cell);
                at = start + widthOf(cell);
                pending = 0;
            }
            pending += widths[i] - widthOf(cell) + std::string(kGap).size();
        }
        out << '\n';
    }
}

void writeColumns(std::ostream& out, const std::vector<std::string>& words, const Theme& theme, Style style,
                  const std::string& indent, std::size_t width) {
    std::size_t widest = 1;
    for (const std::string& word : words) widest = std::max(widest, widthOf(word));
    const std::size_t cell = widest + std::string(kGap).size();
    const std::size_t room = width > indent.size() + cell ? width - indent.size() : cell;
    const std::size_t columns = std::max<std::size_t>(1, room / cell);
    const std::size_t rows = (words.size() + columns - 1) / columns;
    for (std::size_t row = 0; row != rows; ++row) {
        out << indent;
        for (std::size_t at = row; at < words.size(); at += rows) {
            out << theme.paint(style, words[at]);
            if (at + rows < words.size()) out << blanks(cell - widthOf(words[at]));
        }
        out << '\n';
    }
}

}  // namespace OCL::console
