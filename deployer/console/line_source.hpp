// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Where the console gets its lines from.
#ifndef OROFORGE_CONSOLE_LINE_SOURCE_HPP
#define OROFORGE_CONSOLE_LINE_SOURCE_HPP

#include <string>

namespace OCL::console {

class LineSource {
public:
    enum class Outcome {
        Line,
        Dropped,  ///< the user gave up the line, and whatever it belongs to
        End       ///< of the input, or the console is to end
    };
    virtual ~LineSource() = default;
    /** Blocks until there is one. The line has no end of line. */
    virtual Outcome read(const std::string& prompt, std::string& line) = 0;
    /** Forgets lines that came together with the last one. */
    virtual void forget() {}
};

/** Lines of a descriptor that is no terminal; shows no prompt. Ends as soon as `endsOn` (−1: none) can be read. */
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
    Input,   ///< it can be read, or has no more
    Other,   ///< the other descriptor can be read
    Time,    ///< neither, for so long
    Signal,  ///< came
    End      ///< of the console
};
/** Without waiting; false for negative descriptors. */
bool isReadable(int descriptor);
/** Waits for one of them. Negative descriptors are none; a negative time has no end. */
Wake waitForInput(int input, int endsOn, int other = -1, int milliseconds = -1);

}  // namespace OCL::console

#endif
