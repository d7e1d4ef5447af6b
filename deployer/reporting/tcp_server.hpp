// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_TCP_SERVER_HPP
#define ORO_OCL_REPORTING_TCP_SERVER_HPP

#include "frame_text.hpp"
#include "row_sink.hpp"
#include "tcp_client.hpp"
#include "tcp_listener.hpp"
#include "tcp_session.hpp"

#include <rtt/Activity.hpp>
#include <rtt/os/Semaphore.hpp>

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <poll.h>
#include <string>
#include <vector>

namespace OCL::reporting {

/** What a server counts; any thread may read it, also when the server has gone. */
struct TcpCounts {
    std::atomic<unsigned int> clients{0};  ///< now
    std::atomic<unsigned int> refused{0};  ///< clients for which there was no place
    std::atomic<unsigned int> dropped{0};  ///< frames
};

struct TcpOptions {
    std::string component;
    unsigned int maxClients = 32;
    TcpLimits limits;
};

/**
 * Serves a report to clients.
 *
 *     writer of the rows: record ──FrameText──► TcpSession of each client ──► its socket, as far as that takes it
 *     own thread, in poll(): new clients, commands, what the sockets did not take
 *
 * Sockets never block, so no client makes a thread wait. Both threads use the clients under a lock; only the own thread
 * opens and closes sockets.
 */
class TcpServer final : public RowSink, private RTT::Activity {
public:
    TcpServer(TcpListener listener, const TcpOptions& options, std::shared_ptr<TcpCounts> counts);
    /** Disconnects all clients when they have taken what waits for them, at the latest after 0.2 s. */
    ~TcpServer() override;

    void prepare(const RowOptions& options) override { digits_ = options.digits; }
    /** The first time, starts the thread; throws if that is not possible. */
    void fields(const Field& report, const char* record, std::size_t size) override;
    /** Sends the row; nothing waits for write(). */
    void row(const char* record, std::size_t size) override;
    std::size_t waiting() const override { return 0; }
    std::string write() override { return {}; }
    unsigned long rows() const override { return 0; }
    /** Clients may lose frames anyway. */
    std::chrono::milliseconds patience() const override { return std::chrono::seconds(2); }
    std::string name() const override { return "TCP port " + std::to_string(listener_.port); }

private:
    void loop() override;
    bool breakLoop() override { return true; }

    bool anyWantsFrames();
    /** True if poll() must look for other events of the client now. */
    bool sendFrame(TcpClient& client);
    // Called with the lock, by the thread:
    /** Fills polled_. */
    void choosePolled(TcpTime now);
    /** In milliseconds, for poll(). */
    int timeout(TcpTime now) const;
    /** Serves what poll() found. */
    void serve(TcpTime now);
    void endAll(TcpTime now);
    void acceptClients(TcpTime now);
    void addClient(Descriptor socket, TcpTime now);
    /** Makes a place for one more; false if all clients are in use. */
    bool makePlace(TcpTime now);
    void removeClosed(TcpTime now);
    void wakeUp();

    TcpListener listener_;
    const TcpOptions options_;
    const std::shared_ptr<TcpCounts> counts_;
    const Descriptor wake_;  // an eventfd
    int digits_ = 6;
    bool started_ = false;
    std::unique_ptr<FrameText> row_;  // text: the writer's; names: both

    std::mutex mutex_;  // guards what follows
    std::vector<std::unique_ptr<TcpClient>> clients_;
    bool ending_ = false;
    // Used only by the thread:
    std::vector<pollfd> polled_;
    TcpTime acceptFrom_{};  // not before
    bool ended_ = false;    // endAll() was called
    bool told_ = false;     // that a client was refused
    RTT::os::Semaphore done_{0};
};

}  // namespace OCL::reporting

#endif
