// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_TRANSPORT_HPP
#define OROFORGE_LIVE_TRANSPORT_HPP

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace OCL::live {

/** A message to a client. */
struct Frame {
    std::string bytes;
    bool isBinary = false;
};

/** What an HTTP request begins with. */
struct RequestHead {
    bool isLocal = false;  ///< it came through the Unix socket
    bool isUpgrade = false;
    std::string method, target, host, origin, authorization, protocols;
};

/** The answer to it: 101 opens the WebSocket, any other status is sent with the text. */
struct Verdict {
    unsigned status = 101;
    std::string text;
    std::string protocol;  ///< of the WebSocket; empty: none
};

/** The side of the transport of one client. Its functions may be called by the thread of the transport only. */
class Link {
public:
    /** There may be something to send. */
    virtual void wake() = 0;

protected:
    ~Link() = default;
};

/** One client, as long as its WebSocket is open. All functions are called by the thread of the transport. */
class Client {
public:
    virtual ~Client() = default;
    virtual void receive(std::string_view message, bool isBinary) = 0;
    /** Moves the next message out, if there is one; called when the socket can take more. */
    virtual bool next(Frame& frame) = 0;
    /** Nothing is received until it has got rid of what it has to send. */
    virtual bool isFull() const = 0;
};

/** Decides on clients. Called by the thread of the transport. */
class Reception {
public:
    virtual Verdict judge(const RequestHead& head) = 0;
    /** `name`: "process 4711 of user 1000", "127.0.0.1:51234" */
    virtual std::unique_ptr<Client> welcome(const RequestHead& head, const std::string& protocol,
                                            const std::string& name, Link& link) = 0;
    /** Called once in each period that was set by tick(). */
    virtual void onTick() = 0;

protected:
    ~Reception() = default;
};

/**
 * WebSockets over sockets of any kind, in one thread.
 *
 * At most 16 clients of the Unix socket and 16 others are served. A handshake that takes longer than 10 s is ended;
 * if more than 32 are in progress, so is the oldest. A message of more than 64 KiB ends the connection.
 */
class Transport {
public:
    explicit Transport(Reception& reception);
    ~Transport();
    Transport(const Transport&) = delete;
    Transport& operator=(const Transport&) = delete;

    /** Takes ownership of a socket that listens. Before run(). */
    void listen(int socket, bool isLocal);
    /** Takes ownership of one that is connected. Before run(). */
    void add(int socket, bool isLocal);
    /** Serves until stop() was called and the clients have had 0.2 s to take the farewell. */
    void run();
    void stop();
    /** Calls the function in the thread of the transport. Any thread. */
    void post(std::function<void()> function);
    /** Calls Reception::onTick() with this period from now on; 0: not any more. Only in the thread of the transport. */
    void tick(std::chrono::milliseconds period);

private:
    class Impl;
    const std::unique_ptr<Impl> impl_;
};

}  // namespace OCL::live

#endif
