// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "tcp_server.hpp"

#include <rtt/Logger.hpp>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace OCL::reporting {
namespace {

using std::chrono::milliseconds;

/** How many clients are accepted before others are served again. */
constexpr int kAcceptedAtOnce = 64;
/** When the process has no more files or memory, it accepts nothing for that long. */
constexpr milliseconds kAcceptPause(100);
/** At the end of the report clients have that long to take the last rows. */
constexpr milliseconds kFarewell(200);
/** The places in polled_ before those of the clients. */
constexpr std::size_t kOwnPlaces = 2;

TcpTime now() { return std::chrono::steady_clock::now(); }

}  // namespace

TcpServer::TcpServer(TcpListener listener, const TcpOptions& options, std::shared_ptr<TcpCounts> counts)
    : RTT::Activity(ORO_SCHED_OTHER, 0, 0.0, nullptr, options.component + ".Server"),
      listener_(std::move(listener)),
      options_(options),
      counts_(std::move(counts)),
      wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    polled_.reserve(kOwnPlaces);
}

TcpServer::~TcpServer() {
    if (started_) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            ending_ = true;
        }
        wakeUp();
        done_.wait();
        (void)stop();
    }
    counts_->clients = 0;
}

void TcpServer::fields(const Field& report, const char*, std::size_t) {
    if (row_) return row_->adopt(report);
    row_ = std::make_unique<FrameText>(report);
    started_ = wake_ && start();
    if (!started_) throw std::runtime_error("no thread or no file is left to serve clients");
}

void TcpServer::wakeUp() {
    const std::uint64_t one = 1;
    if (::write(wake_.get(), &one, sizeof one) < 0) {
        // Only a number that cannot grow any more: the thread is being woken.
    }
}

// --- in the thread of the writer of the rows -----------------------------------------------------------------------

bool TcpServer::anyWantsFrames() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::any_of(clients_.begin(), clients_.end(),
                       [](const std::unique_ptr<TcpClient>& client) { return client->session.wantsFrames(); });
}

void TcpServer::row(const char* record, std::size_t size) {
    if (!anyWantsFrames()) return;
    row_->decode(record, size, digits_);
    bool wake = false;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        for (const std::unique_ptr<TcpClient>& client : clients_) wake |= sendFrame(*client);
    }
    if (wake) wakeUp();
}

bool TcpServer::sendFrame(TcpClient& client) {
    if (client.failed() || !client.session.wantsFrames()) return false;
    const short before = client.events();
    // The thread sends what waits already, unless there is so much that this frame could find no room.
    const bool few = client.session.backlog().size() < options_.limits.backlog / 2;
    if (!few) client.send(now());
    const bool waits = !client.session.backlog().empty();
    if (!client.session.addFrame(*row_)) counts_->dropped.fetch_add(1, std::memory_order_relaxed);
    if (!waits) client.send(now());
    return client.failed() || client.events() != before || client.session.ended();
}

// --- in its own thread ---------------------------------------------------------------------------------------------

void TcpServer::loop() {
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
        if (ending_ && !ended_) endAll(now());
        removeClosed(now());
        if (ended_ && clients_.empty()) break;
        choosePolled(now());
        const int limit = timeout(now());
        lock.unlock();
        const int found = ::poll(polled_.data(), polled_.size(), limit);
        lock.lock();
        if (found > 0) serve(now());
    }
    done_.signal();
}

void TcpServer::choosePolled(TcpTime now) {
    const bool accepting = !ended_ && now >= acceptFrom_;
    polled_.clear();
    polled_.push_back({wake_.get(), POLLIN, 0});
    polled_.push_back({accepting ? listener_.socket.get() : -1, POLLIN, 0});
    for (const std::unique_ptr<TcpClient>& client : clients_)
        polled_.push_back({client->socket(), client->events(), 0});
}

int TcpServer::timeout(TcpTime now) const {
    TcpTime next = TcpTime::max();
    if (acceptFrom_ > now) next = acceptFrom_;
    for (const std::unique_ptr<TcpClient>& client : clients_)
        if (client->hasDeadline()) next = std::min(next, client->deadline());
    if (next == TcpTime::max()) return -1;
    const auto left = std::chrono::ceil<milliseconds>(next - now).count();
    return static_cast<int>(std::clamp<std::int64_t>(left, 0, INT_MAX));
}

void TcpServer::serve(TcpTime now) {
    if (polled_[0].revents != 0) {
        std::uint64_t count = 0;
        if (::read(wake_.get(), &count, sizeof count) < 0) {
            // Nothing to take: another event woke the thread.
        }
    }
    for (std::size_t i = kOwnPlaces; i < polled_.size(); ++i) {
        TcpClient& client = *clients_[i - kOwnPlaces];
        try {
            client.serve(polled_[i].revents, now);
        } catch (const std::exception&) {
            client.fail();  // no memory for what it wants
        }
    }
    if (polled_[1].revents != 0 && !ending_) acceptClients(now);
}

void TcpServer::endAll(TcpTime now) {
    ended_ = true;
    listener_.socket.reset();
    for (const std::unique_ptr<TcpClient>& client : clients_) {
        client->end(now + kFarewell);
        client->send(now);
    }
}

void TcpServer::acceptClients(TcpTime now) {
    for (int i = 0; i < kAcceptedAtOnce; ++i) {
        Descriptor socket(::accept4(listener_.socket.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
        if (socket) {
            addClient(std::move(socket), now);
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            return;
        } else if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
            acceptFrom_ = now + kAcceptPause;  // the connection waits; poll() would return at once
            return;
        }  // else that client has gone already
    }
}

void TcpServer::addClient(Descriptor socket, TcpTime now) {
    if (!makePlace(now)) {
        counts_->refused.fetch_add(1, std::memory_order_relaxed);
        if (!std::exchange(told_, true))
            RTT::log(RTT::Warning) << "'" << options_.component << "' refuses a client: it has " << clients_.size()
                                   << " already (see the property max_clients)" << RTT::endlog();
        return;
    }
    try {
        polled_.reserve(clients_.size() + 1 + kOwnPlaces);  // so that prepare() does not allocate
        clients_.push_back(std::make_unique<TcpClient>(std::move(socket), row_->names(), options_.limits, now));
        clients_.back()->send(now);
    } catch (const std::exception&) {
        counts_->refused.fetch_add(1, std::memory_order_relaxed);
    }
    counts_->clients = static_cast<unsigned int>(clients_.size());
}

bool TcpServer::makePlace(TcpTime now) {
    if (clients_.size() < options_.maxClients) return true;
    const auto idle = std::find_if(clients_.begin(), clients_.end(),
                                   [now](const std::unique_ptr<TcpClient>& client) { return client->isIdle(now); });
    if (idle == clients_.end()) return false;
    clients_.erase(idle);
    return true;
}

void TcpServer::removeClosed(TcpTime now) {
    const auto end =
        std::remove_if(clients_.begin(), clients_.end(), [this, now](const std::unique_ptr<TcpClient>& client) {
            return client->done(now) || (ended_ && client->session.backlog().empty());
        });
    clients_.erase(end, clients_.end());
    counts_->clients = static_cast<unsigned int>(clients_.size());
}

}  // namespace OCL::reporting
