// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "tcp_client.hpp"

#include <cerrno>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <utility>

namespace OCL::reporting {
namespace {

/** One read; more comes with the next turn, so that a client that never pauses does not keep others waiting. */
constexpr std::size_t kChunk = 4096;
constexpr int kLastReads = 64;
/** A client has that long after QUIT to take what waits for it. */
constexpr std::chrono::seconds kFarewell(2);
/** After that time a client that does nothing may lose its place to another one. */
constexpr std::chrono::seconds kIdle(5);
/** A computer that has gone without a word is noticed after about that time, in seconds. */
constexpr int kKeepAlive = 60;

void set(int socket, int level, int option, int value) {
    (void)::setsockopt(socket, level, option, &value, sizeof value);
}

bool wouldBlock(int error) { return error == EAGAIN || error == EWOULDBLOCK; }

}  // namespace

TcpClient::TcpClient(Descriptor socket, const std::vector<std::string>& names, const TcpLimits& limits, TcpTime now)
    : session(names, limits), socket_(std::move(socket)), connected_(now), lastTaken_(now) {
    set(socket_.get(), IPPROTO_TCP, TCP_NODELAY, 1);
    set(socket_.get(), SOL_SOCKET, SO_KEEPALIVE, 1);
    set(socket_.get(), IPPROTO_TCP, TCP_KEEPIDLE, kKeepAlive);
}

TcpClient::~TcpClient() {
    // Closing a socket with unread input would destroy what the client has not received yet.
    char bytes[kChunk];
    for (int i = 0; i<kLastReads&& ::recv(socket_.get(), bytes, sizeof bytes, MSG_DONTWAIT)> 0; ++i) {
    }
}

void TcpClient::serve(short events, TcpTime now) {
    if ((events & POLLERR) != 0 || ((events & POLLHUP) != 0 && inputEnded_)) return fail();
    if ((events & (POLLIN | POLLHUP)) != 0) receive(now);
    if (events != 0) send(now);
}

void TcpClient::receive(TcpTime now) {
    char bytes[kChunk];
    const ssize_t count = ::recv(socket_.get(), bytes, sizeof bytes, 0);
    if (count > 0) {
        const bool before = session.ended();
        session.receive(std::string_view(bytes, static_cast<std::size_t>(count)));
        if (!before && session.ended()) closeBy_ = now + kFarewell;
    } else if (count == 0) {
        inputEnded_ = true;
    } else if (!wouldBlock(errno) && errno != EINTR) {
        failed_ = true;
    }
}

void TcpClient::send(TcpTime now) {
    const bool before = session.ended();
    while (!failed_ && !session.backlog().empty()) {
        const std::string_view waiting = session.backlog();
        const ssize_t count = ::send(socket_.get(), waiting.data(), waiting.size(), MSG_NOSIGNAL);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) {
            failed_ = !wouldBlock(errno);
            break;
        }
        lastTaken_ = now;
        session.sent(static_cast<std::size_t>(count));
    }
    if (session.backlog().empty()) lastTaken_ = now;
    if (!before && session.ended()) closeBy_ = now + kFarewell;
    if (session.ended() && session.backlog().empty()) shutDown();
}

/** Says to the client that nothing more comes. A close at once could destroy what is still on its way. */
void TcpClient::shutDown() {
    if (!std::exchange(outputEnded_, true)) (void)::shutdown(socket_.get(), SHUT_WR);
}

short TcpClient::events() const {
    int events = 0;
    if (!inputEnded_ && (session.ended() || !session.full())) events |= POLLIN;
    if (!session.backlog().empty()) events |= POLLOUT;
    return static_cast<short>(events);
}

bool TcpClient::done(TcpTime now) const {
    if (failed_) return true;
    if (session.ended() && (now >= closeBy_ || (outputEnded_ && inputEnded_))) return true;
    // Nobody can subscribe any more.
    return inputEnded_ && session.backlog().empty() && !session.wantsFrames();
}

void TcpClient::end(TcpTime latest) {
    session.end();
    closeBy_ = latest;
}

bool TcpClient::isIdle(TcpTime now) const {
    if (inputEnded_) return true;
    if (!session.greeted()) return now - connected_ >= kIdle;
    return !session.backlog().empty() && now - lastTaken_ >= kIdle;
}

}  // namespace OCL::reporting
