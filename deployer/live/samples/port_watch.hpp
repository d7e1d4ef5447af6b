// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_PORT_WATCH_HPP
#define OROFORGE_LIVE_PORT_WATCH_HPP

#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/encoding/Json.hpp>
#include <rtt/encoding/Plan.hpp>
#include <rtt/internal/flow/port_sources.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace OCL::live {

/** How samples are given. */
enum class SampleForm { Json, Cdr };

/**
 * A port that is watched. If only the newest sample is wanted, and the port keeps its last one, that is read, and
 * write() does not notice. Otherwise it has a connection of its own: write() serves one more channel. The port may be
 * destroyed meanwhile. One thread at a time.
 */
class PortWatch {
public:
    /** Of the other end, in lists of connections. It belongs to no component. */
    static constexpr char kName[] = "live window";
    struct Options {
        SampleForm form = SampleForm::Json;
        /** So many samples wait for read(), older ones are dropped; 0: only the newest. Fewer, if the present sample
            is so large that they would need more than 8 MiB. */
        unsigned buffer = 0;
        /** The time of each write is kept: write() reads the clock. Only with a buffer. */
        bool times = false;
        /** Whose it is: one watcher has at most 4 watches of a port, all together 32, because write() serves each. */
        std::uint64_t watcher = 0;
    };

    /** Connects. Null, with the reason, if the port's type has no such form or the port takes no connection. The port
        must exist during the call. Takes the lock of connections, and allocates. */
    static std::unique_ptr<PortWatch> make(RTT::base::OutputPortInterface& port, const Options& options,
                                           std::string& why);
    ~PortWatch();
    PortWatch(const PortWatch&) = delete;
    PortWatch& operator=(const PortWatch&) = delete;

    /** False if the port was destroyed, somebody disconnected it, or it keeps its last sample no longer. */
    bool isConnected() const { return port_ ? port_->connected() : link_->keepsLast(); }
    /** Reads the next new sample; false if there is none. Empty if its value cannot be encoded. */
    bool read(std::string& encoded);
    /** When the sample that was read last was written, with the option `times`; otherwise now. ns since 1970. */
    std::int64_t time() const;
    /** Samples that found no room since the beginning. */
    std::uint64_t dropped() const;

    const std::string& type() const { return type_; }
    /** Of the type's fields, with SampleForm::Cdr. */
    std::uint64_t fingerprint() const { return plan_ ? plan_->fingerprint() : 0; }
    /** The value that read() sets; for its members. */
    RTT::base::DataSourceBase& value() const { return *value_; }

private:
    class Seat;
    explicit PortWatch(RTT::base::DataSourceBase::shared_ptr value);
    bool connect(RTT::base::OutputPortInterface& port, const Options& options);
    bool connectOnce(RTT::base::OutputPortInterface& port, unsigned buffer);
    bool take();

    std::unique_ptr<RTT::base::InputPortInterface> port_;  // null: the last sample of the watched port is read
    RTT::base::ChannelElementBase::shared_ptr storage_;    // of the connection
    std::unique_ptr<const RTT::internal::PortLink> link_;  // to the watched port, if port_ is null
    std::uint64_t seen_ = 0;                               // which sample was read through the link
    bool times_ = false;
    std::int64_t begin_ = 0, written_ = 0;  // of this watch; of the sample that was read last
    const RTT::base::DataSourceBase::shared_ptr value_;
    void* const address_;
    const std::string type_;
    std::unique_ptr<const Seat> seat_;
    std::shared_ptr<const RTT::encoding::Json> json_;
    std::shared_ptr<const RTT::encoding::Plan> plan_;
};

}  // namespace OCL::live

#endif
