// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The services print and os.
#include "library_fixture.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/types/GlobalsRepository.hpp>

namespace {

using namespace components_test;

class Services : public WithLibrary {
protected:
    template <class S>
    RTT::OperationCaller<S> operation(const std::string& service, const std::string& name) {
        EXPECT_TRUE(component.loadService(service));
        RTT::OperationCaller<S> caller(component.provides(service)->getOperation(name));
        EXPECT_TRUE(caller.ready()) << service << "." << name;
        return caller;
    }
    RTT::TaskContext component{"component"};
};

TEST_F(Services, PrintWritesLines) {
    auto ln = operation<void(std::string)>("print", "ln");
    auto err = operation<void(std::string)>("print", "err");
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    ln("to out");
    err("to err");
    EXPECT_EQ("to out\n", testing::internal::GetCapturedStdout());
    EXPECT_EQ("to err\n", testing::internal::GetCapturedStderr());
}

TEST_F(Services, PrintLogsAtLevelsThatScriptsKnowByName) {
    ASSERT_TRUE(component.loadService("print"));
    RTT::TaskContext script("script");
    ASSERT_TRUE(script.loadService("print"));
    ASSERT_TRUE(script.loadService("scripting"));
    std::ostringstream log;
    RTT::Logger::Instance()->setStdStream(log);
    const bool good = RTT::OperationCaller<bool(std::string)>(script.provides("scripting")->getOperation("eval"))(
        "print.log(Error, \"it burns\")\nprint.log(Debug, \"a spark\")");
    RTT::Logger::Instance()->setStdStream(std::cerr);
    EXPECT_TRUE(good);
    EXPECT_THAT(log.str(), testing::HasSubstr("it burns\n"));
    EXPECT_THAT(log.str(), testing::HasSubstr("ERROR"));
    EXPECT_THAT(log.str(), testing::Not(testing::HasSubstr("a spark")));
    for (const char* level : {"Never", "Fatal", "Critical", "Error", "Warning", "Info", "Debug", "RealTime"}) {
        auto* const constant = RTT::types::GlobalsRepository::Instance()->getValue(level);
        ASSERT_NE(nullptr, constant) << level;
        EXPECT_EQ(level, constant->getDataSource()->toString());
    }
}

TEST_F(Services, RequireGivesThemToAllScripts) {
    ASSERT_TRUE(component.loadService("scripting"));
    testing::internal::CaptureStdout();
    const bool good = RTT::OperationCaller<bool(std::string)>(component.provides("scripting")->getOperation("eval"))(
        "require(\"print\")\nrequire(\"os\")\nprint.ln(\"arguments: \" + os.argc())");
    EXPECT_EQ("arguments: 2\n", testing::internal::GetCapturedStdout());
    EXPECT_TRUE(good);
    EXPECT_FALSE(component.provides()->hasService("print"));
}

TEST_F(Services, OsReadsAndSetsTheEnvironment) {
    auto get = operation<std::string(std::string)>("os", "getenv");
    auto is = operation<bool(std::string)>("os", "isenv");
    auto set = operation<bool(std::string, std::string)>("os", "setenv");
    EXPECT_FALSE(is("OROFORGE_TEST_VARIABLE"));
    EXPECT_EQ("", get("OROFORGE_TEST_VARIABLE"));
    EXPECT_TRUE(set("OROFORGE_TEST_VARIABLE", "value"));
    EXPECT_TRUE(is("OROFORGE_TEST_VARIABLE"));
    EXPECT_EQ("value", get("OROFORGE_TEST_VARIABLE"));
    EXPECT_FALSE(set("", "value"));
}

TEST_F(Services, OsGivesTheArgumentsOfTheProgram) {
    EXPECT_EQ(2, operation<int()>("os", "argc")());
    EXPECT_EQ((std::vector<std::string>{"component_library_test", "--option"}),
              operation<std::vector<std::string>()>("os", "argv")());
}

TEST_F(Services, OsPauses) {
    EXPECT_EQ(0, operation<int(unsigned)>("os", "sleep")(0));
    EXPECT_EQ(0, operation<int(unsigned)>("os", "millisleep")(1));
    EXPECT_EQ(0, operation<int(unsigned)>("os", "usleep")(1000));
    EXPECT_EQ(0, (operation<int(unsigned, unsigned)>("os", "nanosleep")(0, 1000)));
    EXPECT_EQ(-1, (operation<int(unsigned, unsigned)>("os", "nanosleep")(0, 1000000000)));
}

TEST_F(Services, OsExecutesCommands) {
    auto execute = operation<int(std::string)>("os", "execute");
    EXPECT_EQ(0, execute("true"));
    EXPECT_EQ(3, execute("exit 3"));
    EXPECT_EQ(-1, execute("kill -9 $$"));
}

}  // namespace
