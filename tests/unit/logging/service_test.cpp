// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The logging service: its properties and operations.
#include "logging_fixture.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/OperationCaller.hpp>

#include <chrono>
#include <ctime>
#include <thread>

namespace {

using namespace logging_test;
using log4cpp::Priority;

class Service : public Logging {};

TEST_F(Service, SetsLevelsByNameInUpperOrLowerCase) {
    const std::pair<const char*, int> levels[] = {{"EMERG", 0},   {"fatal", 0},   {"Alert", 100},  {"CRIT", 200},
                                                  {"error", 300}, {"WARN", 400},  {"notice", 500}, {"INFO", 600},
                                                  {"debug", 700}, {"NotSet", 800}};
    for (const auto& level : levels)
        entry<std::string>(*service, "Levels", std::string("levels.") + level.first, level.first);
    entry<std::string>(*service, "Levels", "", "error");
    ASSERT_TRUE(service->configure());
    for (const auto& level : levels)
        EXPECT_EQ(level.second, log4cpp::Category::exists(std::string("levels.") + level.first)->getPriority());
    EXPECT_EQ(300, log4cpp::Category::getRoot().getPriority());
}

TEST_F(Service, RefusesOtherLevels) {
    const LogText log;
    entry<std::string>(*service, "Levels", "refused", "LOUD");
    entry<std::string>(*service, "Levels", "", "NOTSET");
    entry<int>(*service, "Levels", "number", 3);
    EXPECT_FALSE(service->configure());
    EXPECT_THAT(log(), HasSubstr("Bad level name: LOUD"));
    EXPECT_THAT(log(), HasSubstr("the root category does not take the level NOTSET"));
    EXPECT_THAT(log(), HasSubstr("Levels: the entry 'number' is a int, expected a string"));
}

TEST_F(Service, SetsAdditivity) {
    entry<bool>(*service, "Additivity", "alone", false);
    ASSERT_TRUE(service->configure());
    EXPECT_FALSE(category("alone").getAdditivity());
    property<RTT::PropertyBag>(*service, "Additivity").clear();
    entry<bool>(*service, "Additivity", "alone", true);
    ASSERT_TRUE(service->configure());
    EXPECT_TRUE(category("alone").getAdditivity());
}

TEST_F(Service, ConnectsCategoriesThatDoNotExistYet) {
    Listener one("one"), two("two");
    connect("not.there.yet", one);
    connect("not.there.yet", two);
    connect("", two);
    ASSERT_TRUE(service->configure());
    EXPECT_NE(nullptr, dynamic_cast<Category*>(log4cpp::Category::exists("not.there")));
    category("not.there.yet").error("both");
    category("some.other").error("root");
    EXPECT_THAT(one.messages(), ElementsAre("both"));
    // Once by the connection of the category, once by that of the root.
    EXPECT_THAT(two.messages(), testing::UnorderedElementsAre("both", "both", "root"));
}

TEST_F(Service, ReportsAppendersThatCannotBeConnected) {
    const LogText log;
    RTT::TaskContext silent("silent");
    connect("a", silent);
    entry<std::string>(*service, "Appenders", "a", "nobody");
    EXPECT_FALSE(service->configure());
    EXPECT_THAT(log(), HasSubstr("Failed to find log port in appender 'silent'"));
    EXPECT_THAT(log(), HasSubstr("Could not find appender 'nobody'; it must be a peer of 'service'"));
    silent.addPort("LogPort", *new RTT::InputPort<int>("LogPort"));
    EXPECT_FALSE(service->configure());
    EXPECT_THAT(log(), HasSubstr("Failed to connect port to appender 'silent'"));
    auto* const port = silent.getPort("LogPort");
    silent.ports()->removePort("LogPort");
    delete port;
}

TEST_F(Service, ReportsConnectionsForWhichThereIsNoRealTimeMemory) {
    const LogText log;
    Listener listener;
    property<int>(*service, "BufferSize") = 100000;
    connect("much", listener);
    EXPECT_FALSE(service->configure());
    EXPECT_THAT(log(),
                HasSubstr("no real-time memory for the events of category 'much': 100000 events of 200 characters"));
    EXPECT_THAT(log(), HasSubstr("--rtalloc-mem-size"));
    property<int>(*service, "BufferSize") = 0;
    EXPECT_FALSE(service->configure());
    EXPECT_THAT(log(), HasSubstr("BufferSize is 0"));
}

TEST_F(Service, ConfiguredAgainDisconnectsWhatItConnected) {
    const LogText log;
    Listener listener;
    connect("again", listener);
    ASSERT_TRUE(service->configure());
    ASSERT_TRUE(service->configure());
    EXPECT_THAT(log(), HasSubstr("'service' is configured again, and disconnects its 1 connections"));
    category("again").error("once");
    EXPECT_THAT(listener.messages(), ElementsAre("once"));
    ASSERT_TRUE(service->cleanup());
    category("again").error("gone");
    EXPECT_THAT(listener.messages(), ElementsAre());
}

TEST_F(Service, CategoriesStayConnectedWithoutTheService) {
    Listener listener;
    connect("stays", listener);
    ASSERT_TRUE(service->configure());
    service.reset(new OCL::logging::LoggingService("service"));
    category("stays").error("x");
    EXPECT_THAT(listener.messages(), ElementsAre("x"));
}

TEST_F(Service, TheLogOfTheRuntimeGoesToACategory) {
    const LogText log;
    Listener listener;
    connect("of.runtime", listener);
    entry<std::string>(*service, "Levels", "of.runtime", "WARN");
    property<std::string>(*service, "RuntimeCategory") = "of.runtime";
    ASSERT_TRUE(service->configure());
    const auto say = [](const char* text) {
        const RTT::Logger::In in("robot");
        RTT::log(RTT::Info) << "not for a category of this level" << RTT::endlog();
        RTT::log(RTT::Warning) << text << RTT::endlog();
    };
    say("the gripper is hot");
    ASSERT_TRUE(service->cleanup());  // waits for the line
    EXPECT_THAT(listener.messages(), ElementsAre());
    connect("of.runtime", listener);
    ASSERT_TRUE(service->configure());
    say("the gripper is hot");
    std::vector<std::string> messages;
    for (int i = 0; messages.empty() && i < 500; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        messages = listener.messages();
    }
    EXPECT_THAT(messages, ElementsAre("the gripper is hot"));
    EXPECT_EQ("robot", listener.last.ndc);
    EXPECT_EQ(log4cpp::Priority::WARN, listener.last.priority);
    EXPECT_NEAR(static_cast<double>(std::time(nullptr)), listener.last.timeStamp.getSeconds(), 60);
    say("the second line");
    service.reset(new OCL::logging::LoggingService("service"));
    say("after the end of the service");
    EXPECT_THAT(listener.messages(), ElementsAre("the second line"));
}

TEST_F(Service, OperationsShowAndChangePriorities) {
    const LogText log;
    Listener listener;
    connect("shown", listener);
    ASSERT_TRUE(service->configure());
    RTT::OperationCaller<bool(const std::string&, int)> set = service->getOperation("setCategoryPriority");
    RTT::OperationCaller<std::string(const std::string&)> get = service->getOperation("getCategoryPriorityName");
    RTT::OperationCaller<void()> show = service->getOperation("logCategories");
    EXPECT_TRUE(set("shown", 700));
    EXPECT_EQ("DEBUG", get("shown"));
    EXPECT_FALSE(set("shown", 701));
    EXPECT_FALSE(set("unknown.category", 700));
    EXPECT_FALSE(set("", 800));
    EXPECT_EQ("UNKNOWN CATEGORY", get("unknown.category"));
    category("shown").setPriority(650);
    EXPECT_EQ("UNKNOWN PRIORITY", get("shown"));
    EXPECT_TRUE(set("shown", 400));
    show();
    EXPECT_THAT(log(), HasSubstr("category 'shown': level WARN, in effect WARN, additivity on, appender 'listener'"));
    EXPECT_THAT(log(), HasSubstr("the root category: level INFO"));
}

TEST_F(Service, HasTheLevelsAsConstants) {
    const std::pair<const char*, int> levels[] = {{"EMERG", 0},   {"FATAL", 0},   {"ALERT", 100},  {"CRIT", 200},
                                                  {"ERROR", 300}, {"WARN", 400},  {"NOTICE", 500}, {"INFO", 600},
                                                  {"DEBUG", 700}, {"NOTSET", 800}};
    for (const auto& level : levels) {
        auto* const constant = service->attributes()->getAttribute(level.first);
        ASSERT_NE(nullptr, constant) << level.first;
        const RTT::Constant<int> value(constant);
        EXPECT_EQ(level.second, value.get());
    }
}

}  // namespace
