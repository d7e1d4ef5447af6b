// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Logger.hpp>

#include <cstring>
#include <rtt/os/startstop.h>

/** Program that logger_test runs with several environments: one line of each level, in a plain main(). */
int main(int argc, char** argv) {
    using namespace RTT;
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--realtime")) Logger::Instance()->setLogLevel(Logger::RealTime);
        if (!std::strcmp(argv[i], "--allow")) Logger::Instance()->allowRealTime();
        if (!std::strcmp(argv[i], "--never")) Logger::Instance()->setLogLevel(Logger::Never);
        if (!std::strcmp(argv[i], "--restart")) {
            __os_init(argc, argv);
            log(Info) << "first session" << endlog();
            __os_exit();
            log(Fatal) << "between" << endlog();
            __os_init(argc, argv);
        }
    }
    Logger::In in("probe");
    for (int level = Fatal; level <= RealTime; ++level)
        log(static_cast<LoggerLevel>(level)) << "message " << level << nlog();
    // No flush, no __os_exit(): the file must be complete anyway.
}
