// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_CURSOR_ROW_HPP
#define OROFORGE_CONSOLE_CURSOR_ROW_HPP

#include <cstddef>
#include <string>

namespace OCL::console {

/** Follows the cursor of a terminal while libedit writes text from the beginning of a row: it moves to the next row as
    soon as one is full. */
class CursorRow {
public:
    explicit CursorRow(std::size_t width) : width_(width) {}

    /** Adds text in the encoding of the locale, which may have colours. */
    void add(const std::string& text);
    void add(wchar_t letter);

    /** The row of the cursor, counted from the first one. */
    std::size_t row() const { return row_; }
    std::size_t column() const { return column_; }

private:
    void advance(std::size_t columns);

    std::size_t width_, row_ = 0, column_ = 0;
};

}  // namespace OCL::console

#endif
