// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Every code of the deployer and what it reads has an explanation, and what explanations show is true: the example gives
// the code, the advice gives none.
//
// Examples are deployments, scripts or property files. One that needs several files has a comment with the name of a file
// before each; the first one is run.
#include "deployer_program.hpp"

#include <ocl/DeploymentComponent.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/marsh/PropertyLoader.hpp>
#include <rtt/os/startstop.h>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/scripting/check.hpp>
#include <support/explained.hpp>
#include <support/golden.hpp>
#include <unit/flow/log_capture.hpp>

#include <gmock/gmock.h>

#include <filesystem>
#include <iostream>
#include <regex>
#include <sstream>
#include <utility>

namespace {

namespace fs = std::filesystem;
using namespace oroforge;
using namespace oroforge::test;
using testing::HasSubstr;
using testing::StartsWith;

const diag::Explanations& explanations() {
    static const diag::Explanations all = explanationsIn("deployer/explain");
    return all;
}

typedef std::vector<std::pair<std::string, std::string>> Files;

/** Files that have no name get one of the kind that the code is about. */
Files filesOf(const std::string& code, const std::string& example) {
    static const std::regex name("(?://|<!--) ([a-z]+\\.[a-z]+)(?: -->)?");
    const std::string kind = code.substr(0, 3) == "OPS" ? "ops" : code.substr(0, 3) == "CPF" ? "cpf" : "xml";
    // What becomes of a property file is seen in scripts, too.
    const bool isScript = kind == "cpf" && example[0] != '<';
    Files files;
    std::istringstream lines(example);
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (std::regex_match(line, found, name)) {
            files.emplace_back(found[1], "");
            continue;
        }
        if (files.empty()) files.emplace_back("example." + (isScript ? "ops" : kind), "");
        files.back().second += line + "\n";
    }
    return files;
}

/** What goes to the console, in the life time of this object. */
class ConsoleCapture {
public:
    ConsoleCapture() : old_(std::cerr.rdbuf(errors_.rdbuf())) {}
    ~ConsoleCapture() { std::cerr.rdbuf(old_); }
    std::ostream& stream() { return errors_; }
    std::string text() const { return errors_.str() + log_.text(); }

private:
    std::ostringstream errors_;
    std::streambuf* const old_;
    flow_test::LogCapture log_;
};

struct Ran {
    bool good;
    std::string said;
};

/** Examples of all codes that begin with the parameter. */
class Shown : public testing::TestWithParam<std::string> {
protected:
    static void SetUpTestSuite() {
        static char name[] = "deployer_explain_test";
        static char* words[] = {name, nullptr};
        __os_init(1, words);
        for (const char* plugin : {RTT_TYPEKIT_FILE, RTT_SCRIPTING_FILE, RTT_MARSHALLING_FILE})
            EXPECT_TRUE(RTT::plugin::PluginLoader::Instance()->loadLibrary(plugin));
        RTT::ComponentLoader::Instance()->setComponentPath(OCL_TEST_PATH);
    }
    static void TearDownTestSuite() { __os_exit(); }

    Shown() : before_(fs::current_path()) {}
    ~Shown() override { fs::current_path(before_); }

    Ran run(const std::string& code, const std::string& title) {
        const Files files = filesOf(code, block(*explanations().of(code), title));
        const TempDir directory;
        fs::current_path(directory.path());
        for (const auto& [name, text] : files) directory.write(name, text);
        ConsoleCapture console;
        bool good = false;
        {
            OCL::DeploymentComponent deployer("Deployer");
            good = take(files.front().first, deployer, console.stream());
        }
        fs::current_path(before_);
        return {good, console.text()};
    }

    std::vector<std::string> codesOfKind(const std::string& title) const {
        std::vector<std::string> codes = codesWith(title, explanations());
        codes.erase(std::remove_if(codes.begin(), codes.end(),
                                   [](const std::string& code) { return code.substr(0, 3) != GetParam(); }),
                    codes.end());
        return codes;
    }

private:
    static bool take(const std::string& file, OCL::DeploymentComponent& deployer, std::ostream& errors) {
        const std::string kind = fs::path(file).extension();
        if (kind == ".xml") return deployer.kickStart(file);
        if (kind == ".cpf") {
            RTT::TaskContext component("component");
            return RTT::marsh::PropertyLoader(&component).load(file);
        }
        (void)deployer.loadService(deployer.getName(), "scripting");  // as for --check
        const bool looksGood = RTT::scripting::checkScript(file, deployer, errors);
        return deployer.runScript(file) && looksGood;
    }

    const fs::path before_;
};

TEST(ExplanationsOfTheDeployer, AreThereForEveryCodeAndForNoOther) {
    expectExplained(explanations(), {"deployer", "runtime"}, "CPF|DEP|LIV|MCP|OPS|RPL|RTC|WEB|XML");
}

TEST(ExplanationsOfTheDeployer, HaveATitleAndAParagraph) {
    for (const diag::Explanation& explanation : explanations().all()) expectReadable(explanation);
}

TEST_P(Shown, ExamplesGiveTheirCodes) {
    ASSERT_FALSE(codesOfKind("Example:").empty());
    for (const std::string& code : codesOfKind("Example:"))
        EXPECT_THAT(run(code, "Example:").said, HasSubstr("[" + code + "]")) << code;
}

TEST_P(Shown, AdviceGivesNoCodeAtAll) {
    const std::regex anyCode("\\[[A-Z]{2,4}[0-9]{3}\\]");
    ASSERT_FALSE(codesOfKind("Instead:").empty());
    for (const std::string& code : codesOfKind("Instead:")) {
        const Ran ran = run(code, "Instead:");
        EXPECT_TRUE(ran.good) << code << "\n" << ran.said;
        EXPECT_FALSE(std::regex_search(ran.said, anyCode)) << code << "\n" << ran.said;
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Shown, testing::Values("CPF", "DEP", "OPS", "XML"), caseName);

class ExplainingDeployer : public deployer_test::DeployerInDirectory {};

TEST_F(ExplainingDeployer, PrintsTheTextsOfCodes) {
    const Outcome outcome = oroforge::test::run(command({"--explain", "dep031", "OPS123"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    const diag::Explanation &type = *explanations().of("DEP031"), &member = *explanations().of("OPS123");
    EXPECT_EQ("DEP031: " + type.title + "\n\n" + type.text + "\nOPS123: " + member.title + "\n\n" + member.text,
              outcome.out);
}

TEST_F(ExplainingDeployer, ListsAllCodes) {
    const Outcome outcome = oroforge::test::run(command({"--explain"}));
    EXPECT_EQ(0, outcome.status) << outcome.err;
    std::string list;
    for (const diag::Explanation& each : explanations().all()) list += each.code + "  " + each.title + "\n";
    EXPECT_EQ(list, outcome.out);
}

TEST_F(ExplainingDeployer, RefusesACodeThatDoesNotExist) {
    const Outcome outcome = oroforge::test::run(command({"--explain", "DEP999", "XML003"}));
    EXPECT_EQ(255, outcome.status);
    EXPECT_THAT(outcome.err, HasSubstr("error: no diagnostic has the code 'DEP999'; did you mean 'DEP009'?"));
    EXPECT_THAT(outcome.out, StartsWith("XML003: "));
    const Outcome other = oroforge::test::run(command({"--explain", "tk014"}));
    EXPECT_EQ(255, other.status);
    EXPECT_THAT(other.err, HasSubstr("typegen --explain tk014"));
    EXPECT_EQ("", other.out);
}

}  // namespace
