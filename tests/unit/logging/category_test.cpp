// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Categories: who makes them, what reaches a port.
#include "logging_fixture.hpp"

#include <log4cpp/OstreamAppender.hh>
#include <log4cpp/SimpleLayout.hh>

#include <cstdlib>
#include <iomanip>
#include <limits>

namespace {

using namespace logging_test;
using log4cpp::Priority;

class Categories : public Logging {
protected:
    void listenTo(const std::string& name, Priority::Value level = Priority::DEBUG) {
        connect(name, listener);
        ASSERT_TRUE(service->configure());
        category(name).setPriority(level);
    }
    Listener listener;
};

TEST_F(Categories, AreMadeByLog4cppWithTheirParents) {
    log4cpp::Category& made = log4cpp::Category::getInstance("made.by.log4cpp");
    EXPECT_NE(nullptr, dynamic_cast<Category*>(&made));
    EXPECT_NE(nullptr, dynamic_cast<Category*>(&log4cpp::Category::getInstance("made.by")));
    EXPECT_EQ(&log4cpp::Category::getInstance("made.by"), made.getParent());
    EXPECT_NE(nullptr, dynamic_cast<Category*>(&log4cpp::Category::getRoot()));
    EXPECT_EQ(&made, &log4cpp::Category::getInstance("made.by.log4cpp"));
    EXPECT_EQ(&made, log4cpp::Category::exists("made.by.log4cpp"));
    EXPECT_EQ(Priority::NOTSET, made.getPriority());
    EXPECT_TRUE(Category::installFactory());  // again does no harm
    EXPECT_EQ(&made, &log4cpp::Category::getInstance("made.by.log4cpp"));
}

log4cpp::Category* countOne(const std::string& name, log4cpp::Category* parent, Priority::Value priority) {
    setenv("OROFORGE_CATEGORY", name.c_str(), 1);
    return Category::createOCLCategory(name, parent, priority);
}

TEST_F(Categories, AreMadeByAFunctionOfTheProgram) {
    ASSERT_TRUE(Category::installFactory(&countOne));
    (void)log4cpp::Category::getInstance("of.the.program");
    ASSERT_TRUE(Category::installFactory());
    (void)log4cpp::Category::getInstance("of.the.library");
    EXPECT_STREQ("of.the.program", std::getenv("OROFORGE_CATEGORY"));
}

TEST(CategoriesMadeBefore, StayAndTheServiceSaysWhatToDo) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");  // in a process of its own
    EXPECT_EXIT(
        {
            log4cpp::Category& root = log4cpp::Category::getRoot();
            log4cpp::Category& early = log4cpp::Category::getInstance("early");
            OCL::logging::LoggingService service("service");
            const bool kept = &root == &log4cpp::Category::getRoot() &&
                              &early == &log4cpp::Category::getInstance("early") && !dynamic_cast<Category*>(&early) &&
                              dynamic_cast<Category*>(&log4cpp::Category::getInstance("late.below"));
            Listener listener;
            service.addPeer(&listener);
            entry<std::string>(service, "Appenders", "early", "listener");
            std::exit(kept && !service.configure() ? 7 : 1);
        },
        testing::ExitedWithCode(7),
        "Category 'early' is not an OCL category: type is 'log4cpp::Category'.*installFactory");
}

TEST_F(Categories, SendWhatIsLoggedThroughEveryFunction) {
    listenTo("all");
    Category& all = category("all");
    all.log(Priority::INFO, RTT::rt_string("log"));
    all.log(Priority::INFO, "literal");
    all.debug("debug"), all.info("info"), all.notice("notice"), all.warn("warn"), all.error("error");
    all.crit("crit"), all.alert("alert"), all.emerg("emerg"), all.fatal("fatal");
    all.info(RTT::rt_string("a real-time string with some more characters"));
    EXPECT_THAT(listener.messages(),
                ElementsAre("log", "literal", "debug", "info", "notice", "warn", "error", "crit", "alert", "emerg",
                            "fatal", "a real-time string with some more characters"));
}

