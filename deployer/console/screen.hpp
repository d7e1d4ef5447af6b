// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The output of the console, and the line that errors point into.
#ifndef OROFORGE_CONSOLE_SCREEN_HPP
#define OROFORGE_CONSOLE_SCREEN_HPP

#include "theme.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace OCL::console {

struct Screen {
    std::ostream& out;
    std::ostream& err;
    Theme theme;
    bool hex = false;
    /** The number of columns of a line. */
    std::function<std::size_t()> width = [] { return std::size_t(100); };
    bool cutsTables = false;    ///< tables are cut at the end of the line, as a terminal needs
    bool live = false;          ///< a user at a terminal sees it, and can end a command by a key
    bool canBeStopped = false;  ///< somebody can interrupt a command, if no key can
    bool erases = false;        ///< the terminal can erase what it shows
    bool failed = false;        ///< a line could not be executed

    /** The width of tables; 0 if it has no limit. */
    std::size_t tableWidth() const { return cutsTables ? width() : 0; }
    /** The width of a value in a table, which leaves room for the columns after it. */
    std::size_t valueWidth() const {
        return cutsTables ? std::min(kWidestValue, std::max<std::size_t>(width() / 3, 12)) : kWidestValue;
    }
    static constexpr std::size_t kWidestValue = 40;

    std::string paint(Style style, const std::string& text) const { return theme.paint(style, text); }
};

/** A word of a line, and where it begins. */
struct Word {
    std::string text;
    std::size_t begin = 0;
};

/** A line to execute: typed, or read from a file. */
struct Input {
    std::string name;  ///< the name of the source of lines, for messages
    unsigned line = 1;
    std::string text;
    std::vector<Word> words = {};

    /** Words are separated by blanks. */
    Input(std::string name, unsigned line, std::string text);
    /** Everything from word `index` on, without blanks at its end. */
    std::string from(std::size_t index) const;
};

/** Writes an error as a compiler does: with its place in the line, the line, and a caret below it. */
void complain(Screen& screen, const Input& input, std::size_t at, const std::string& message);

}  // namespace OCL::console

#endif
