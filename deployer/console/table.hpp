// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Text in columns.
#ifndef OROFORGE_CONSOLE_TABLE_HPP
#define OROFORGE_CONSOLE_TABLE_HPP

#include "theme.hpp"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace OCL::console {

/** The number of letters of a UTF-8 text. */
std::size_t widthOf(const std::string& text);
/** The text cut to that width, with "…" at its end if it was longer. */
std::string shortened(const std::string& text, std::size_t width);
/** The text on one line, with blanks joined. */
std::string oneLine(const std::string& text);
/** A value on one line, with blanks joined, but not those within its quotes. */
std::string valueOnOneLine(const std::string& text);
/** The text in lines of at most that width, apart from longer words; one line if the width is 0. */
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

/** Rows of cells, each column as wide as its widest cell. */
class Table {
public:
    enum Overflow { Cut, Wrap };  ///< what happens to text of the last column that does not fit
    explicit Table(std::vector<Style> styles, Overflow overflow = Cut)
        : styles_(std::move(styles)), overflow_(overflow) {}

    /** Adds a row; missing cells at its end are empty. */
    void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
    bool empty() const { return rows_.empty(); }
    /** Writes the rows, which end at `width` unless that is 0, without columns that are empty in all of them. */
    void write(std::ostream& out, const Theme& theme, const std::string& indent, std::size_t width) const;

private:
    std::vector<Style> styles_;
    Overflow overflow_;
    std::vector<std::vector<std::string>> rows_;
};

/** Writes words from top to bottom and left to right, in as many columns as fit into `width`. */
void writeColumns(std::ostream& out, const std::vector<std::string>& words, const Theme& theme, Style style,
                  const std::string& indent, std::size_t width);

}  // namespace OCL::console

#endif
