// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "console.hpp"

#include "commands.hpp"
#include "interface_text.hpp"
#include "table.hpp"
#include "value_lines.hpp"
#include "value_table.hpp"
#include "value_text.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/engine/interruption.hpp>

#include <algorithm>
#include <cctype>
#include <exception>
#include <ostream>
#include <utility>

namespace OCL::console {
namespace {

constexpr std::size_t kMostLines = 60;  // of a value

bool isPath(const std::string& text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
    }) && !std::isdigit(static_cast<unsigned char>(text[0]));
}

/** True for what users of other consoles type to leave. */
bool meansQuit(const std::string& text) {
    std::string word;
    for (const char c : text)
        if (!std::isspace(static_cast<unsigned char>(c)) && c != ';') word += c;
    for (const char* const each : {"exit", "exit()", "quit()", "bye", "logout", "q"})
        if (word == each) return true;
    return false;
}

}  // namespace

Console::Console(RTT::TaskContext& self, RTT::TaskContext& component, std::ostream& out, std::ostream& err,
                 std::string inputName)
    : state_{Screen{out, err, Theme()}, self, Place(component), std::move(inputName)} {}

/** Goes back to a component that still exists; false if there is none. */
bool Console::findContext() {
    if (state_.place.component()) return true;
    const std::string gone = state_.place.name();
    const bool back = state_.place.back();
    state_.goTo(false);
    state_.screen.failed = true;
    state_.screen.err << "component '" << gone << "' is gone" << (back ? "; back in '" + state_.place.name() + "'" : "")
                      << '\n';
    state_.quits = state_.quits || !back;
    return back;
}

void Console::execute(const std::string& line) {
    ++line_;
    if (!findContext()) return;
    if (begun_.empty())
        run(Input(state_.inputName, line_, line));
    else {
        begun_ += '\n' + line;
        if (!RTT::scripting::TypedInput::goesOn(begun_)) finish();
    }
    state_.screen.out.flush();
}

void Console::finish() {
    if (begun_.empty() || !findContext()) return;
    evaluate(std::exchange(begun_, ""), begun_line_);
    state_.screen.out.flush();
}

void Console::forget() { begun_.clear(); }

void Console::run(const Input& input) {
    if (input.words.empty()) return;
    Screen& screen = state_.screen;
    try {
        if (const Command* const command = commandIn(input)) return OCL::console::execute(*command, state_, input);
        const std::string& first = input.words[0].text;
        if (first[0] == '.' && first.size() > 1 && std::isalpha(static_cast<unsigned char>(first[1]))) {
            std::vector<std::string> known;
            for (const Command& command : dotCommands()) known.push_back(command.word);
            return complain(screen, input, input.words[0].begin,
                            "there is no command '" + first + "'" + oroforge::diag::didYouMean(first, known));
        }
    } catch (const std::exception& thrown) {
        return complain(screen, input, input.words[0].begin, std::string("the command failed: ") + thrown.what());
    }
    if (state_.macro.recording()) return state_.macro.add(input.text);
    if (input.words.size() == 1 && showNamed(withoutLastDot(input.words[0].text))) return;
    if (RTT::scripting::TypedInput::goesOn(input.text)) {
        begun_ = input.text;
        begun_line_ = input.line;
        return;
    }
    evaluate(input.text, input.line);
}

/** Shows the interface of a component, service, port or requester whose name was typed alone. */
bool Console::showNamed(const std::string& name) {
    if (!isPath(name)) return false;
    if (name == "GlobalsRepository") {
        describeGlobals(state_.screen);
        return true;
    }
    RTT::TaskContext& context = *state_.context();
    const ResolvedName lookup = RTT::internal::resolve(context, name);
    const auto [before, last] = RTT::internal::splitAtLastDot(name);
    const ResolvedName owner = RTT::internal::resolve(context, before);
    const bool peer = lookup.target.component != nullptr;
    if (!peer && owner.target.service &&
        describePort(state_.screen, *owner.target.service, last, name, state_.around()))
        return true;
    if (lookup.target.service)
        describeInterface(state_.screen, lookup.target, state_.around());
    else if (context.requires_()->requiresService(name))
        describeRequester(state_.screen, *context.requires_(name));
    else
        return false;
    return true;
}

void Console::evaluate(const std::string& text, unsigned line) {
    if (!state_.typed || !state_.typed->alive())
        state_.typed = std::make_unique<RTT::scripting::TypedInput>(*state_.context(), state_.inputName);
    RTT::scripting::TypedInput::Answer answer;
    try {
        if (!state_.typed->execute(text, line, state_.screen.err, answer)) {
            if (meansQuit(text)) state_.screen.err << "note: 'quit' leaves the console\n";
            const auto* const interruption = RTT::internal::Interruption::ofThisThread();
            state_.screen.failed = state_.screen.failed || !(interruption && interruption->asked());
            return;
        }
        const std::size_t end = text.find_last_not_of(" \t\n");
        if (end == std::string::npos || text[end] != ';') show(answer);
    } catch (const std::exception& thrown) {
        complain(state_.screen, Input(state_.inputName, line, text), 0, std::string("that failed: ") + thrown.what());
    }
}

void Console::show(const RTT::scripting::TypedInput::Answer& answer) {
    typedef RTT::scripting::TypedInput::Answer Answer;
    Screen& screen = state_.screen;
    if (answer.kind == Answer::None) return;
    if (answer.kind == Answer::Void) {
        screen.out << " = (void)\n";
        return;
    }
    const auto* const bag = RTT::internal::DataSource<RTT::PropertyBag>::narrow(answer.value.get());
    if (bag && !bag->rvalue().empty()) {
        screen.out << " =\n";
        return writeProperties(screen, bag->rvalue(), "    ");
    }
    const std::string text = valueText(answer.value, screen.hex);
    // What reads the answer from a pipe gets one line.
    const std::size_t width = screen.tableWidth(), indent = 4;
    if (width > indent && widthOf(" = " + text) > width) {
        const auto lines = valueLines(answer.value, screen.hex, width - indent, kMostLines);
        if (!lines.empty()) screen.out << " =\n";
        for (const std::string& line : lines)
            screen.out << std::string(indent, ' ') << screen.paint(Style::Value, line) << '\n';
        if (!lines.empty()) return;
    }
    screen.out << " = " << screen.paint(Style::Value, text) << '\n';
}

std::string Console::prompt() {
    if (!findContext() || !begun_.empty() || state_.macro.recording()) return "> ";
    RTT::TaskContext& component = *state_.place.component();
    state_.listing.update(state_.screen, component);
    state_.screen.out.flush();
    const char state = stateLetter(component);
    const Style style = state == 'R'                                   ? Style::Good
                        : state == 'F' || state == 'E' || state == 'X' ? Style::Bad
                                                                       : Style::Plain;
    const Screen& screen = state_.screen;
    return (state_.watch ? screen.paint(Style::Good, "Watching") + " " : "") +
           screen.paint(Style::Name, component.getName()) + " [" + screen.paint(style, std::string(1, state)) + "]> ";
}

Completion Console::complete(const std::string& line) const {
    // Within a piece of script, TAB indents.
    if (!begun_.empty() && line.find_first_not_of(' ') == std::string::npos) return {line.size(), {}, "    "};
    RTT::TaskContext* const context = state_.context();
    return context ? completionOf(*context, line, begun_.empty()) : Completion{line.size(), {}};
}

}  // namespace OCL::console
