// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where the console writes, and how.
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
    /** Letters in a line. */
    std::function<std::size_t()> width = [] { return std::size_t(100); };
    bool cutsTables = false;  ///< at the end of the line, as a terminal needs it
    bool failed = false;      ///< a line could not be executed

    /** Of tables; 0: as wide as they are. */
    std::size_t tableWidth() const { return cutsTables ? width() : 0; }
    /** Of a value in a table, so that what is behind it has room. */
    std::size_t valueWidth() const {
        return cutsTables ? std::min(kWidestValue, std::max<std::size_t>(width() / 3, 12)) : kWidestValue;
    }
    static constexpr std::size_t kWidestValue = 40;

    std::string paint(Style style, const std::string& text) const { return theme.paint(style, text); }
};

/** A word of the line that is being executed, and where it begins. */
struct Word {
    std::string text;
    std::size_t begin = 0;
};

/** One line that was typed. */
struct Input {
    std::string name;  ///< of where lines come from, for messages
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
