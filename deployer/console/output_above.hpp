// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Keeps output of other threads out of the line that is being typed.
#ifndef OROFORGE_CONSOLE_OUTPUT_ABOVE_HPP
#define OROFORGE_CONSOLE_OUTPUT_ABOVE_HPP

#include <cstddef>
#include <string>

namespace OCL::console {

/**
 * While it exists, output to std::cout, std::cerr and std::clog appears above the line that is being edited, if these
 * streams go to the terminal. The thread that writes removes the line from the screen and writes before its call
 * returns, so that nothing is lost if the process dies; the editor shows the line again. Only one may exist at a time.
 *
 *     above.lock();                     // only the editor may write now
 *     …draws the line…
 *     above.unlock(rows);               // other threads may write
 *     …waits for a key, or until descriptor() can be read…
 *     if (!above.lock()) …              // the line was removed: draws it again
 *     above.end("");                    // the line is finished
 */
class OutputAbove {
public:
    /** `erases`: the terminal can erase. If it cannot, the line stays and output follows it. */
    explicit OutputAbove(bool erases);
    ~OutputAbove();
    OutputAbove(const OutputAbove&) = delete;
    OutputAbove& operator=(const OutputAbove&) = delete;

    /** Becomes readable when another thread has removed the line. */
    int descriptor() const;

    /** Locks; false if the line is not on the screen. The streams must not be used until unlock() or end(). */
    bool lock();
    /** Moves the cursor to the beginning of a row, to draw the line there. Call it locked. */
    void makeRoom();
    /** Removes the line, of which `above` rows are above the cursor, from the screen. Call it locked. */
    void erase(std::size_t above);
    /** Unlocks. `above` rows of the line are above the cursor; `shown`: it is on the screen. */
    void unlock(std::size_t above, bool shown);
    /** Ends the line and unlocks. Writes `last` after it, and a line end unless there is one already. */
    void end(const std::string& last);
};

}  // namespace OCL::console

#endif
