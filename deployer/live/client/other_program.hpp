// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_CLIENT_OTHER_PROGRAM_HPP
#define OROFORGE_LIVE_CLIENT_OTHER_PROGRAM_HPP

#include <string>
#include <vector>

namespace oroforge::live_client {

/** Becomes another program of the toolchain, which is beside this one. A Failure if it is not there. */
[[noreturn]] void runOther(const std::string& program, const std::vector<std::string>& words);

}  // namespace oroforge::live_client

#endif
