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

/** The letters of a UTF-8 text. */
std::size_t widthOf(const std::string& text);
/** At most that wide; what is cut off leaves a "…". */
std::string shortened(const std::string& text, std::size_t width);
/** In one line, blanks joined. */
std::string oneLine(const std::string& text);
/** The text in lines of at most that width, 0: one line; only a word that is longer makes a longer one. */
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

/** Rows of cells, each column as wide as its widest cell. */
class Table {
public:
    enum Overflow { Cut, Wrap };  ///< what happens with text of the last column that does not fit
    explicit Table(std::vector<Style> styles, Overflow overflow = Cut)
        : styles_(std::move(styles)), overflow_(overflow) {}

    /** Missing cells at the end are empty. */
    void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
    bool empty() const { return rows_.empty(); }
    /** Columns that are empty in all rows are left out; rows end at `width`, 0: nowhere. */
    void write(std::ostream& out, const Theme& theme, const std::string& indent, std::size_t width) const;

private:
    std::vector<Style> styles_;
    Overflow overflow_;
    std::vector<std::vector<std::string>> rows_;
};

/** Words from top to bottom and left to right, as many columns as fit into `width`. */
void writeColumns(std::ostream& out, const std::vector<std::string>& words, const Theme& theme, Style style,
                  const std::string& indent, std::size_t width);

}  // namespace OCL::console

#endif
