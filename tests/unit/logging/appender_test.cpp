// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Appenders: their properties and operations, layouts, and what they count.
#include "appender_fixture.hpp"

#include <ocl/OstreamAppender.hpp>
#include <ocl/RollingFileAppender.hpp>
#include <ocl/SyslogAppender.hpp>
#include <rtt/Activity.hpp>
#include <rtt/OperationCaller.hpp>

#include <cstdlib>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace {

using namespace logging_test;

TEST_F(Appenders, FileGetsALineForEachEventAndTheMostOfACycleAtTheEnd) {
    Stepped<OCL::logging::FileAppender> file;
    prepare(file);
    begin(file);
    log("one"), log("two");
    EXPECT_EQ("", text());
    ASSERT_TRUE(file.update());
    EXPECT_EQ("INFO " + name + " one\nINFO " + name + " two\n", text());
    log("three");
    file.stop();
    EXPECT_EQ("INFO " + name + " one\nINFO " + name + " two\nINFO " + name +
                  " three\nDEBUG OCL.logging.Appender # countMaxPopped=2\n",
              text());
    ASSERT_TRUE(file.start());  // goes on with the same file
    log("four");
    file.stop();
    EXPECT_THAT(text(), HasSubstr("INFO " + name + " four\n"));
}

TEST_F(Appenders, TheLastLineNamesItsThreadAsAllOthersDo) {
    Stepped<OCL::logging::FileAppender> file;
    prepare(file);
    file.layout("pattern", "%t %p%n");
    begin(file);
    log("one");
    file.stop();
    const std::vector<std::string> lines = linesOf(text());
    ASSERT_EQ(2u, lines.size());
    EXPECT_EQ(lines[0].substr(0, lines[0].find(' ')) + " DEBUG", lines[1]);
}

TEST_F(Appenders, MaxEventsPerCycleLimitsACycle) {
    Stepped<OCL::logging::FileAppender> file;
    prepare(file, 2);
    begin(file);
    for (int i = 0; i < 5; ++i) log(std::to_string(i));
    ASSERT_TRUE(file.update());
    EXPECT_EQ(2u, linesOf(text()).size());
    ASSERT_TRUE(file.update());
    EXPECT_EQ(4u, linesOf(text()).size());
}

TEST_F(Appenders, WokenByEventsWriteAllOfThemWhateverTheLimit) {
    Stepped<OCL::logging::FileAppender> file;
    file.setActivity(new RTT::Activity(0));
    prepare(file, 1);
    connect(name, file);
    ASSERT_TRUE(service->configure());
    ASSERT_TRUE(file.configure());
    log("before the start");
    ASSERT_TRUE(file.start());
    for (int i = 0; i < 50; ++i) log(std::to_string(i));
    for (int i = 0; i < 500 && linesOf(text()).size() < 51; ++i) usleep(10000);
    EXPECT_EQ(51u, linesOf(text()).size());
}

TEST_F(Appenders, RefuseWrongProperties) {
    const LogText said;
    Stepped<OCL::logging::FileAppender> file;
    EXPECT_FALSE(file.configure());
    EXPECT_THAT(said(), HasSubstr("appender 'out' needs a file; its property Filename is empty"));
    prepare(file, -1);
    EXPECT_FALSE(file.configure());
    EXPECT_THAT(said(), HasSubstr("Invalid maxEventsPerCycle value of -1. Value must be >= 0."));
    prepare(file);
    file.layout("fancy");
    EXPECT_FALSE(file.configure());
    EXPECT_THAT(said(), HasSubstr("Invalid layout 'fancy' in configuration for category: out"));
    file.layout("pattern", "%Q");
    EXPECT_FALSE(file.configure());
    EXPECT_THAT(said(), HasSubstr("the pattern '%Q' is not valid"));
    prepare(file);
    property<std::string>(file, "Filename") = path("no/such/folder/log");
    EXPECT_TRUE(file.configure());
    EXPECT_FALSE(file.start());
    EXPECT_THAT(said(),
                HasSubstr("could not open file '" + path("no/such/folder/log") + "': No such file or directory"));
    Stepped<OCL::logging::RollingFileAppender> rolling("rolling");
    prepare(rolling);
    property<int>(rolling, "MaxFileSize") = 0;
    EXPECT_FALSE(rolling.configure());
    EXPECT_THAT(said(), HasSubstr("appender 'rolling': MaxFileSize is 0"));
}

