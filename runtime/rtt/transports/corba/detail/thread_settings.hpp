// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_THREAD_SETTINGS_HPP
#define ORO_CORBA_DETAIL_THREAD_SETTINGS_HPP

#include <rtt/os/fosi.h>

#include <string>

namespace RTT {
class DataFlowInterface;
class TaskContext;
namespace corba {
namespace detail {

struct ThreadSettings {
    int scheduler = ORO_SCHED_OTHER;
    int priority = 0;
    unsigned cpuAffinity = 0;  // a bit for each CPU; 0 is all
};

/**
 * What the properties PREFIXScheduler, PREFIXPriority and PREFIXCpuAffinity say, those of the component before those of
 * the process (types::GlobalsRepository); what none of them says is as given. A real-time scheduler without a priority
 * gets the lowest. A property that is no whole number is ignored, with an error logged. `component` may be null.
 */
ThreadSettings threadSettings(const std::string& prefix, TaskContext* component, ThreadSettings otherwise = {});
/** For the thread of a connection whose writer is a port there; null is a port of no component. */
ThreadSettings dispatcherSettings(const DataFlowInterface* interface);

/** Gives the threads that the ORB makes from now on what OrbRunner… of the process says. After the ORB was made. */
void setUpOrbThreads();

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
