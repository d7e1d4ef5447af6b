// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Properties that say how threads of CORBA are scheduled.
#include <rtt/Port.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/transports/corba/detail/thread_settings.hpp>
#include <rtt/types/GlobalsRepository.hpp>

#include "peer_fixture.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <sched.h>

using namespace RTT;

namespace {

/** The CPUs of each thread of this process with that name must be the first one only. */
void expectOnFirstCpu(const std::string& name) {
    int found = 0;
    for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
        std::string own;
        std::getline(std::ifstream(thread.path() / "comm"), own);
        if (own != name) continue;
        ++found;
        cpu_set_t cpus;
        ASSERT_EQ(sched_getaffinity(std::stoi(thread.path().filename()), sizeof cpus, &cpus), 0);
        EXPECT_TRUE(CPU_ISSET(0, &cpus));
        EXPECT_EQ(CPU_COUNT(&cpus), 1);
    }
    EXPECT_EQ(found, 1) << name;
}

template <class T>
void setGlobal(const std::string& name, T value) {
    PropertyBag& globals = *types::GlobalsRepository::Instance()->properties();
    Property<T> known(globals.getProperty(name));
    if (known.ready())
        known.set(value);
    else
        globals.ownProperty(new Property<T>(name, "", value));
}

void removeGlobals() {
    PropertyBag& globals = *types::GlobalsRepository::Instance()->properties();
    for (const char* const prefix : {"CorbaDispatcher", "OrbRunner"})
        for (const char* const what : {"Scheduler", "Priority", "CpuAffinity"})
            if (base::PropertyBase* const one = globals.getProperty(std::string(prefix) + what))
                globals.removeProperty(one);
}

/** Threads that have the first CPU only. */
int countOnFirstCpu() {
    int found = 0;
    for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
        cpu_set_t cpus;
        if (sched_getaffinity(std::stoi(thread.path().filename()), sizeof cpus, &cpus) != 0) continue;
        found += CPU_ISSET(0, &cpus) && CPU_COUNT(&cpus) == 1;
    }
    return found;
}

class CorbaThreads : public corba_test::PeerFixture {
protected:
    void TearDown() override {
        removeGlobals();
        corba_test::PeerFixture::TearDown();
    }
};

}  // namespace

TEST_F(CorbaThreads, ThoseOfTheComponentCountForMoreThanThoseOfTheProcess) {
    TaskContext here("here");
    const auto settings = [&] { return corba::detail::dispatcherSettings(here.ports()); };
    EXPECT_EQ(settings().scheduler, ORO_SCHED_OTHER);
    EXPECT_EQ(settings().cpuAffinity, 0U);
    setGlobal("CorbaDispatcherScheduler", int(ORO_SCHED_RT));
    setGlobal("CorbaDispatcherCpuAffinity", 2U);
    EXPECT_EQ(settings().scheduler, ORO_SCHED_RT);
    EXPECT_EQ(settings().priority, os::LowestPriority);
    EXPECT_EQ(settings().cpuAffinity, 2U);
    int priority = 7;
    double affinity = 1;
    here.addProperty("CorbaDispatcherPriority", priority);
    here.addProperty("CorbaDispatcherCpuAffinity", affinity);
    EXPECT_EQ(settings().priority, 7);
    EXPECT_EQ(settings().cpuAffinity, 2U) << "a double is no mask";
    EXPECT_EQ(corba::detail::dispatcherSettings(nullptr).priority, os::LowestPriority);
}

TEST_F(CorbaThreads, AConnectionHasTheAffinityOfItsComponent) {
    TaskContext here("here");
    unsigned first = 1;
    here.addProperty("CorbaDispatcherCpuAffinity", first);
    OutputPort<double> out("out");
    here.addPort(out);
    ASSERT_TRUE(out.connectTo(peer->getPort("in"), ConnPolicy::data()));
    expectOnFirstCpu("hereCorba");
}

TEST_F(CorbaThreads, OrbRunnerHasThatOfTheProcess) {
    setGlobal("OrbRunnerScheduler", int(ORO_SCHED_OTHER));
    setGlobal("OrbRunnerPriority", 0);
    setGlobal("OrbRunnerCpuAffinity", 1U);
    corba::TaskContextServer::ThreadOrb(ORO_SCHED_RT, 5, 0);
    expectOnFirstCpu("OrbRunner");
}

TEST(CorbaOrbThreads, ServeWithTheAffinityOfTheProcess) {
    const int before = countOnFirstCpu();
    setGlobal("OrbRunnerCpuAffinity", 1U);
    int argc = 1;
    char name[] = "test";
    char* argv[] = {name, nullptr};
    ASSERT_TRUE(corba::TaskContextServer::InitOrb(argc, argv));
    EXPECT_TRUE(corba_test::soon([&] { return countOnFirstCpu() > before; }));
    corba::TaskContextServer::DestroyOrb();
    removeGlobals();
}
