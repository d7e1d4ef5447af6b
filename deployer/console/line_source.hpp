// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Sources of lines for the console.
#ifndef OROFORGE_CONSOLE_LINE_SOURCE_HPP
#define OROFORGE_CONSOLE_LINE_SOURCE_HPP

#include <string>

namespace OCL::console {

class LineSource {
public:
    enum class Outcome {
        Line,
        Dropped,  ///< the user dropped the line and the unfinished piece around it
        End       ///< the input has ended, or the console must end
    };
    virtual ~LineSource() = default;
    /** Blocks until there is a line, which is returned without its line end. */
    virtual Outcome read(const std::string& prompt, std::string& line) = 0;
    /** Forgets lines that arrived together with the last one. */
    virtual void forget() {}
};

/** Lines of a descriptor that is not a terminal, without a prompt. Ends when `endsOn` (−1: none) becomes readable. */
class InputLines final : public LineSource {
public:
    InputLines(int input, int endsOn) : input_(input), ends_on_(endsOn) {}
    Outcome read(const std::string& prompt, std::string& line) override;

private:
    const int input_, ends_on_;
    std::string pending_;
    bool at_end_ = false;
};

enum class Wake {
    Input,   ///< the input can be read, or has ended
    Other,   ///< the other descriptor can be read
    Time,    ///< the time is over
    Signal,  ///< a signal came
    End      ///< the console must end
};
/** True if the descriptor can be read now; false if it is negative. */
bool isReadable(int descriptor);
/** Waits for one of these. Ignores negative descriptors; a negative time has no end. */
Wake waitForInput(int input, int endsOn, int other = -1, int milliseconds = -1);

}  // namespace OCL::console

#endif
