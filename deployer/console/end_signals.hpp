// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_END_SIGNALS_HPP
#define OROFORGE_CONSOLE_END_SIGNALS_HPP

#include <csignal>
#include <vector>

namespace OCL::console {

/** While it exists, the first SIGINT, SIGTERM or SIGHUP makes a descriptor readable; the second ends the process. For
    programs that do not catch these signals themselves. Only one may exist at a time. */
class EndSignals {
public:
    EndSignals();
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    int descriptor() const;

private:
    struct Previous {
        int signal;
        struct sigaction action;
    };
    std::vector<Previous> previous_;
};

}  // namespace OCL::console

#endif
