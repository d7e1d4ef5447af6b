// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Lines that are typed on a terminal.
#ifndef OROFORGE_LIVE_CLIENT_PROMPT_HPP
#define OROFORGE_LIVE_CLIENT_PROMPT_HPP

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace oroforge::live_client {

/** How a line can go on. */
struct Words {
    std::vector<std::string> words;  ///< in place of its end
    std::string more;                ///< what can be added without a choice
};

/** Reads lines on standard input and output, with history and completion. Ctrl-C is a key that drops the line. Only one
    may exist. */
class Prompt {
public:
    enum class Outcome { Line, Dropped, End };
    /** Returns when standard input has a key, and throws if there will be no more lines. */
    typedef std::function<void()> Wait;
    typedef std::function<Words(const std::string& line)> Complete;

    Prompt(Wait wait, Complete complete);
    ~Prompt();

    /** Reads a line. Throws what `wait` and `complete` throw; the terminal is as before then. */
    Outcome read(const std::string& prompt, std::string& line);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace oroforge::live_client

#endif
