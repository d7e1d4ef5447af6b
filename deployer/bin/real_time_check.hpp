// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The option --rt-check: reports calls that are not real-time safe in components with a real-time scheduler. And
// --replay-check: those that give something else in each replay, in all components.
#ifndef OROFORGE_DEPLOYER_REAL_TIME_CHECK_HPP
#define OROFORGE_DEPLOYER_REAL_TIME_CHECK_HPP

#include <string>

namespace OCL::deploy {

class ProgramReport;

enum class CheckedFor { RealTime, Replay };

/**
 * Starts the check. It needs a library preloaded before libc, which only the dynamic linker can do at program start. So
 * the first call executes the program anew, with the same words, and does not return. Returns an empty text if the
 * check has started, otherwise why it has not.
 */
std::string startRealTimeCheck(char** words, CheckedFor what);

/** Writes the findings to standard error. True if there are none. */
bool reportRealTimeCheck(ProgramReport& report);

}  // namespace OCL::deploy

#endif