TEST_F(Categories, EventsTellWhereTheyComeFrom) {
    listenTo("origin.of.event");
    const log4cpp::TimeStamp before;
    category("origin.of.event").error("x");
    (void)listener.messages();
    const LoggingEvent& event = listener.last;
    EXPECT_EQ("origin.of.event", event.categoryName);
    EXPECT_EQ(Priority::ERROR, event.priority);
    EXPECT_EQ("", event.ndc);
    EXPECT_FALSE(event.threadName.empty());
    EXPECT_GE(event.timeStamp.getSeconds(), before.getSeconds());
    EXPECT_LE(event.timeStamp.getSeconds(), before.getSeconds() + 60);
    const log4cpp::LoggingEvent other = event.toLog4cpp();
    EXPECT_EQ("x", other.message);
    EXPECT_EQ(std::string(event.threadName.c_str()), other.threadName);
    EXPECT_EQ(event.timeStamp.getMicroSeconds(), other.timeStamp.getMicroSeconds());
}

TEST_F(Categories, LeaveOutWhatIsBelowTheirLevel) {
    listenTo("levels", Priority::NOTSET);
    log4cpp::Category::getRoot().setPriority(Priority::WARN);
    category("levels").info("hidden");
    category("levels").getRTStream(Priority::INFO) << "hidden";
    category("levels").warn("shown");
    category("levels").setPriority(Priority::INFO);
    category("levels").info("now shown");
    EXPECT_THAT(listener.messages(), ElementsAre("shown", "now shown"));
}

TEST_F(Categories, AdditivityDecidesWhetherParentsSendToo) {
    Listener parents("parents");
    connect("family", parents);
    listenTo("family.child");
    category("family").setPriority(Priority::DEBUG);
    category("family.child.grandchild").info("one");
    category("family.child").setAdditivity(false);
    category("family.child.grandchild").info("two");
    category("family.child").setAdditivity(true);
    EXPECT_THAT(parents.messages(), ElementsAre("one"));
    EXPECT_THAT(listener.messages(), ElementsAre("one", "two"));
}

TEST_F(Categories, FunctionsOfLog4cppReachAppendersOfBothKinds) {
    listenTo("mixed");
    std::ostringstream text;
    log4cpp::Category& mixed = category("mixed");
    auto* const appender = new log4cpp::OstreamAppender("text", &text);
    appender->setLayout(new log4cpp::SimpleLayout);
    mixed.addAppender(appender);
    mixed.setAdditivity(false);
    mixed.info(std::string("a string"));
    mixed.warn("%d percent", 50);
    mixed.warn("%s", std::string(2000, 'x').c_str());
    mixed.infoStream() << "a stream " << 3;
    category("mixed").info("of a real-time thread");
    mixed.debug("%d", 1);
    mixed.removeAllAppenders();
    EXPECT_THAT(listener.messages(), ElementsAre("a string", "50 percent", std::string(2000, 'x'), "a stream 3",
                                                 "of a real-time thread", "1"));
    EXPECT_THAT(text.str(), HasSubstr("INFO    : a string"));
    EXPECT_THAT(text.str(), HasSubstr("50 percent"));
    EXPECT_THAT(text.str(), HasSubstr("a stream 3"));
    EXPECT_THAT(text.str(), Not(HasSubstr("of a real-time thread")));
}

/** Sees all that comes through log(). */
class Watching : public Category {
public:
    Watching(const std::string& name, log4cpp::Category* parent) : Category(name, parent, Priority::DEBUG) {}
    void log(Priority::Value priority, const char* text, std::size_t size) noexcept override {
        seen.push_back(std::to_string(priority) + std::string(text, size));
    }
    using Category::log;
    std::vector<std::string> seen;
};
log4cpp::Category* makeWatching(const std::string& name, log4cpp::Category* parent, Priority::Value) {
    return new Watching(name, parent);
}