TEST_F(Appenders, HaveFourLayouts) {
    const std::pair<const char*, const char*> layouts[] = {{"", "[0-9]+ INFO .*: message\n"},
                                                           {"basic", "[0-9]+ INFO .*: message\n"},
                                                           {"simple", "INFO *: message\n"},
                                                           {"pattern", "message\n"},
                                                           {"json", "\\{.*\"message\":\"message\"\\}\n"}};
    for (const auto& layout : layouts) {
        (void)unlink(path("log").c_str());
        Stepped<OCL::logging::FileAppender> file;
        prepare(file);
        file.layout(layout.first);
        property<RTT::PropertyBag>(*service, "Appenders").clear();
        begin(file);
        log("message");
        ASSERT_TRUE(file.update());
        EXPECT_THAT(text(), testing::MatchesRegex(layout.second)) << layout.first;
        file.stop();
    }
}

TEST_F(Appenders, JsonLinesAreReadByAnotherProgram) {
    Stepped<OCL::logging::FileAppender> file;
    prepare(file);
    file.layout("json");
    begin(file);
    for (const char* message :
         {"plain", "quoted \"x\" and \\", "two\nlines\tand\x01", "gr\xc3\xbc\xc3\x9f", "cut \xc3", "\xff\xfe"})
        log(message);
    ASSERT_TRUE(file.update());
    const std::string script =
        "import json,sys\n"
        "rows=[json.loads(line) for line in open(sys.argv[1], encoding='utf-8')]\n"
        "assert [r['message'] for r in rows]==['plain','quoted \"x\" and "
        "\\\\','two\\nlines\\tand\\x01','gr\\xfc\\xdf','cut "
        "\\ufffd','\\ufffd\\ufffd'], rows\n"
        "assert all(r['priority']=='INFO' and r['category']=='" +
        name +
        "' and r['thread'] for r in rows)\n"
        "import datetime\n"
        "[datetime.datetime.strptime(r['time'], '%Y-%m-%dT%H:%M:%S.%fZ') for r in rows]\n";
    folder.write("check.py", script);
    EXPECT_EQ(0, std::system(("/usr/bin/python3 " + path("check.py") + " " + path("log")).c_str()));
}

TEST_F(Appenders, ATextCannotPassForAnotherRecord) {
    Stepped<OCL::logging::FileAppender> file;
    prepare(file);
    begin(file);
    log("first\nERROR robot false\x1b[2J");
    ASSERT_TRUE(file.update());
    EXPECT_EQ("INFO " + name + " first\n    ERROR robot false\\x1b[2J\n", text());
}

TEST_F(Appenders, CountAndReportWhatFindsNoRoomInTheBuffer) {
    const LogText said;
    Stepped<OCL::logging::FileAppender> file;
    prepare(file);
    property<int>(*service, "BufferSize") = 10;
    begin(file);
    for (int i = 0; i < 25; ++i) log(std::to_string(i));
    RTT::OperationCaller<unsigned int()> dropped = file.getOperation("droppedEvents");
    RTT::OperationCaller<unsigned int(const std::string&)> of = file.getOperation("droppedOf");
    EXPECT_EQ(15u, dropped());
    EXPECT_EQ(15u, of(name));
    EXPECT_EQ(0u, of("another"));
    EXPECT_EQ(15u + LoggingEvent::cutTexts(), service->droppedEvents());  // those of other tests
    ASSERT_TRUE(file.update());
    EXPECT_EQ(10u, linesOf(text()).size());
    EXPECT_THAT(said(), HasSubstr("appender 'out': 15 events of category '" + name +
                                  "' were dropped, because the buffer of 10 events was full"));
    for (int i = 0; i < 12; ++i) log(std::to_string(i));
    ASSERT_TRUE(file.update());
    EXPECT_THAT(said(), Not(HasSubstr("2 events of category")));  // at most once per second
    file.stop();
    EXPECT_THAT(said(), HasSubstr("2 events of category"));
    ASSERT_TRUE(service->cleanup());
    EXPECT_EQ(17u, dropped());  // also when the connection is gone
}

