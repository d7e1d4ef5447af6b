// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "program.hpp"

#include "command_line.hpp"
#include "completion.hpp"
#include "failure.hpp"
#include "other_program.hpp"

#include <csignal>
#include <exception>

#include <unistd.h>

namespace oroforge::live_client {
namespace {

int report(const std::string& text, Status status) {
    remark("error: " + printable(text));
    return static_cast<int>(status);
}

void completeWords(const std::vector<std::string>& words, Output& out) {
    std::string text;
    for (const Candidate& one : candidatesFor(words))
        text += one.word + (one.text.empty() ? "" : "\t" + one.text) + "\n";
    out.write(text);
}

void work(const std::vector<std::string>& words, Output& out) {
    if (!words.empty() && words.front() == "__complete") return completeWords({words.begin() + 1, words.end()}, out);
    if (const Command* const command = words.empty() ? nullptr : commandNamed(words.front()))
        if (command->program) runOther(command->program, {words.begin() + 1, words.end()});
    const CommandLine line = readCommandLine(words);
    if (!line.help.empty()) return out.write(line.help);
    Session session(line.given, out);
    line.given.command->run(session);
}

}  // namespace

int runProgram(const std::vector<std::string>& words) {
    // A reader of the output that has gone is found when it is written.
    std::signal(SIGPIPE, SIG_IGN);
    Output out(STDOUT_FILENO);
    try {
        work(words, out);
    } catch (const Failure& failure) {
        return report(failure.what(), failure.status());
    } catch (const Silent& silent) {
        return static_cast<int>(silent.status);
    } catch (const NobodyReads&) {
        return 0;
    } catch (const std::exception& failure) {
        return report(std::string("stopped by a failure that was not expected: ") + failure.what(), Status::Refused);
    }
    return 0;
}

}  // namespace oroforge::live_client
