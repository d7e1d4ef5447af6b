// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The option --rt-check: what components with a real-time scheduler do in updateHook() that they must not do.
#ifndef OROFORGE_DEPLOYER_REAL_TIME_CHECK_HPP
#define OROFORGE_DEPLOYER_REAL_TIME_CHECK_HPP

#include <string>

namespace OCL::deploy {

class ProgramReport;

/**
 * Begins to watch. A library has to stand in front of libc for that, which the dynamic linker arranges when a program
 * starts: the first call executes the program anew, with the same words, and does not return. Empty if the watch has begun,
 * else why it has not.
 */
std::string startRealTimeCheck(char** words);

/** Writes what was found to standard error. True if there was nothing. */
bool reportRealTimeCheck(ProgramReport& report);

}  // namespace OCL::deploy

#endif
