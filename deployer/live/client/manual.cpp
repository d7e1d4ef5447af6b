// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro man: manual pages, made of the table of commands
#include "session.hpp"

#include "failure.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace oroforge::live_client {
namespace {

/** Text in roff. */
std::string roff(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if (c == '\'')
            result += "\\(aq";
        else if (c == '"')
            result += "\\(dq";
        else
            result += c;
    }
    // A point at the beginning of a line would be a command.
    return !result.empty() && result[0] == '.' ? "\\&" + result : result;
}

std::string title(const std::string& name) {
    std::string upper;
    for (const char c : name) upper += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return ".TH \"" + roff(upper) + "\" \"1\" \"\" \"Oroforge " OROFORGE_VERSION "\" \"Oroforge\"\n";
}

std::string section(const char* name) { return std::string(".SH ") + name + "\n"; }

std::string optionText(const Option& option) {
    std::string names;
    const std::string all = option.names;
    for (std::size_t at = 0; at < all.size();) {
        const std::size_t end = std::min(all.find(',', at), all.size());
        names += (names.empty() ? "" : ", ") + ("\\fB" + roff(all.substr(at, end - at)) + "\\fR");
        at = end + 1;
    }
    return ".TP\n" + names + (option.value ? " \\fI" + roff(option.value) + "\\fR" : "") + "\n" + roff(option.text) +
           "\n";
}

std::string optionsText(const std::vector<Option>& options) {
    std::string text;
    for (const Option& option : options) text += optionText(option);
    return text;
}

std::string statusText() {
    return section("EXIT STATUS") +
           ".TP\n0\nIt is done; also if Ctrl\\-C ended a command that shows something.\n"
           ".TP\n1\nThe deployment refused it, ended meanwhile, or did not answer in time.\n"
           ".TP\n2\nThe command line is wrong.\n"
           ".TP\n3\nThere is no deployment, or more than one to choose from.\n";
}

std::string environmentText() {
    return section("ENVIRONMENT") +
           ".TP\nORO_DEPLOYMENT\nThe deployment, if there is no \\fB\\-\\-deployment\\fR.\n"
           ".TP\nORO_TOKEN\nThe token for \\fB\\-\\-url\\fR.\n"
           ".TP\nORO_HISTFILE\nWhere \\fBoro console\\fR keeps what was typed; ~/.oro_history if it is not set.\n"
           ".TP\nNO_COLOR\nNo colours, even on a terminal.\n"
           ".TP\nXDG_RUNTIME_DIR\nIts folder oroforge has the sockets of the deployments; without it "
           "/tmp/oroforge\\-UID.\n";
}

std::string pageOf(const Command& command) {
    const std::string name = command.name;
    std::string text =
        title("oro-" + name) + section("NAME") + roff("oro-" + name + " - ") + roff(command.summary) + "\n";
    text += section("SYNOPSIS") + ".B oro " + name + "\n.RI [ options ]\n.I " + roff(usageOf(command)) + "\n";
    text += section("DESCRIPTION") + roff(command.text) + "\n";
    for (const Argument& argument : command.arguments)
        text += ".TP\n\\fI" + roff(argument.name) + "\\fR\n" + roff(argument.text) + "\n";
    if (!command.program) text += section("OPTIONS") + optionsText(command.options) + optionsText(commonOptions());
    text += section("EXAMPLES");
    for (const Example& example : command.examples)
        text += ".TP\n\\fB" + roff(example.line) + "\\fR\n" + roff(example.text) + "\n";
    return text + (command.program ? "" : statusText()) + section("SEE ALSO") + ".BR oro (1)\n";
}

std::string mainPage() {
    std::string text = title("oro") + section("NAME") + "oro \\- looks at and commands running deployments\n";
    text += section("SYNOPSIS") + ".B oro\n.RI [ options ]\n.I COMMAND\n.RI [ arguments ]\n";
    text += section("DESCRIPTION") +
            "A deployment that \\fBdeployer\\fR runs can be looked at and commanded from another terminal. The "
            "deployer needs no "
            "option for that, and it costs it nothing while nobody looks.\n";
    text += section("COMMANDS");
    for (const Command& command : commands())
        text += ".TP\n.BR oro\\-" + std::string(command.name) + " (1)\n" + roff(command.summary) + "\n";
    return text + section("OPTIONS") + optionsText(commonOptions()) + statusText() + environmentText();
}

void writeFile(const std::string& path, const std::string& text) {
    std::ofstream out(path, std::ios::trunc);
    out << text;
    out.close();
    if (!out) throw Failure(Status::Refused, "cannot write '" + path + "': " + std::strerror(errno));
}

}  // namespace

void writeManual(Session& session) {
    const std::string folder = session.given().text("directory"), name = session.word(0);
    if (folder.empty() && name.empty()) return session.out().write(mainPage());
    if (!folder.empty()) {
        if (!name.empty()) throw Failure(Status::Usage, "--directory writes all pages, so it takes no command");
        writeFile(folder + "/oro.1", mainPage());
        for (const Command& command : commands()) writeFile(folder + "/oro-" + command.name + ".1", pageOf(command));
        return;
    }
    const Command* const command = commandNamed(name);
    if (!command) throw Failure(Status::Usage, "there is no command '" + name + "'; 'oro --help' lists the commands");
    session.out().write(pageOf(*command));
}

}  // namespace oroforge::live_client
