// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What the manual shows of files, scripts and lines typed at the prompt, in programs as a user starts them.
#ifndef OROFORGE_TESTS_MANUAL_SNIPPETS_HPP
#define OROFORGE_TESTS_MANUAL_SNIPPETS_HPP

#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

namespace manual_test {

/// A line typed at the prompt, and what is shown after it.
struct Typed {
    std::string line;
    testing::Matcher<std::string> answer;
};

/// Waits for a condition. A loop that yields would be given up after a while, where a machine is slow.
inline Typed until(const std::string& condition) {
    return {"require(\"os\"); while !(" + condition + ") { os.millisleep(1) }", testing::_};
}

const std::string kTrue = " = true\n", kFalse = " = false\n", kVoid = " = (void)\n", kNothing;

class Snippets : public testing::Test {
protected:
    oroforge::test::Command command(const std::string& program, const std::vector<std::string>& arguments) const {
        oroforge::test::Command result;
        result.program = program;
        result.arguments = arguments;
        result.directory = directory_.path();
        result.environment = environment_;
        result.timeout = std::chrono::seconds(30);
        return result;
    }
    oroforge::test::Outcome rttscript(const std::vector<std::string>& arguments) const {
        return oroforge::test::run(command(RTTSCRIPT_PROGRAM, arguments));
    }

    /// Types the lines into a deployer without a terminal and expects the answers. Between them it types texts that come
    /// back as they are, so that each answer is known to be that of its line.
    oroforge::test::Outcome atPrompt(const std::vector<std::string>& arguments,
                                     const std::vector<Typed>& session) const {
        oroforge::test::Command deployer = command(DEPLOYER_PROGRAM, arguments);
        for (std::size_t i = 0; i < session.size(); ++i) deployer.input += session[i].line + "\n" + mark(i) + "\n";
        const oroforge::test::Outcome outcome = oroforge::test::run(deployer);
        std::size_t at = 0;
        for (std::size_t i = 0; i < session.size(); ++i) {
            const std::string end = " = " + mark(i) + "\n";
            const std::size_t next = outcome.out.find(end, at);
            EXPECT_NE(std::string::npos, next) << "no answer to: " << session[i].line << "\n" << outcome.err;
            if (next == std::string::npos) break;
            EXPECT_THAT(outcome.out.substr(at, next - at), session[i].answer) << "after: " << session[i].line << "\n"
                                                                              << outcome.err;
            at = next + end.size();
        }
        return outcome;
    }

    /// As atPrompt(), where nothing is to go wrong.
    void expectAtPrompt(const std::vector<std::string>& arguments, const std::vector<Typed>& session) const {
        const oroforge::test::Outcome outcome = atPrompt(arguments, session);
        EXPECT_EQ(0, outcome.status);
        EXPECT_EQ("", outcome.err);
    }

    /// A deployment or property file.
    void writeXml(const std::string& file, const std::string& content) const {
        directory_.write(
            file,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE properties SYSTEM \"cpf.dtd\">\n<properties>\n" +
                content + "</properties>\n");
    }
    static std::string simple(const std::string& name, const std::string& type, const std::string& value) {
        return "<simple name=\"" + name + "\" type=\"" + type + "\"><value>" + value + "</value></simple>\n";
    }
    static std::string bag(const std::string& name, const std::string& type, const std::string& content) {
        return "<struct name=\"" + name + "\" type=\"" + type + "\">\n" + content + "</struct>\n";
    }
    static std::string import(const std::string& package) { return simple("Import", "string", package); }
    static std::string peer(const std::string& name) {
        return "<struct name=\"Peers\" type=\"PropertyBag\"><simple type=\"string\"><value>" + name +
               "</value></simple></struct>\n";
    }
    static std::string speed(const std::string& value) { return simple("speed", "double", value); }
    static std::string label(const std::string& value) { return simple("label", "string", value); }

    oroforge::test::TempDir directory_;
    std::map<std::string, std::string> environment_ = {{"RTT_COMPONENT_PATH", MANUAL_COMPONENTS ":" BUILT_COMPONENTS},
                                                       {"ORO_LOGFILE", "orocos.log"},
                                                       {"ORO_LOGLEVEL", "4"}};

private:
    static std::string mark(std::size_t i) { return "\"line " + std::to_string(i + 1) + " is done\""; }
};

}  // namespace manual_test

#endif
