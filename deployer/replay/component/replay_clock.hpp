// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPLAY_REPLAY_CLOCK_HPP
#define OROFORGE_REPLAY_REPLAY_CLOCK_HPP

#include <rtt/Time.hpp>

#include <limits>

namespace OCL::replay {

/** Which recorded time it is. Times are in ns; those of the caller may be of any clock. */
class ReplayClock {
public:
    /** A speed of 0 is as fast as possible: every recorded time has come. */
    void begin(RTT::nsecs recorded, RTT::nsecs now, double speed) {
        recorded_ = recorded;
        since_ = now;
        speed_ = speed;
        stands_ = false;
    }
    /** Goes on from here with another speed. */
    void setSpeed(RTT::nsecs now, double speed) {
        if (speed == speed_) return;
        recorded_ = speed_ > 0 && !stands_ ? at(now) : recorded_;
        since_ = now;
        speed_ = speed;
    }
    void stop(RTT::nsecs now) {
        if (speed_ > 0 && !stands_) recorded_ = at(now);
        stands_ = true;
    }
    void goOn(RTT::nsecs now) {
        since_ = now;
        stands_ = false;
    }
    /** Stands at that time. */
    void moveTo(RTT::nsecs recorded, RTT::nsecs now) {
        recorded_ = recorded;
        since_ = now;
    }
    bool stands() const { return stands_; }
    bool isDue(RTT::nsecs recorded, RTT::nsecs now) const { return !stands_ && (speed_ == 0 || recorded <= at(now)); }
    /** Seconds until that time comes. */
    double wait(RTT::nsecs recorded, RTT::nsecs now) const {
        return speed_ > 0 ? static_cast<double>(recorded - at(now)) / 1e9 / speed_ : 0;
    }

private:
    RTT::nsecs at(RTT::nsecs now) const {
        constexpr auto kLatest = std::numeric_limits<RTT::nsecs>::max();
        const double passed = static_cast<double>(now - since_) * speed_;
        if (passed >= static_cast<double>(kLatest - recorded_)) return kLatest;
        return recorded_ + static_cast<RTT::nsecs>(passed);
    }

    RTT::nsecs recorded_ = 0, since_ = 0;
    double speed_ = 1;
    bool stands_ = false;
};

}  // namespace OCL::replay

#endif