TEST_F(Categories, OneFunctionCanBeOverriddenForAllOthers) {
    ASSERT_TRUE(Category::installFactory(&makeWatching));
    auto& watching = dynamic_cast<Watching&>(log4cpp::Category::getInstance("watching"));
    ASSERT_TRUE(Category::installFactory());
    watching.debug("a");
    watching.info(RTT::rt_string("b"));
    watching.getRTStream(Priority::WARN) << "c";
    log4cpp::Category& plain = watching;
    plain.error(std::string("d"));
    EXPECT_THAT(watching.seen, ElementsAre("700a", "600b", "400c", "300d"));
}

TEST_F(Categories, StreamsComposeOneMessage) {
    listenTo("stream");
    Category& to = category("stream");
    const std::string text = "text";
    char array[] = "array";
    to.getRTStream(Priority::INFO) << text << ' ' << array << ' ' << RTT::rt_string("real-time") << ' ' << 42 << ' '
                                   << -7L << ' ' << 1.5 << ' ' << true << ' '
                                   << std::numeric_limits<unsigned long long>::max();
    EXPECT_THAT(listener.messages(), ElementsAre("text array real-time 42 -7 1.5 1 18446744073709551615"));
    std::ostringstream same;
    for (double value : {0.1, 1e300, 123456789.0, -0.0, 1.0 / 3}) {
        same.str("");
        same << value;
        to.getRTStream(Priority::INFO) << value;
        EXPECT_THAT(listener.messages(), ElementsAre(same.str()));
    }
    to.getRTStream(Priority::INFO) << "one" << OCL::logging::flush << "two" << OCL::logging::eol << "three"
                                   << std::endl;
    EXPECT_THAT(listener.messages(), ElementsAre("one", "two", "three"));
    to.getRTStream(Priority::INFO) << "one" << log4cpp::eol << "two";
    EXPECT_THAT(listener.messages(), ElementsAre("one", "two"));
    to.getRTStream(Priority::INFO) << std::hex << 255 << ' ' << std::setw(4) << 1 << ' ' << 1.5 << 'x' << text;
    EXPECT_THAT(listener.messages(), ElementsAre("ff    1 1.5xtext"));
    to.getRTStream(Priority::INFO);
    to.getRTStream(Priority::INFO) << static_cast<const char*>(nullptr);
    EXPECT_THAT(listener.messages(), ElementsAre());
    to.getRTStream(Priority::INFO) << std::string(500, 'a') << std::string(500, 'b') << 'c';
    EXPECT_THAT(listener.messages(), ElementsAre(std::string(500, 'a') + std::string(500, 'b') + 'c'));
}

TEST_F(Categories, LongMessagesArriveWhole) {
    property<int>(*service, "MessageSize") = 20;
    listenTo("long");
    for (const std::size_t size : {19u, 21u, 255u, 257u, 5000u, 100000u}) {
        const std::string text(size, 'x');
        category("long").info(text.c_str());
        EXPECT_THAT(listener.messages(), ElementsAre(text));
    }
    EXPECT_EQ(0u, LoggingEvent::cutTexts());
}

TEST_F(Categories, WithoutRealTimeMemoryMessagesAreCutAndCounted) {
    listenTo("memory");
    const std::string text(3000, 'x');
    std::vector<void*> taken;
    for (std::size_t size : {std::size_t(4096), std::size_t(256), std::size_t(16)})
        while (void* const block = oro_rt_malloc(size)) taken.push_back(block);
    category("memory").info(text.c_str());
    category("memory").getRTStream(Priority::INFO) << text;
    category("memory").info("short");
    for (void* const block : taken) oro_rt_free(block);
    const std::vector<std::string> messages = listener.messages();
    ASSERT_EQ(3u, messages.size());
    EXPECT_THAT(messages[0], HasSubstr("xxx... (3000 characters; real-time memory is used up)"));
    EXPECT_THAT(messages[1], HasSubstr("xxx"));
    EXPECT_THAT(messages[1], HasSubstr("real-time memory is used up)"));
    EXPECT_EQ("short", messages[2]);
    EXPECT_LT(0u, LoggingEvent::cutTexts());
    EXPECT_LT(0u, service->droppedEvents());
}

}  // namespace
