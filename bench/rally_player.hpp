// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component that sends each sample back.
#ifndef OROFORGE_BENCH_RALLY_PLAYER_HPP
#define OROFORGE_BENCH_RALLY_PLAYER_HPP

#include "futex_floor.hpp"
#include "pairs.hpp"

#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>

#include <atomic>
#include <cstdint>
#include <ctime>
#include <string>

namespace bench {

/** Answers each sample; as the one that serves, only until the rally is over. */
class RallyPlayer : public RTT::TaskContext {
public:
    explicit RallyPlayer(const std::string& name) : TaskContext(name) {
        addEventPort("in", in, [this](RTT::base::PortInterface*) { answer(); });
        addPort("out", out);
    }
    ~RallyPlayer() override { stop(); }
    /** Seconds of a round trip. */
    double rally() {
        over_ = 0;
        left_ = kRoundTrips;
        const double begin = seconds(CLOCK_MONOTONIC);
        out.write(1.0);
        futexWait(over_, 0);
        return (end_ - begin) / kRoundTrips;
    }

    RTT::InputPort<double> in;
    RTT::OutputPort<double> out{"out", false};

private:
    void answer() {
        double sample;
        if (in.read(sample) != RTT::NewData) return;
        if (left_ == 0 || --left_ > 0) {
            out.write(sample);
            return;
        }
        end_ = seconds(CLOCK_MONOTONIC);
        futexSet(over_, 1);
    }

    int left_ = 0;
    double end_ = 0;
    std::atomic<std::uint32_t> over_{0};
};

}  // namespace bench

#endif
