// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/startstop.h>

#include <rtt/os/MainThread.hpp>
#include <rtt/os/StartStopManager.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/os/detail/pool_registry.hpp>

namespace {
int mainArgc = 0;
char** mainArgv = nullptr;
}  // namespace

int __os_init(int argc, char** argv) {
    mainArgc = argc;
    mainArgv = argv;
    RTT::os::MainThread::Instance();
    // Reserved now, so that no real-time thread has to.
    RTT::os::detail::PoolRegistry::instance().current();
    return RTT::os::StartStopManager::Instance()->start();
}

void __os_exit(void) {
    RTT::os::StartStopManager::Instance()->stop();
    RTT::os::TimeService::Release();
}

int __os_main_argc(void) { return mainArgc; }
char** __os_main_argv(void) { return mainArgv; }
