// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_PORT_PROBE_HPP
#define OROFORGE_CONSOLE_PORT_PROBE_HPP

#include <rtt/TaskContext.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

namespace OCL::console {

/**
 * Looks at the samples of an output port by a connection of its own, which ends with it. While it exists, write() of
 * the port serves one more channel and takes a time stamp, without allocation, lock or wait. The port may be destroyed
 * meanwhile. One thread at a time.
 */
class PortProbe {
public:
    /** The times between samples, taken in the thread that writes, in ns. */
    struct Intervals {
        std::uint64_t samples = 0;
        std::int64_t first = 0, last = 0;        ///< monotonic times; 0: there was no sample
        std::int64_t shortest = 0, longest = 0;  ///< valid from two samples on
    };

    enum class From { LastSample, NextSample };  ///< the first one; the last written one if the port keeps it
    /** Connects. Null, with the reason, if it cannot. The port must exist during the call. Takes the lock of
        connections, and allocates. */
    static std::unique_ptr<PortProbe> make(RTT::base::OutputPortInterface& port, From from, std::string& why);
    ~PortProbe();
    PortProbe(const PortProbe&) = delete;
    PortProbe& operator=(const PortProbe&) = delete;

    /** False if the port was destroyed, or somebody disconnected it. */
    bool isConnected() const { return port_->connected(); }
    /** Sets value() to the next sample; false if there is none. */
    bool read() { return port_->read(value_, false) == RTT::NewData; }
    const RTT::base::DataSourceBase::shared_ptr& value() const { return value_; }
    /** Samples that found no room, because read() was not called for too long. */
    std::uint64_t dropped() const;
    Intervals intervals() const { return meter_.intervals(); }

private:
    /** Belongs to no deployment and never runs; only its hook is called. */
    class Meter final : public RTT::TaskContext {
    public:
        Meter() : TaskContext("console") {}
        ~Meter() override { stopForGood(); }
        Intervals intervals() const;

    private:
        /** In the thread that writes. Real-time safe. */
        bool dataOnPortHook(RTT::base::PortInterface*) override;

        std::atomic<std::uint64_t> samples_{0};
        std::atomic<std::int64_t> first_{0}, last_{0}, shortest_{INT64_MAX}, longest_{0};
    };

    explicit PortProbe(RTT::base::DataSourceBase::shared_ptr value) : value_(std::move(value)) {}

    const RTT::base::DataSourceBase::shared_ptr value_;
    Meter meter_;
    std::unique_ptr<RTT::base::InputPortInterface> port_;
};

}  // namespace OCL::console

#endif
