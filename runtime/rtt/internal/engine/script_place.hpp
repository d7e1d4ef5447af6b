// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_SCRIPT_PLACE_HPP
#define ORO_INTERNAL_SCRIPT_PLACE_HPP

#include <rtt/rtt-config.h>

#include <cstddef>

namespace RTT {
namespace internal {

/**
 * While one exists, this thread executes code of an interpreter that knows file and line of the statement. They nest;
 * the innermost counts. `deployer --rt-check` names that line. Real-time safe. Lives on the stack.
 */
class RTT_API ScriptPlace {
public:
    /** Writes "file:line" and a zero, or an empty text, in the thread of the interpreter; neither allocates nor waits.
     */
    typedef void (*Describe)(void* interpreter, char* text, std::size_t size);

    /** With a null function there is no place: the thread executes C++ that the interpreter called. */
    ScriptPlace(Describe describe, void* interpreter) noexcept;
    ~ScriptPlace();
    ScriptPlace(const ScriptPlace&) = delete;
    ScriptPlace& operator=(const ScriptPlace&) = delete;

    /** The place of this thread; an empty text if there is none. */
    static void describe(char* text, std::size_t size) noexcept;

    /** Interpreters that are made from now on know the exact line at each moment, which slows them down. */
    static void wantExact() noexcept;
    static bool isExactWanted() noexcept;

private:
    const Describe describe_;
    void* const interpreter_;
    const ScriptPlace* const outer_;
};

}  // namespace internal
}  // namespace RTT

#endif