TEST_F(Appenders, OstreamWritesToStandardOutput) {
    const int before = dup(STDOUT_FILENO);
    std::cout.flush();
    const int file = open(path("out").c_str(), O_CREAT | O_WRONLY, 0600);
    ASSERT_GE(dup2(file, STDOUT_FILENO), 0);
    {
        Stepped<OCL::logging::OstreamAppender> out;
        out.layout("simple");
        property<int>(out, "MaxEventsPerCycle") = 2;
        begin(out);
        std::cout << "first ";
        log("one"), log("two"), log("three");
        EXPECT_TRUE(out.update());
    }
    dup2(before, STDOUT_FILENO);
    close(file), close(before);
    const std::vector<std::string> lines = linesOf(text("out"));
    ASSERT_EQ(4u, lines.size());  // all of them by the end, and the last line of the appender
    EXPECT_THAT(lines[0], testing::MatchesRegex("first INFO *: one"));
    EXPECT_THAT(lines[2], testing::MatchesRegex("INFO *: three"));
}

/** Where a daemon of the system's log would receive. */
class Daemon {
public:
    explicit Daemon(const std::string& path) : socket_(socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        path.copy(address.sun_path, sizeof address.sun_path - 1);
        unlink(path.c_str());
        EXPECT_EQ(0, bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address));
    }
    ~Daemon() { close(socket_); }
    std::string receive() const {
        char text[4096];
        const ssize_t size = recv(socket_, text, sizeof text, 0);
        return size < 0 ? std::string("nothing") : std::string(text, static_cast<std::size_t>(size));
    }

private:
    const int socket_;
};

TEST_F(Appenders, SyslogSendsWithIdentityAndFacility) {
    const LogText said;
    Stepped<OCL::logging::SyslogAppender> out;
    property<std::string>(out, "Facility") = "nowhere";
    EXPECT_FALSE(out.configure());
    EXPECT_THAT(said(), HasSubstr("'nowhere' is no facility of syslog(3)"));
    property<std::string>(out, "Facility") = "local3";
    property<std::string>(out, "Identity") = "robot";
    property<std::string>(out, "Socket") = path("daemon");
    {
        Daemon daemon(path("daemon"));
        begin(out);
        category(name).error("too hot");
        category(name).debug("fine");
        ASSERT_TRUE(out.update());
        const std::string expected = "[A-Z][a-z][a-z] [ 0-9][0-9] [0-9:]+ robot.[0-9]+.: " + name + ": ";
        EXPECT_THAT(daemon.receive(), testing::MatchesRegex("<155>" + expected + "too hot"));  // 19 * 8 + 3
        EXPECT_THAT(daemon.receive(), testing::MatchesRegex("<159>" + expected + "fine"));
    }
    log("lost");
    ASSERT_TRUE(out.update());
    EXPECT_THAT(said(), HasSubstr("appender 'out' cannot write to the system's log at '" + path("daemon") + "'"));
    EXPECT_EQ(1u, out.lostEvents());
    Daemon daemon(path("daemon"));  // it is begun anew
    log("again");
    ASSERT_TRUE(out.update());
    EXPECT_THAT(daemon.receive(), HasSubstr("again"));
}

}  // namespace
