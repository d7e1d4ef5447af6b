// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/extras/SimulationActivity.hpp>

#include <rtt/os/MainThread.hpp>
#include <rtt/os/os_log.hpp>

namespace RTT::extras {

SimulationActivity::SimulationActivity(double period, base::RunnableInterface* r)
    : PeriodicActivity(SimulationThread::Instance(period), r) {
    if (period <= 0 || Seconds_to_nsecs(period) == Seconds_to_nsecs(PeriodicActivity::getPeriod())) return;
    os::detail::log(os::detail::LogWarning, "SimulationActivity",
                    "cannot have a period of " + std::to_string(period) + " s, all activities of the simulation have " +
                        std::to_string(PeriodicActivity::getPeriod()) + " s");
}

SimulationActivity::SimulationActivity(secs s, nsecs ns, base::RunnableInterface* r)
    : SimulationActivity(nsecs_to_Seconds(secs_to_nsecs(s) + ns), r) {}

SimulationActivity::~SimulationActivity() {
    closeGate();
    stop();
}

bool SimulationActivity::isRunning() const { return isActive(); }
bool SimulationActivity::isSelf() const {
    return PeriodicActivity::isSelf() ||
           (!isExecuted() && !timerThread().isActive() && os::MainThread::Instance()->isSelf());
}
bool SimulationActivity::execute() { return timerThread().executeNow(*this); }

}  // namespace RTT::extras
