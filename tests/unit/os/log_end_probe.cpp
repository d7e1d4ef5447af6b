// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "real_time_thread.hpp"

#include <rtt/Logger.hpp>
#include <rtt/os/startstop.h>

#include <csignal>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

/** Program that log_real_time_test runs: a real-time thread logs, and ends the process before anybody else runs. */
int main(int argc, char** argv) {
    using namespace RTT;
    const std::string how = argc > 1 ? argv[1] : "";
    if (how == "stream_gone") {
        std::ostringstream stream;
        Logger::Instance()->setStdStream(stream);
        log(Error) << "into the stream" << endlog();
        return stream.str().empty();
    }
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<unsigned>(sched_getcpu()), &one);
    sched_setaffinity(0, sizeof one, &one);  // inherited by all threads: the real-time one keeps the others waiting
    if (how != "exit_without_init") __os_init(argc, argv);
    log(Info) << "main, not flushed" << nlog();
    std::thread([&] {
        if (!oroforge::test::becomeRealTime()) std::_Exit(77);
        Logger::In in("probe");
        for (int i = 0; i < 100; ++i) log(Error) << "line " << i << endlog();
        if (how == "abort") std::abort();
        if (how == "terminate") throw std::runtime_error("nobody catches it");
        if (how == "fault") *static_cast<volatile int*>(nullptr) = 1;
        if (how == "sent") raise(SIGSEGV);
        std::exit(0);
    }).join();
}
