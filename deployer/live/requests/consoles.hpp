// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_CONSOLES_HPP
#define OROFORGE_LIVE_CONSOLES_HPP

#include "lookup.hpp"
#include "ticket.hpp"

#include <map>
#include <memory>
#include <string>

namespace OCL::live {

/** A console for each client that types lines, in a thread of its own, so that a line may take as long as it likes.
    What code writes to standard output itself goes there, not to the client. Used by one thread. */
class Consoles {
public:
    explicit Consoles(Root root) : root_(std::move(root)) {}
    /** Interrupts all lines and waits for none. */
    ~Consoles();
    Consoles(const Consoles&) = delete;
    Consoles& operator=(const Consoles&) = delete;

    // Each answers the ticket. They throw Failure.
    /** {out, err, prompt, quits, interrupted} */
    void line(const std::shared_ptr<Ticket>& ticket);
    /** {begin, words, more} */
    void complete(const std::shared_ptr<Ticket>& ticket);
    /** Stops the line of this client that is being executed, if it is a script or waits for one. */
    void interrupt(const std::shared_ptr<Ticket>& ticket);
    void left(const std::string& caller);

    struct Session;

private:
    Session& sessionOf(const std::string& caller);

    const Root root_;
    std::map<std::string, std::shared_ptr<Session>> sessions_;
};

}  // namespace OCL::live

#endif
