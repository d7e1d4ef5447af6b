// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_ENGINE_SLEEP_HPP
#define ORO_INTERNAL_DETAIL_ENGINE_SLEEP_HPP

#include <rtt/ExecutionEngine.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/os/futex.hpp>

#include <algorithm>

namespace RTT {
namespace internal {
namespace detail {

/** The sleep of a thread that waits for messages of an engine, of all engines that it is executing, and perhaps for a
    word. */
class EngineSleep {
public:
    explicit EngineSleep(const EngineGate& gate, const Presence::Word* also = nullptr) : also_(also) {
        add(gate);
        for (const auto* step = EngineGate::Step::innermost(); step; step = step->outer())
            if (const ExecutionEngine* const engine = step->engine()) add(*engine->gate());
    }
    /** Call it before you test the condition. */
    void look() {
        for (unsigned i = 0; i != count_; ++i) points_[i].ticket = points_[i].gate->waitPoint.ticket();
        if (also_) seen_ = *also_;
    }
    /** Sleeps until something has changed since look(). */
    void until(std::int64_t deadline) {
        if (count_ == 1 && !also_ && !more_) return points_[0].gate->waitPoint.wait(points_[0].ticket, deadline);
        os::detail::FutexWord words[os::detail::kMostFutexWords];
        for (unsigned i = 0; i != count_; ++i) {
            words[i].word = &points_[i].gate->waitPoint.word();
            if (!points_[i].gate->waitPoint.arm(points_[i].ticket, words[i].expected)) return;
        }
        if (also_) words[count_] = {also_, seen_};
        os::detail::futexWaitAny(words, count_ + (also_ ? 1 : 0),
                                 more_ ? std::min<std::int64_t>(deadline, rtos_get_time_ns() + 1000000) : deadline);
    }

private:
    void add(const EngineGate& gate) {
        for (unsigned i = 0; i != count_; ++i)
            if (points_[i].gate.get() == &gate) return;
        more_ = count_ == kMost;  // that many nested steps of components
        if (!more_) points_[count_++].gate.reset(&gate);
    }
    struct Point {
        boost::intrusive_ptr<const EngineGate> gate;  // the engines of outer steps may be destroyed meanwhile
        std::uint32_t ticket = 0;
    };
    static constexpr unsigned kMost = os::detail::kMostFutexWords - 1;
    Point points_[kMost];
    unsigned count_ = 0;
    bool more_ = false;
    const Presence::Word* const also_;
    std::uint32_t seen_ = 0;
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
