// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Standard output of oro.
#ifndef OROFORGE_LIVE_CLIENT_OUTPUT_HPP
#define OROFORGE_LIVE_CLIENT_OUTPUT_HPP

#include <console/table.hpp>
#include <console/theme.hpp>

#include <cstddef>
#include <string>

namespace oroforge::live_client {

using OCL::console::Style;
using OCL::console::Table;
using OCL::console::Theme;

class Output {
public:
    /** Writes to the descriptor; has colours and a width if that is a terminal. */
    explicit Output(int descriptor);

    /** Writes all of the text at once. Throws NobodyReads if the reader has gone, and a Failure if the disk is full. */
    void write(const std::string& text);
    /** Writes the text and the end of the line. */
    void line(const std::string& text) { write(text + "\n"); }
    /** Writes the rows of a table, cut to the width of the terminal. */
    void table(const Table& table, const std::string& indent = "");

    bool isTerminal() const { return terminal_; }
    /** The letters of a line and the lines, as the terminal has them now; what is usual without a terminal. */
    std::size_t width() const { return size(true); }
    std::size_t height() const { return size(false); }
    /** The width of tables; 0 (no limit) without a terminal. */
    std::size_t tableWidth() const { return terminal_ ? width() : 0; }
    const Theme& theme() const { return theme_; }
    std::string paint(Style style, const std::string& text) const { return theme_.paint(style, text); }
    int descriptor() const { return descriptor_; }

private:
    std::size_t size(bool ofLine) const;

    const int descriptor_;
    const bool terminal_;
    const Theme theme_;
};

/** The text without control characters, which could do anything to a terminal; on one line. */
std::string printable(const std::string& text);

}  // namespace oroforge::live_client

#endif
