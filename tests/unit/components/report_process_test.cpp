// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// FileReporting in the deployer: from files, under load, and killed.
#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

namespace {

using namespace oroforge::test;
using std::chrono::seconds;
using testing::HasSubstr;
using testing::Not;

struct Application {
    int ports = 1;
    int cycles = 100;
    double reporterPeriod = 0.001;
    std::string reporterOptions;
};

std::string simple(const std::string& name, const std::string& type, const std::string& value) {
    return "<simple name='" + name + "' type='" + type + "'><value>" + value + "</value></simple>";
}

std::string activity(double period) {
    return "<struct name='Activity' type='Activity'>" + simple("Period", "double", std::to_string(period)) +
           simple("Priority", "short", "0") + simple("Scheduler", "string", "ORO_SCHED_OTHER") + "</struct>";
}

std::string xmlOf(const Application& application) {
    return "<properties>" + simple("Import", "string", "reporttest") +
           "<struct name='counter' type='reporttest::Counter'>" + activity(0.001) +
           "<struct name='Properties' type='PropertyBag'>" +
           simple("ports", "long", std::to_string(application.ports)) +
           simple("tell", "long", std::to_string(application.cycles)) + "</struct>" +
           simple("AutoConf", "boolean", "1") + simple("AutoStart", "boolean", "1") +
           "</struct><struct name='reporter' type='OCL::FileReporting'>" + activity(application.reporterPeriod) +
           simple("AutoConf", "boolean", "1") + simple("AutoStart", "boolean", "1") +
           simple("LoadProperties", "string", "report.cpf") + application.reporterOptions +
           "<struct name='Peers' type='PropertyBag'><simple type='string'><value>counter</value></simple></struct>"
           "</struct></properties>";
}

std::string cpfOf(const std::string& entries, const std::string& more = {}) {
    return "<properties>" + more + "<struct name='ReportData' type='PropertyBag'>" + entries + "</struct></properties>";
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<double> numbersIn(const std::string& line) {
    std::vector<double> numbers;
    std::istringstream in(line);
    for (double number; in >> number;) numbers.push_back(number);
    return numbers;
}

class FileReporter : public testing::Test {
protected:
    Command deployer() {
        Command command;
        command.program = DEPLOYER_PROGRAM;
        command.arguments = {"-s", "app.xml"};
        command.inputStaysOpen = true;  // at its end the console is left
        command.directory = directory_.path();
        command.environment = {{"RTT_COMPONENT_PATH", OCL_TEST_PATH}};
        command.timeout = seconds(40);
        return command;
    }
    Outcome runUntilTold(const Application& application, const std::string& cpf, int signal) {
        directory_.write("app.xml", xmlOf(application));
        directory_.write("report.cpf", cpf);
        return again(signal, application.cycles);
    }
    Outcome again(int signal, int cycles) {
        ChildProcess child(deployer());
        EXPECT_TRUE(child.waitForOutput(std::to_string(cycles) + " cycles", seconds(30)));
        child.send(signal);
        return child.finish();
    }
    std::string reports() const { return readFile(directory_ / "reports.dat"); }

    TempDir directory_;
};

TEST_F(FileReporter, WritesEverySampleOnceAndAllBeforeItStops) {
    Application application;
    application.cycles = 500;
    application.reporterPeriod = 0;
    const std::string policy = "<struct name='ReportPolicy' type='ConnPolicy'>" + simple("type", "short", "1") +
                               simple("size", "short", "10000") + "</struct>";
    const Outcome outcome = runUntilTold(application, cpfOf(simple("Port", "string", "counter.n0"), policy), SIGTERM);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.err, Not(HasSubstr("lost")));
    const std::string text = reports();
    ASSERT_EQ('\n', text.back());
    const std::vector<std::string> lines = linesOf(text);
    ASSERT_GT(lines.size(), 1u);
    EXPECT_EQ(" TimeStamp counter.n0", lines[0]);
    EXPECT_GE(numbersIn(lines.back()).at(1), 500);  // the counter has begun before the reporter
    const double first = numbersIn(lines[1]).at(1);
    for (std::size_t i = 1; i < lines.size(); ++i)
        ASSERT_EQ(first + static_cast<double>(i) - 1, numbersIn(lines[i]).at(1));
}

TEST_F(FileReporter, ReportsWhatTheDeploymentFileItselfNames) {
    Application application;
    application.ports = 3;
    application.reporterOptions =
        "<struct name='Properties' type='PropertyBag'>"
        "<struct name='ReportData' type='PropertyBag'>" +
        simple("Port", "string", "counter.n0") + simple("Port", "string", "counter.n2") + "</struct></struct>";
    const Outcome outcome = runUntilTold(application, "<properties/>", SIGTERM);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_EQ(" TimeStamp counter.n0 counter.n2", linesOf(reports()).at(0));
}

TEST_F(FileReporter, ReportsAThousandPortsAThousandTimesASecond) {
    Application application;
    application.ports = 1000;
    application.cycles = 1000;
    const Outcome outcome = runUntilTold(application, cpfOf(simple("Component", "string", "counter")), SIGTERM);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.err, Not(HasSubstr("lost")));
    const std::vector<std::string> lines = linesOf(reports());
    // How often the threads get the processor is not ours; a row for each cycle that they got is.
    ASSERT_GT(lines.size(), 100u);
    EXPECT_EQ(1002, std::count(lines[0].begin(), lines[0].end(), ' '));
    double before = -1;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        ASSERT_EQ(1003, std::count(lines[i].begin(), lines[i].end(), ' ')) << i;
        const double time = numbersIn(lines[i]).at(0);
        ASSERT_GE(time, before);
        before = time;
    }
}

