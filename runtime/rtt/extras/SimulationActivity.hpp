// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_SIMULATION_ACTIVITY_HPP
#define ORO_EXTRAS_SIMULATION_ACTIVITY_HPP

#include <rtt/extras/PeriodicActivity.hpp>
#include <rtt/extras/SimulationThread.hpp>

namespace RTT {
namespace extras {

/**
 * A periodic activity in simulated time: it executes once per step of the SimulationThread, with the period of that
 * thread. execute(), which TaskContext::update() calls, executes it once more, in the calling thread and without moving
 * the time.
 */
class RTT_API SimulationActivity : public PeriodicActivity {
public:
    /** The first activity sets the period of the SimulationThread, in seconds; a different period later gives a
        warning. */
    explicit SimulationActivity(double period, base::RunnableInterface* runner = nullptr);
    SimulationActivity(secs s, nsecs ns, base::RunnableInterface* runner = nullptr);
    ~SimulationActivity() override;

    /** True from start() to stop(), even while the simulation makes no steps. */
    bool isRunning() const override;
    /** Executes step() and work(TimeOut) in the calling thread, never at the same time as a step of the simulation. */
    bool execute() override;
    /** While the simulation makes no steps, true in the main thread, in place of the one that will make them. */
    bool isSelf() const override;
};

}  // namespace extras
}  // namespace RTT
#endif
