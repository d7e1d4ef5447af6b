// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_TCP_CLIENT_HPP
#define ORO_OCL_REPORTING_TCP_CLIENT_HPP

#include "descriptor.hpp"
#include "tcp_session.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace OCL::reporting {

typedef std::chrono::steady_clock::time_point TcpTime;

/** The socket of a client and its session. No function blocks. Used by one thread at a time. */
class TcpClient {
public:
    TcpClient(Descriptor socket, const std::vector<std::string>& names, const TcpLimits& limits, TcpTime now);
    ~TcpClient();
    TcpClient(const TcpClient&) = delete;
    TcpClient& operator=(const TcpClient&) = delete;

    TcpSession session;

    int socket() const { return socket_.get(); }
    /** Sends and receives after poll() found these events. */
    void serve(short events, TcpTime now);
    /** Sends as much of the backlog as the socket takes. */
    void send(TcpTime now);
    /** The connection is of no use any more. */
    void fail() { failed_ = true; }
    bool failed() const { return failed_; }
    /** What poll() should look for. */
    short events() const;
    /** The time at which the client is closed even if it takes nothing, if that is set. */
    bool hasDeadline() const { return session.ended(); }
    TcpTime deadline() const { return closeBy_; }
    /** True if the socket can be closed. */
    bool done(TcpTime now) const;
    /** Closes when the backlog is sent, at the latest at that time. */
    void end(TcpTime latest);
    /** True for a client whose place another one may get: it has not said VERSION or taken its data for a while, or can
        send nothing any more. */
    bool isIdle(TcpTime now) const;

private:
    void receive(TcpTime now);
    void shutDown();

    Descriptor socket_;
    const TcpTime connected_;
    TcpTime lastTaken_;  // when the backlog was empty or became shorter
    TcpTime closeBy_{};
    bool failed_ = false;      // the connection
    bool inputEnded_ = false;  // the client sends nothing any more, but may still receive
    bool outputEnded_ = false;
};

}  // namespace OCL::reporting

#endif
