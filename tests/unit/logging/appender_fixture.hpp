// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Appenders whose cycles the test makes.
#ifndef OROFORGE_TESTS_APPENDER_FIXTURE_HPP
#define OROFORGE_TESTS_APPENDER_FIXTURE_HPP

#include "logging_fixture.hpp"

#include <string>

namespace logging_test {

using log4cpp::Priority;
using oroforge::test::readFile;

inline std::size_t timesIn(const std::string& text, const std::string& part) {
    std::size_t times = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++times;
    return times;
}

/** An appender whose cycles the test makes. */
template <class T>
class Stepped : public T {
public:
    explicit Stepped(const std::string& name = "out") : T(name) { this->setActivity(new RTT::extras::SlaveActivity()); }
    ~Stepped() override { this->stopForGood(); }
    void layout(const std::string& name, const std::string& pattern = "") {
        property<std::string>(*this, "LayoutName") = name;
        property<std::string>(*this, "LayoutPattern") = pattern;
    }
};

class Appenders : public Logging {
protected:
    template <class T>
    void begin(Stepped<T>& appender) {
        connect(name, appender);
        log4cpp::Category::getRoot().setPriority(Priority::DEBUG);
        ASSERT_TRUE(service->configure());
        ASSERT_TRUE(appender.configure());
        ASSERT_TRUE(appender.start());
    }
    std::string path(const std::string& file) { return (folder / file).string(); }
    std::string text(const std::string& file = "log") { return readFile(folder / file); }
    /** With its file. */
    template <class T>
    void prepare(Stepped<T>& appender, int events = 0) {
        property<std::string>(appender, "Filename") = path("log");
        property<int>(appender, "MaxEventsPerCycle") = events;
        appender.layout("pattern", "%p %c %m%n");
    }
    void log(const std::string& message) { category(name).info(RTT::rt_string(message.c_str())); }

    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
};

}  // namespace logging_test

#endif
