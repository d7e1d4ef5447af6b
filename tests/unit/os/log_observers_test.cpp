// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Any number of observers of the log, beside its receiver.
#include "log_receivers.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <thread>

namespace {

using namespace RTT;
using os_test::LogReceivers;
using os_test::Receiver;
using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(LogReceivers, ObserversAreAnyNumberBesideTheReceiver) {
    Receiver receiver, one, other([](const LogEntry&) { throw std::runtime_error("full"); });
    auto third = std::make_unique<Receiver>();
    logger.setReceiver(&receiver);
    addLogObserver(other);
    addLogObserver(one);
    addLogObserver(one);
    addLogObserver(*third);
    Logger::In in("part");
    log(Error) << "first" << endlog();
    removeLogObserver(*third);
    EXPECT_THAT(third->lines(), testing::Contains("[part] first"));
    third.reset();
    log(Error) << "second" << endlog();
    removeLogObserver(other);
    removeLogObserver(other);
    log(Error) << "third" << endlog();
    removeLogObserver(one);
    log(Error) << "fourth" << endlog();
    logger.setReceiver(nullptr);
    const auto mine = [](std::vector<std::string> lines) {
        const auto isOther = [](const std::string& line) { return line.find("[part]") != 0; };
        lines.erase(std::remove_if(lines.begin(), lines.end(), isOther), lines.end());
        return lines;
    };
    EXPECT_THAT(mine(one.lines()), ElementsAre("[part] first", "[part] second", "[part] third"));
    EXPECT_THAT(mine(other.lines()), ElementsAre("[part] first", "[part] second"));
    EXPECT_THAT(mine(receiver.lines()), ElementsAre("[part] first", "[part] second", "[part] third", "[part] fourth"));
    EXPECT_THAT(file(), HasSubstr("the receiver of the log threw: full"));
}

TEST_F(LogReceivers, ObserversComeAndGoWhileThreadsLog) {
    std::atomic<bool> done{false};
    std::thread logging([&] {
        while (!done) {
            log(Error) << "a line" << endlog();
            std::this_thread::yield();
        }
    });
    const auto comeAndGo = [] {
        for (int i = 0; i != 30; ++i) {
            const auto observer = std::make_unique<Receiver>();
            addLogObserver(*observer);
            removeLogObserver(*observer);
        }
    };
    std::thread other(comeAndGo);
    comeAndGo();
    other.join();
    done = true;
    logging.join();
}

}  // namespace