TEST_F(FileReporter, KilledLeavesOnlyWholeLinesButTheLast) {
    Application application;
    application.ports = 200;
    application.cycles = 300;
    for (int round = 0; round < 3; ++round) {
        directory_.write("reports.dat", "");
        directory_.write("app.xml", xmlOf(application));
        directory_.write("report.cpf", cpfOf(simple("Component", "string", "counter")));
        ChildProcess child(deployer());
        EXPECT_TRUE(child.waitForOutput(std::to_string(application.cycles) + " cycles", seconds(30)));
        // How often the threads get the processor is not ours.
        for (int i = 0; i != 300 && linesOf(reports()).size() < 30; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        child.send(SIGKILL);
        const Outcome outcome = child.finish();
        EXPECT_EQ(128 + SIGKILL, outcome.status);
        std::vector<std::string> lines = linesOf(reports());
        ASSERT_GT(lines.size(), 20u);
        lines.pop_back();
        for (std::size_t i = 1; i < lines.size(); ++i) {
            // Blanks: one before each of 201 numbers and an empty text, one at the end.
            ASSERT_EQ(203, std::count(lines[i].begin(), lines[i].end(), ' ')) << "line " << i << " of " << lines.size();
            ASSERT_EQ(' ', lines[i].back());
            const std::size_t text = lines[i].find("\"\"");
            ASSERT_NE(std::string::npos, text);
            ASSERT_EQ(201u, numbersIn(lines[i].erase(text, 2)).size());
        }
    }
}

TEST_F(FileReporter, SavedPropertiesGiveTheSameReportAgain) {
    Application application;
    application.cycles = 50;
    application.reporterOptions = simple("AutoSave", "boolean", "1");
    const std::string entries = simple("Port", "string", "counter.n0") + simple("Data", "string", "counter.gain") +
                                simple("Port", "string", "counter.text");
    const Outcome first = runUntilTold(application, cpfOf(entries), SIGTERM);
    EXPECT_EQ(0, first.status) << first.err;
    EXPECT_EQ(" TimeStamp counter.n0 counter.gain counter.text", linesOf(reports()).at(0));
    const Outcome second = again(SIGTERM, 50);
    EXPECT_EQ(0, second.status) << second.err;
    EXPECT_THAT(second.err, Not(HasSubstr("already")));
    EXPECT_EQ(" TimeStamp counter.n0 counter.gain counter.text", linesOf(reports()).at(0));
}

TEST_F(FileReporter, WrongEntriesAndFilesFailWithAReason) {
    Application application;
    directory_.write("app.xml", xmlOf(application));
    directory_.write("report.cpf", cpfOf(simple("Port", "string", "counter.n7")));
    const Outcome port = run(deployer());
    EXPECT_EQ(255, port.status);
    EXPECT_THAT(port.err, HasSubstr("could not report port 'n7': no such port on component 'counter'"));

    directory_.write("report.cpf", cpfOf(simple("Port", "string", "counter.n0"),
                                         simple("ReportFile", "string", "no/such/folder/reports.dat")));
    const Outcome file = run(deployer());
    EXPECT_EQ(255, file.status);
    EXPECT_THAT(file.err, HasSubstr("could not open file 'no/such/folder/reports.dat' for reporting: No such file"));
}

TEST_F(FileReporter, FullDiskIsReportedOnceAndTheApplicationGoesOn) {
    Application application;
    application.cycles = 200;
    const Outcome outcome = runUntilTold(
        application, cpfOf(simple("Component", "string", "counter"), simple("ReportFile", "string", "/dev/full")),
        SIGTERM);
    EXPECT_EQ(0, outcome.status) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("could not write to file '/dev/full': No space left on device"));
    EXPECT_THAT(outcome.err, HasSubstr("rows of the report of 'reporter' are lost"));
}

