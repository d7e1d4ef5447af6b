// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reads lines from a terminal.
#ifndef OROFORGE_CONSOLE_LINE_EDITOR_HPP
#define OROFORGE_CONSOLE_LINE_EDITOR_HPP

#include "completion.hpp"
#include "history.hpp"
#include "line_source.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

namespace OCL::console {

/** The letters in a row of the terminal; 100 if there is no terminal. */
std::size_t widthOfTerminal();

/**
 * Edits lines on standard input and output, with history, search in it (Ctrl-R) and completion (TAB). While a line is
 * typed, Ctrl-C is a key that drops the line; while a command is executed, it is a signal. Keys pressed during a
 * command go into the next line and are not shown before, unless `Echo::Always`. Ends at Ctrl-D and when `endsOn`
 * (−1: none) becomes readable. Only one may exist.
 */
class LineEditor final : public LineSource {
public:
    typedef std::function<Completion(const std::string& line)> Complete;
    enum class Echo { Lines, Always };  ///< Always: for commands that read the terminal themselves
    LineEditor(History& history, Complete complete, int endsOn, Echo echo = Echo::Lines);
    ~LineEditor() override;

    /** Reads a line and adds it to the history. The prompt may have colours. */
    Outcome read(const std::string& prompt, std::string& line) override;
    /** Forgets lines that were pasted. */
    void forget() override;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace OCL::console

#endif
