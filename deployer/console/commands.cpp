// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "commands.hpp"

#include "interface_text.hpp"
#include "listing.hpp"
#include "scripted.hpp"
#include "table.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>
#include <cstdlib>
#include <ostream>

namespace OCL::console {

using oroforge::diag::didYouMean;

void ConsoleState::goTo(bool watching) {
    watch.reset();
    forgetInput();
    RTT::TaskContext* const component = place.component();
    if (!watching || !component) return;
    watch = std::make_unique<Watch>(self, *component);
    for (const std::string& port : watch->missing())
        screen.err << "port '" << port << "' of component '" << component->getName() << "' cannot be watched\n";
}

std::vector<Gate> ConsoleState::around() const {
    std::vector<Gate> gates = place.roots();
    gates.push_back(self.engine()->gate());
    if (const RTT::TaskContext* const component = place.component()) gates.push_back(component->engine()->gate());
    return gates;
}

void complainOf(ConsoleState& state, const Input& input, std::size_t at, const ResolvedName& lookup) {
    complain(state.screen, input, at + lookup.wrongAt,
             lookup.wrong.empty()
                 ? "expected the name of a peer or service"
                 : "there is no peer or service '" + lookup.wrong + "'" + didYouMean(lookup.wrong, lookup.known));
}

namespace {

void quit(ConsoleState& state, const Input&) { state.quits = true; }

bool helpForCommand(ConsoleState& state, const std::string& word) {
    for (const auto* const all : {&commands(), &dotCommands()})
        for (const Command& command : *all)
            if (word == command.word) {
                Table table({Style::Plain, Style::Plain}, Table::Wrap);
                table.add(
                    {command.word + std::string(*command.arguments ? " " : "") + command.arguments, command.help});
                table.write(state.screen.out, state.screen.theme, "", state.screen.tableWidth());
                return true;
            }
    return false;
}

/** Shows help if the last part of the path is an operation, port, property or attribute of what the others lead to. */
bool helpForMember(ConsoleState& state, const std::string& path) {
    const auto [before, name] = RTT::internal::splitAtLastDot(path);
    const ResolvedName owner = RTT::internal::resolve(*state.context(), before);
    if (!owner.target.service) return false;
    RTT::Service& service = *owner.target.service;
    if (service.hasMember(name)) {
        describeOperation(state.screen, service, name, "");
        return true;
    }
    if (describePort(state.screen, service, name, path, state.around()) || describeValue(state.screen, service, name))
        return true;
    const auto global = RTT::internal::GlobalService::Instance();
    if (!before.empty() || !global->hasMember(name)) return false;
    describeOperation(state.screen, *global, name, "");
    return true;
}

std::vector<std::string> memberNames(RTT::Service& service) {
    std::vector<std::string> names = service.getNames();
    for (const auto& more : {service.getAttributeNames(), service.properties()->list(), service.getPortNames(),
                             service.getProviderNames()})
        names.insert(names.end(), more.begin(), more.end());
    return names;
}

bool isGlobals(const std::string& name) { return name == "GlobalsRepository"; }

void help(ConsoleState& state, const Input& input) {
    if (input.words.size() < 2) return writeHelp(state.screen);
    if (isGlobals(input.words[1].text)) return describeGlobals(state.screen);
    const Word word = {withoutLastDot(input.words[1].text), input.words[1].begin};
    if (helpForCommand(state, word.text) || helpForMember(state, word.text)) return;
    ResolvedName lookup = RTT::internal::resolve(*state.context(), word.text);
    if (lookup.target.service) return describeInterface(state.screen, lookup.target, state.around());
    if (describeType(state.screen, word.text)) return;
    const std::string before = word.text.substr(0, lookup.wrongAt ? lookup.wrongAt - 1 : 0);
    const ResolvedName owner = RTT::internal::resolve(*state.context(), before);
    if (owner.target.service)
        for (const std::string& name : memberNames(*owner.target.service)) lookup.known.push_back(name);
    for (const Command& command : commands()) lookup.known.push_back(command.word);
    const bool isWhole = lookup.wrong == word.text;
    for (const std::string& type : RTT::types::Types()->getDottedTypes())
        if (isWhole || type.find('.') != std::string::npos) lookup.known.push_back(type);
    complain(state.screen, input, word.begin + lookup.wrongAt,
             "there is nothing called '" + lookup.wrong + "' here" + didYouMean(lookup.wrong, lookup.known));
}

void ls(ConsoleState& state, const Input& input) {
    const Word path = input.words.size() > 1 ? input.words[1] : Word{};
    if (isGlobals(path.text)) return describeGlobals(state.screen);
    const ResolvedName lookup = RTT::internal::resolve(*state.context(), path.text);
    if (!lookup.target.service) return complainOf(state, input, path.begin, lookup);
    list(state.screen, lookup.target, state.around());
}

void peers(ConsoleState& state, const Input&) {
    RTT::TaskContext& component = *state.context();
    Table table({Style::Name, Style::Plain});
    for (const std::string& name : component.getPeerList()) {
        RTT::TaskContext* const peer = component.getPeer(name);
        table.add({name, peer && peer->ready() ? std::string("[") + stateLetter(*peer) + "]" : "[X]"});
    }
    if (table.empty()) state.screen.out << "component '" << component.getName() << "' has no peers\n";
    table.write(state.screen.out, state.screen.theme, "", 0);
}

void changePlace(ConsoleState& state, const Input& input) {
    const Word path = input.words.size() > 1 ? input.words[1] : Word{};
    const bool watching = state.watch != nullptr;
    if (path.text == "..") {
        if (!state.place.back()) return complain(state.screen, input, path.begin, "there was no visit before this one");
        return state.goTo(watching);
    }
    RTT::TaskContext* const component = state.place.component();
    const ResolvedName lookup = RTT::internal::resolve(*component, path.text);
    if (!lookup.target.service) return complainOf(state, input, path.begin, lookup);
    if (!lookup.target.component)
        return complain(state.screen, input, path.begin,
                        "'" + path.text + "' is a service, expected a component; 'ls " + path.text + "' shows it");
    if (lookup.target.component == &state.self)
        return complain(state.screen, input, path.begin, "the console itself cannot be visited; 'leave' shows it");
    if (lookup.target.component == component && !path.text.empty()) {
        state.screen.out << "already in " << component->getName() << '\n';
        return;
    }
    // Peers may have changed since the look-up.
    if (!state.place.visit(path.text)) return complainOf(state, input, path.begin, lookup);
    state.goTo(watching);
}

void enter(ConsoleState& state, const Input&) { state.goTo(false); }

void leave(ConsoleState& state, const Input&) {
    if (!state.watch) state.goTo(true);
}

std::string noScripted(ConsoleState& state, const std::string& name) {
    return "component '" + state.context()->getName() + "' has no program or state machine '" + name + "'" +
           didYouMean(name, scriptedNames(*state.context()));
}

bool isNumber(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

void listProgram(ConsoleState& state, const Input& input) {
    const auto number = [&](std::size_t i) {
        constexpr long kMost = 1000000000;
        const long found = i < input.words.size() ? std::strtol(input.words[i].text.c_str(), nullptr, 10) : 0;
        return static_cast<int>(std::min(found, kMost));
    };
    RTT::TaskContext& component = *state.context();
    if (input.words.size() < 2 || isNumber(input.words[1].text)) {
        if (!state.listing.listMore(state.screen, component, number(1)))
            complain(state.screen, input, input.words[0].begin,
                     "nothing was listed before; expected the name of a program or state machine");
        return;
    }
    if (input.words.size() > 2 && !isNumber(input.words[2].text))
        return complain(state.screen, input, input.words[2].begin,
                        "expected the number of a line, found '" + input.words[2].text + "'");
    if (!state.listing.list(state.screen, component, input.words[1].text, number(2)))
        complain(state.screen, input, input.words[1].begin, noScripted(state, input.words[1].text));
}

void trace(ConsoleState& state, const Input& input) {
    if (input.words.size() < 2) return state.listing.traceAll(state.screen, *state.context());
    if (!state.listing.trace(state.screen, *state.context(), input.words[1].text))
        complain(state.screen, input, input.words[1].begin, noScripted(state, input.words[1].text));
}

void untrace(ConsoleState& state, const Input& input) {
    if (input.words.size() < 2) return state.listing.untraceAll();
    const std::string& name = input.words[1].text;
    if (!state.listing.untrace(*state.context(), name))
        complain(state.screen, input, input.words[1].begin, "'" + name + "' is not traced");
}

}  // namespace

const std::vector<Command>& commands() {
    static const std::vector<Command> all = {
        {"ls", "[PATH]", "shows what a component or service has; without a path, the present one", Argument::Path, &ls},
        {"cd", "[PATH]",
         "goes to a peer; '..' is the component visited before; without a path, where the console began",
         Argument::Component, &changePlace},
        {"peers", "", "shows the peers and their states", Argument::None, &peers},
        {"help", "[NAME]", "explains a command, or what a component, service, operation, port, value or type is",
         Argument::Name, &help},
        {"leave", "", "watches the component from outside: the console gets a port for each of its ports",
         Argument::None, &leave},
        {"enter", "", "goes back into the component that is watched", Argument::None, &enter},
        {"list", "[NAME] [LINE]", "shows the text of a program or state machine and where it is", Argument::Scripted,
         &listProgram},
        {"trace", "[NAME]", "shows it again whenever it has come to another line; without a name, all of them",
         Argument::Scripted, &trace},
        {"untrace", "[NAME]", "ends that; without a name, for all of them", Argument::Scripted, &untrace},
        {"quit", "", "leaves the console, as Ctrl-D does", Argument::None, &quit},
    };
    return all;
}

const Command* commandIn(const Input& input) {
    if (input.words.empty()) return nullptr;
    const std::string& word = input.words[0].text;
    if (input.words.size() > 1) {
        const char next = input.words[1].text[0];
        if (next == '=' || next == '(' || next == '[') return nullptr;
    }
    for (const auto* const all : {&commands(), &dotCommands()})
        for (const Command& command : *all)
            if (word == command.word) return &command;
    return nullptr;
}

void execute(const Command& command, ConsoleState& state, const Input& input) {
    const std::string arguments = command.arguments;
    const bool any = arguments.find("…") != std::string::npos;
    const std::size_t most = Input("", 1, arguments).words.size();
    if (any || input.words.size() <= most + 1) return command.act(state, input);
    const Word& surplus = input.words[most + 1];
    complain(state.screen, input, surplus.begin,
             std::string("'") + command.word + "' takes " + (most > 0 ? arguments : "nothing") + ", found '" +
                 surplus.text + "' as well");
}

}  // namespace OCL::console
