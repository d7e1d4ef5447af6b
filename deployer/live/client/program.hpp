// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_CLIENT_PROGRAM_HPP
#define OROFORGE_LIVE_CLIENT_PROGRAM_HPP

#include <string>
#include <vector>

namespace oroforge::live_client {

/** Does what the words behind `oro` say, and returns the exit status. Errors go to standard error. */
int runProgram(const std::vector<std::string>& words);

}  // namespace oroforge::live_client

#endif
