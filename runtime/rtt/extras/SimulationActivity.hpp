// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_SIMULATION_ACTIVITY_HPP
#define ORO_EXTRAS_SIMULATION_ACTIVITY_HPP

#include <rtt/extras/PeriodicActivity.hpp>
#include <rtt/extras/SimulationThread.hpp>

namespace RTT {
namespace extras {

/**
 * A periodic activity on simulated time: it executes once per step of the SimulationThread, with the period of
 * that thread. execute(), that is TaskContext::update(), executes it once more, in the caller and without moving the time.
 */
class RTT_API SimulationActivity : public PeriodicActivity {
public:
    /** The period, in seconds, is that of the SimulationThread if there is none yet; another one gives a warning. */
    explicit SimulationActivity(double period, base::RunnableInterface* runner = nullptr);
    SimulationActivity(secs s, nsecs ns, base::RunnableInterface* runner = nullptr);
    ~SimulationActivity() override;

    /** From start() to stop(), whether the simulation makes steps or not. */
    bool isRunning() const override;
    /** step() and work(TimeOut) in the calling thread, never at the same time as a step of the simulation. */
    bool execute() override;
    /** While the simulation makes no steps: in the main thread, which stands for the one that will make them. */
    bool isSelf() const override;
};

}  // namespace extras
}  // namespace RTT
#endif
