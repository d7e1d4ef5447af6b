// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Categories, and appenders that the test steps itself.
#ifndef OROFORGE_TESTS_LOGGING_FIXTURE_HPP
#define OROFORGE_TESTS_LOGGING_FIXTURE_HPP

#include <ocl/Appender.hpp>
#include <ocl/Category.hpp>
#include <ocl/FileAppender.hpp>
#include <ocl/LoggingService.hpp>
#include <rtt/Logger.hpp>
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/startstop.h>
#include <rtt/os/tlsf/tlsf.h>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace logging_test {

using OCL::logging::Category;
using OCL::logging::LoggingEvent;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/** What the log says meanwhile. */
class LogText {
public:
    LogText() {
        RTT::Logger::Instance()->setLogLevel(RTT::Logger::Info);
        RTT::Logger::Instance()->setStdStream(text_);
    }
    ~LogText() {
        RTT::Logger::Instance()->setStdStream(std::cerr);
        RTT::Logger::Instance()->setLogLevel(RTT::Logger::Warning);
    }
    std::string operator()() const { return text_.str(); }

private:
    std::ostringstream text_;
};

inline Category& category(const std::string& name) {
    return dynamic_cast<Category&>(log4cpp::Category::getInstance(name));
}

inline std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

template <class T>
T& property(RTT::TaskContext& component, const std::string& name) {
    auto* const found = dynamic_cast<RTT::Property<T>*>(component.getProperty(name));
    if (!found) throw std::runtime_error("no property " + name);
    return found->value();
}

template <class T>
void entry(RTT::TaskContext& service, const std::string& bag, const std::string& category, const T& value) {
    property<RTT::PropertyBag>(service, bag).ownProperty(new RTT::Property<T>(category, "", value));
}

/** Keeps what comes through its port. */
class Listener : public RTT::TaskContext {
public:
    explicit Listener(const std::string& name = "listener") : RTT::TaskContext(name) { addPort("LogPort", port); }
    std::vector<std::string> messages() {
        std::vector<std::string> all;
        for (LoggingEvent event; port.read(event, false) == RTT::NewData;) {
            all.push_back(std::string(event.message.data(), event.message.size()));
            last = event;
        }
        return all;
    }
    RTT::InputPort<LoggingEvent> port{"LogPort"};
    LoggingEvent last;
};

class Logging : public testing::Test {
protected:
    static void SetUpTestSuite() {
        __os_init(0, nullptr);
        ASSERT_TRUE(Category::installFactory());
    }
    void SetUp() override { service.reset(new OCL::logging::LoggingService("service")); }
    void TearDown() override {
        (void)service->cleanup();
        log4cpp::Category::getRoot().setPriority(log4cpp::Priority::INFO);
    }
    /** The category's events go to the component with that name. */
    void connect(const std::string& category, RTT::TaskContext& appender) {
        service->addPeer(&appender);
        entry<std::string>(*service, "Appenders", category, appender.getName());
    }

    std::unique_ptr<OCL::logging::LoggingService> service;
    oroforge::test::TempDir folder;
};

}  // namespace logging_test

#endif
