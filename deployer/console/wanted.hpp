// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_WANTED_HPP
#define OROFORGE_CONSOLE_WANTED_HPP

#include <cstdlib>

#include <termios.h>
#include <unistd.h>

namespace OCL::console {

/** False if nobody types and no commands come: standard input is a terminal that controls another session, as under
    roslaunch, whose user types for another program; or ORO_NO_CONSOLE is set and not empty. */
inline bool isWanted() {
    const char* const none = std::getenv("ORO_NO_CONSOLE");
    if (none && *none) return false;
    return !isatty(STDIN_FILENO) || tcgetsid(STDIN_FILENO) >= 0;
}

}  // namespace OCL::console

#endif
