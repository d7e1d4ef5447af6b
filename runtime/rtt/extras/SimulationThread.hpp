// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_SIMULATION_THREAD_HPP
#define ORO_EXTRAS_SIMULATION_THREAD_HPP

#include <rtt/extras/TimerThread.hpp>

#include <mutex>

namespace RTT {
namespace extras {

class SimulationThread;
typedef boost::shared_ptr<SimulationThread> SimulationThreadPtr;

/**
 * Executes all SimulationActivities, step by step, in simulated time: while it runs, only its steps move the clock of
 * os::TimeService, by one period each. Either run() makes the steps in the calling thread, as fast as possible, or,
 * after start(), this thread makes one per period of real time. Starting an activity does not start it.
 */
class RTT_API SimulationThread : public TimerThread {
public:
    /** The only one of this process. The first call sets the period, in seconds. */
    static SimulationThreadPtr Instance(double period = 0.001);
    /** Makes the next Instance() create a new one. The present one lives as long as it is referred to. */
    static bool Release();
    ~SimulationThread() override;

    /** Makes steps until stop(). False if it runs already. */
    bool start() override;
    /** The same, but at most this number of steps; false for 0. */
    bool start(unsigned maxSteps);
    /** Makes this number of steps in the calling thread, fewer if stop() is called. False if it runs already, or for
        0. */
    bool run(unsigned maxSteps);
    /** After run(): takes effect at the end of the present step, without waiting for it. */
    bool stop() override;
    /** True within run() as well. */
    bool isRunning() const override;
    bool isActive() const override;
    /** True, because activities wait for the thread that executes steps, whichever it is. */
    bool startForActivity() override { return true; }

protected:
    SimulationThread(int priority, const std::string& name, double period);
    bool initialize() override;
    void step() override;
    void finalize() override;

private:
    bool startLimited(unsigned maxSteps);

    std::mutex mode_;  // either run() or start()
    std::atomic<bool> inRun_{false};
    std::atomic<bool> leaveRun_{false};
    unsigned maxSteps_ = 0;  // 0: no limit
    unsigned steps_ = 0;
};

}  // namespace extras
}  // namespace RTT
#endif