TEST_F(FileReporter, FullDiskEndsTheReportAtAWholeRowAndTheComponentInAnErrorState) {
    constexpr std::size_t kRoom = 20000;
    for (const double period : {0.001, 0.0}) {
        Application application;
        application.ports = 3;
        application.reporterPeriod = period;
        directory_.write("app.xml", xmlOf(application));
        directory_.write("report.cpf", cpfOf(simple("Component", "string", "counter")));
        Command limited = deployer();
        limited.program = "prlimit";
        limited.arguments = {"--fsize=" + std::to_string(kRoom), DEPLOYER_PROGRAM, "-s", "app.xml"};
        limited.environment["ORO_LOGFILE"] = "/dev/null";
        limited.inputStaysOpen = false;
        limited.input = "while !reporter.inRunTimeError() { yield }\nreporter.inRunTimeError()\n";
        const Outcome outcome = run(limited);
        EXPECT_EQ(0, outcome.status) << outcome.err;
        EXPECT_THAT(outcome.out, HasSubstr(" = true")) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("could not write to file 'reports.dat': File too large"));
        const std::string text = reports();
        EXPECT_GT(text.size(), kRoom - 200);
        ASSERT_EQ('\n', text.back());
        const std::vector<std::string> lines = linesOf(text);
        EXPECT_EQ(numbersIn(lines.at(1)).size(), numbersIn(lines.back()).size());
    }
}

TEST_F(FileReporter, ReportFollowsNoLinkOfAnotherUser) {
    if (geteuid() != 0) GTEST_SKIP() << "only root can give links away";
    directory_.write("precious", "kept");
    ASSERT_EQ(0, symlink("precious", (directory_ / "reports.dat").c_str()));
    ASSERT_EQ(0, lchown((directory_ / "reports.dat").c_str(), 65534, 65534));
    directory_.write("app.xml", xmlOf({}));
    directory_.write("report.cpf", cpfOf(simple("Component", "string", "counter")));
    const Outcome refused = run(deployer());
    EXPECT_EQ(255, refused.status);
    EXPECT_THAT(refused.err, HasSubstr("could not open file 'reports.dat' for reporting: it is a symbolic link of "
                                       "another user"));
    EXPECT_EQ("kept", readFile(directory_ / "precious"));
    ASSERT_EQ(0, lchown((directory_ / "reports.dat").c_str(), 0, 0));
    EXPECT_EQ(0, again(SIGTERM, 100).status);
    EXPECT_NE("kept", readFile(directory_ / "precious"));
}

}  // namespace
