// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/thread_settings.hpp>

#include <rtt/DataFlowInterface.hpp>
#include <rtt/Logger.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/threads.hpp>
#include <rtt/transports/corba/corba.h>
#include <rtt/types/GlobalsRepository.hpp>

#include <omniORB4/omniORB.h>

#include <omniORB4/omniInterceptors.h>

#include <cstring>
#include <mutex>
#include <optional>

#include <pthread.h>
#include <sched.h>

namespace RTT::corba::detail {

namespace {

std::optional<int> numberIn(const base::PropertyBase* property) {
    if (!property) return std::nullopt;
    if (const auto* const number = dynamic_cast<const Property<int>*>(property)) return number->get();
    if (const auto* const number = dynamic_cast<const Property<unsigned>*>(property))
        return static_cast<int>(number->get());
    log(Error) << "property '" << property->getName() << "' is a " << property->getType()
               << ", expected an int or uint: it is ignored" << endlog();
    return std::nullopt;
}

std::optional<int> numberOf(const std::string& name, TaskContext* component) {
    const auto own = component ? numberIn(component->provides()->properties()->getProperty(name)) : std::nullopt;
    return own ? own : numberIn(types::GlobalsRepository::Instance()->properties()->getProperty(name));
}

std::mutex orbMutex;
ThreadSettings orbThreads;  // guarded by it

/** To this thread. What the system refuses is left out, with a warning. */
void apply(const ThreadSettings& wanted) {
    const auto check = [](int error, const char* what) {
        if (error != 0)
            log(Warning) << "a thread of the ORB cannot have the " << what << ": " << std::strerror(error) << endlog();
    };
    if (wanted.scheduler != ORO_SCHED_OTHER) {
        sched_param parameters{};
        parameters.sched_priority = wanted.priority;
        check(pthread_setschedparam(pthread_self(), wanted.scheduler, &parameters), "scheduler of OrbRunnerScheduler");
    }
    if (wanted.cpuAffinity == 0) return;
    cpu_set_t cpus;
    CPU_ZERO(&cpus);
    for (unsigned cpu = 0; cpu != 32; ++cpu)
        if (wanted.cpuAffinity & (1U << cpu)) CPU_SET(cpu, &cpus);
    check(pthread_setaffinity_np(pthread_self(), sizeof cpus, &cpus), "processors of OrbRunnerCpuAffinity");
}

void beginOrbThread(_OMNI_NS(omniInterceptors)::createThread_T::info_T& thread) {
    ThreadSettings wanted;
    {
        const std::lock_guard<std::mutex> lock(orbMutex);
        wanted = orbThreads;
    }
    apply(wanted);
    thread.run();
}

}  // namespace

ThreadSettings threadSettings(const std::string& prefix, TaskContext* component, ThreadSettings otherwise) {
    ThreadSettings found = otherwise;
    if (const auto scheduler = numberOf(prefix + "Scheduler", component)) {
        found.scheduler = *scheduler;
        found.priority = *scheduler == ORO_SCHED_OTHER ? 0 : os::LowestPriority;
    }
    if (const auto priority = numberOf(prefix + "Priority", component)) found.priority = *priority;
    if (const auto affinity = numberOf(prefix + "CpuAffinity", component))
        found.cpuAffinity = static_cast<unsigned>(*affinity);
    return found;
}

ThreadSettings dispatcherSettings(const DataFlowInterface* interface) {
    return threadSettings("CorbaDispatcher", interface ? interface->getOwner() : nullptr);
}

void setUpOrbThreads() {
    ThreadSettings wanted = threadSettings("OrbRunner", nullptr);
    (void)os::CheckScheduler(wanted.scheduler);
    (void)os::CheckPriority(wanted.scheduler, wanted.priority);
    {
        const std::lock_guard<std::mutex> lock(orbMutex);
        orbThreads = wanted;
    }
    omniORB::getInterceptors()->createThread.remove(&beginOrbThread);  // of an earlier ORB
    omniORB::getInterceptors()->createThread.add(&beginOrbThread);
}

}  // namespace RTT::corba::detail
