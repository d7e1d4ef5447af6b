// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Lines that are typed at a terminal: the only place with libedit.
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

/** The letters that fit into a line of the terminal; 100 if that is none. */
std::size_t widthOfTerminal();

/**
 * Edits on standard input and output, with history, search in it (Ctrl-R) and completion (TAB). Ctrl-C drops the line; it is a
 * key while a line is typed, and a signal while a command is executed. Other keys are not shown then, and are taken with the next
 * line. Ends on Ctrl-D and as soon as `endsOn` (−1: none) can be read. One at a time.
 */
class LineEditor final : public LineSource {
public:
    typedef std::function<Completion(const std::string& line)> Complete;
    LineEditor(History& history, Complete complete, int endsOn);
    ~LineEditor() override;

    /** The prompt may have colours. Lines are added to the history. */
    Outcome read(const std::string& prompt, std::string& line) override;
    /** Those that were pasted. */
    void forget() override;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace OCL::console

#endif
