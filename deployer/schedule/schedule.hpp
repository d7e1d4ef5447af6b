// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEDULE_SCHEDULE_HPP
#define OROFORGE_SCHEDULE_SCHEDULE_HPP

#include <replay/player.hpp>
#include <rtt/Time.hpp>

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace RTT {
class TaskContext;
}

namespace OCL::schedule {

class Agenda;

/**
 * Executes all components of the process in one thread and in simulated time, in an order that depends on nothing else.
 *
 * While it exists, time stands, and components that are made, or get an activity, are executed by it only. run() moves
 * the time to the next period or delivery. At each time it executes
 *  1. activities whose period ends: those of higher priority first, then in the order in which their components were
 *     made,
 *  2. what the source delivers,
 *  3. what was triggered, in the order in which that happened, until nothing is left.
 *
 * A component that waits for an operation of another one has the other one executed meanwhile.
 *
 * Make it and use it in one thread, the one that makes and deletes components. Only one at a time.
 */
class Schedule {
public:
    /** Time stands at `start`, in ns as os::TimeService counts. */
    explicit Schedule(RTT::nsecs start);
    /** Lets time pass again, if it did before. Components that still exist are not executed any more. */
    ~Schedule();
    Schedule(const Schedule&) = delete;
    Schedule& operator=(const Schedule&) = delete;

    struct Outcome {
        bool isComplete = false;  ///< the source has ended, and everything that was triggered is done
        RTT::nsecs simulated = 0;
        unsigned long executions = 0;
        std::string error;  ///< RPL002: it did not come to an end at one time
    };
    /** How fast time passes: 2 is twice as fast as real time; 0, the default, as fast as possible. */
    void setSpeed(double speed) { speed_ = speed; }
    /** Executes until the source has ended, or `interrupted`, which is asked at each time. */
    Outcome run(replay::TimedSource& source, const std::function<bool()>& interrupted);
    /** Executes what was triggered, without the source; false, with an error, if that does not end. */
    bool settle(std::string& error);

    /** The component is executed when nothing else is left at a time, so that it sees all of that at once. */
    void executeLast(RTT::TaskContext& component);
    /** The components that other threads have triggered during run(), and how often. */
    std::map<std::string, unsigned long> triggeredByOthers() const;
    /** The components that keep a thread of their own: the class of their activity is unknown to the runtime. */
    std::set<std::string> ownThreads() const;

    /** So many executions at one time are without end. */
    static constexpr unsigned long kMostAtOnce = 100000;

private:
    void moveTo(RTT::nsecs time, const std::function<bool()>& interrupted);
    std::string endless();

    const std::shared_ptr<Agenda> agenda_;
    const bool isFirst_;  // to stop the time
    double speed_ = 0;
    std::int64_t wallStart_ = 0;  // monotonic ns
    RTT::nsecs start_ = 0;
};

}  // namespace OCL::schedule

#endif
