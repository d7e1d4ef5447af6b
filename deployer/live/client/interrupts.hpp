// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ctrl-C of commands that last.
#ifndef OROFORGE_LIVE_CLIENT_INTERRUPTS_HPP
#define OROFORGE_LIVE_CLIENT_INTERRUPTS_HPP

namespace oroforge::live_client {

/** While it exists, SIGINT, SIGTERM and SIGHUP make a descriptor readable instead of ending the process. Only one may
    exist. */
class Interrupts {
public:
    Interrupts();
    ~Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

    int descriptor() const;
    /** Whether a signal came since the last call; the descriptor is not readable afterwards. */
    bool take();
    /** Whether a signal other than SIGINT came, ever. */
    bool mustEnd() const;
};

}  // namespace oroforge::live_client

#endif
