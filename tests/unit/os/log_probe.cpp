// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/LogReceiver.hpp>
#include <rtt/Logger.hpp>
#include <rtt/os/startstop.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

using namespace RTT;

struct Blocking : LogReceiver {
    void receive(const LogEntry&) override { pause(); }
};

void restart(int argc, char** argv) {
    __os_init(argc, argv);
    log(Info) << "first session" << endlog();
    __os_exit();
    log(Fatal) << "between" << endlog();
    __os_init(argc, argv);
}

void logMuch() {
    for (int i = 0; i < 1000; ++i) log(Info) << "numbered " << i << " " << std::string(80, '.') << endlog();
}

/** The child goes on when its parent has ended. */
void forkAndEnd() {
    log(Info) << "before the fork" << endlog();
    if (fork() != 0) _exit(0);
    for (int i = 0; i < 100 && getppid() != 1; ++i) usleep(10000);
    logMuch();
    std::cout << "child done" << std::endl;
}

/** Until standard input ends. */
void stay() {
    log(Info) << "staying" << endlog();
    std::cout << "staying" << std::endl;
    while (std::cin.get() != EOF) {
    }
}

void throughAnotherBuffer() {
    std::ostringstream window;
    std::streambuf* const own = std::cerr.rdbuf(window.rdbuf());
    log(Error) << "in a window" << endlog();
    std::cerr.rdbuf(own);
    std::cout << window.str() << std::flush;
}

void receiveForEver() {
    static Blocking receiver;
    Logger::Instance()->setReceiver(&receiver, LogReceiverUse::InsteadOfFile);
    for (int i = 0; i < 50; ++i) log(Error) << "for the receiver " << i << endlog();
}

}  // namespace

/** In place of the C library's: LOG_PROBE_NO_LINKS makes a file system without hard links. */
extern "C" int link(const char* from, const char* to) noexcept {
    const char* const none = std::getenv("LOG_PROBE_NO_LINKS");
    if (!none || !*none) return linkat(AT_FDCWD, from, AT_FDCWD, to, 0);
    errno = EPERM;
    return -1;
}

/** LOG_PROBE_LATE_LOCK: the file that this process has just made is found, locked and written by another one. */
extern "C" int flock(int file, int operation) noexcept {
    static int calls = 0;
    if (std::getenv("LOG_PROBE_LATE_LOCK") && ++calls == 3) {
        unsetenv("LOG_PROBE_LATE_LOCK");
        if (std::system(program_invocation_name) != 0) std::abort();
    }
    return static_cast<int>(syscall(SYS_flock, file, operation));
}

/** Program that tests of the log run with several environments: one line of each level, in a plain main(). */
int main(int argc, char** argv) {
    const std::map<std::string, std::function<void()>> actions = {
        {"--realtime", [] { Logger::Instance()->setLogLevel(Logger::RealTime); }},
        {"--allow", [] { Logger::Instance()->allowRealTime(); }},
        {"--never", [] { Logger::Instance()->setLogLevel(Logger::Never); }},
        {"--restart", [=] { restart(argc, argv); }},
        {"--wall", [] { Logger::setLogTime(LogTime::Wall); }},
        {"--much", &logMuch},
        {"--fork", &forkAndEnd},
        {"--stay", &stay},
        {"--buffer", &throughAnotherBuffer},
        {"--receiver", &receiveForEver},
        {"--abort", &std::abort},
    };
    for (int i = 1; i < argc; ++i) actions.at(argv[i])();
    Logger::In in("probe");
    for (int level = Fatal; level <= RealTime; ++level)
        log(static_cast<LoggerLevel>(level)) << "message " << level << nlog();
    // No flush, no __os_exit(): the file must be complete anyway.
}
