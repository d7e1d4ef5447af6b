// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_LOG_RECEIVERS_HPP
#define OROFORGE_TESTS_LOG_RECEIVERS_HPP

#include "log_probe_run.hpp"

#include <rtt/LogReceiver.hpp>
#include <rtt/Logger.hpp>
#include <support/temp_dir.hpp>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <gmock/gmock.h>
#include <iostream>
#include <mutex>
#include <sstream>
#include <string>
#include <vector>

namespace os_test {

using namespace RTT;

/** Keeps "[origin] text" of each line, then calls `then`. */
class Receiver : public LogReceiver {
public:
    explicit Receiver(std::function<void(const LogEntry&)> then = nullptr) : then_(std::move(then)) {}
    ~Receiver() override { alive_ = false; }
    void receive(const LogEntry& entry) override {
        if (!alive_) std::abort();
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            lines_.push_back("[" + std::string(entry.origin) + "] " + std::string(entry.text));
            last_ = entry;
        }
        if (then_) then_(entry);
    }
    std::vector<std::string> lines() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return lines_;
    }
    LogEntry last() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return last_;
    }

private:
    std::mutex mutex_;
    std::vector<std::string> lines_;
    LogEntry last_{};
    const std::function<void(const LogEntry&)> then_;
    std::atomic<bool> alive_{true};
};

class LogReceivers : public testing::Test {
protected:
    LogReceivers() {
        // The log begins anew, in a file of this test.
        logger.shutdown();
        setenv("ORO_LOGFILE", (directory.path() / "test.log").c_str(), 1);
        logger.startup();
        logger.setLogLevel(Logger::Warning);
        logger.setStdStream(console);
    }
    ~LogReceivers() override {
        logger.setReceiver(nullptr);
        logger.setStdStream(std::cerr);
        logger.shutdown();
        unsetenv("ORO_LOGFILE");
        logger.startup();
    }
    std::string file() {
        log(Error) << flushlog();
        return os_test::contentOf(directory.path() / "test.log");
    }
    oroforge::test::TempDir directory;
    std::ostringstream console;
    Logger& logger = *Logger::Instance();
};

}  // namespace os_test

#endif
