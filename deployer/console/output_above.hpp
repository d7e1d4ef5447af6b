// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Keeps what other threads write out of the line that is being typed.
#ifndef OROFORGE_CONSOLE_OUTPUT_ABOVE_HPP
#define OROFORGE_CONSOLE_OUTPUT_ABOVE_HPP

#include <cstddef>
#include <string>

namespace OCL::console {

/**
 * While it lives, what is written to std::cout, std::cerr and std::clog, as far as these go to the terminal, stands above the
 * line that is being edited. Whoever writes takes the line from the screen and writes before the call returns, so that nothing
 * is lost if the process dies; the editor shows the line again. One at a time.
 *
 *     above.lock();                     // from now on only the editor writes
 *     …draws the line…
 *     above.unlock(rows);               // while it waits, others may
 *     …waits for a key, or until descriptor() can be read…
 *     if (!above.lock()) …              // the line is gone: it draws it again
 *     above.end("");                    // the line is finished
 */
class OutputAbove {
public:
    /** `erases`: the terminal can erase; else the line stays as it is, and what is written follows. */
    explicit OutputAbove(bool erases);
    ~OutputAbove();
    OutputAbove(const OutputAbove&) = delete;
    OutputAbove& operator=(const OutputAbove&) = delete;

    /** Can be read once somebody has taken the line away. */
    int descriptor() const;

    /** False if the line is not on the screen. The streams must not be used until unlock() or end(). */
    bool lock();
    /** The cursor is to be at the beginning of a row, because the line is to be drawn. Locked. */
    void makeRoom();
    /** Takes the line, of which `above` rows are above the cursor, from the screen. Locked. */
    void erase(std::size_t above);
    /** `above` rows of the line are above the cursor; `shown`: it is on the screen. */
    void unlock(std::size_t above, bool shown);
    /** Unlocks; there is no line any more. `last` is what is written behind it, with an end of line unless that is there already. */
    void end(const std::string& last);
};

}  // namespace OCL::console

#endif
