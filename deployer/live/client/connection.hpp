// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A WebSocket to a deployment. Only connection.cpp knows Boost.Beast.
#ifndef OROFORGE_LIVE_CLIENT_CONNECTION_HPP
#define OROFORGE_LIVE_CLIENT_CONNECTION_HPP

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace oroforge::live_client {

using Clock = std::chrono::steady_clock;
using Deadline = Clock::time_point;
constexpr Deadline kNever = Deadline::max();

/** `ws://HOST:PORT/PATH?token=…` in parts. */
struct Address {
    std::string host, port, target;
};
/** Throws a Failure if the text is no such address. */
Address parseAddress(const std::string& url);

/** For one thread. Errors of the network and broken messages are Failures. */
class Connection {
public:
    enum class Event {
        Message,  ///< a text has arrived
        Bytes,    ///< a binary message has arrived
        Time,     ///< the deadline has passed
        Woken,    ///< a descriptor of wakeOn() is readable
        Broken,   ///< the descriptor of endOn() has nobody at its other end
        Closed    ///< the other side ended the connection
    };

    /** Connects to a socket in the file system. */
    static std::unique_ptr<Connection> toSocket(const std::string& path, Deadline deadline);
    /** Connects to an address of the network. */
    static std::unique_ptr<Connection> toAddress(const Address& address, Deadline deadline);

    virtual ~Connection() = default;
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /** Sends a text. False if that was not possible until the deadline. */
    virtual bool send(const std::string& text, Deadline deadline) = 0;
    /** Waits for the next message; answers pings meanwhile. */
    virtual Event receive(std::string& message, Deadline deadline) = 0;
    /** receive() also ends when one of these descriptors is readable, which they stay until they are read; those of an
        earlier call mean nothing then. */
    virtual void wakeOn(const std::vector<int>& descriptors) = 0;
    /** receive() also ends when the reader of this pipe has gone. Other files are never in that state. */
    virtual void endOn(int descriptor) = 0;
    /** Why the connection ended, for a message. */
    virtual std::string reason() const = 0;

protected:
    Connection() = default;
};

}  // namespace oroforge::live_client

#endif
