// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The commands that begin with a dot.
#include "commands.hpp"

#include "table.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/scripting/Scripting.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>
#include <cctype>
#include <exception>
#include <fstream>
#include <ostream>

namespace OCL::console {
namespace {

using RTT::plugin::PluginLoader;

void dark(ConsoleState& state, const Input&) { state.screen.theme = Theme(Theme::Dark); }
void light(ConsoleState& state, const Input&) { state.screen.theme = Theme(Theme::Light); }
void noColors(ConsoleState& state, const Input&) { state.screen.theme = Theme(Theme::NoColors); }
void hex(ConsoleState& state, const Input&) { state.screen.hex = true; }
void noHex(ConsoleState& state, const Input&) { state.screen.hex = false; }

void writeNames(ConsoleState& state, const char* title, std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    Screen& screen = state.screen;
    screen.out << screen.paint(Style::Title, title) << (names.empty() ? " none\n" : "\n");
    writeColumns(screen.out, names, screen.theme, Style::Name, "    ", screen.width());
}

void services(ConsoleState& state, const Input&) {
    writeNames(state, "Services that can be loaded:", PluginLoader::Instance()->listServices());
}
void plugins(ConsoleState& state, const Input&) {
    writeNames(state, "Plugins:", PluginLoader::Instance()->listPlugins());
}
void typekits(ConsoleState& state, const Input&) {
    writeNames(state, "Typekits:", PluginLoader::Instance()->listTypekits());
}
void types(ConsoleState& state, const Input&) { writeNames(state, "Types:", RTT::types::Types()->getDottedTypes()); }

void provide(ConsoleState& state, const Input& input) {
    if (!hasWords(state, input, 1, "the names of services; '.services' shows them")) return;
    RTT::TaskContext& component = *state.context();
    for (std::size_t i = 1; i != input.words.size(); ++i) {
        const Word& service = input.words[i];
        if (component.provides()->hasService(service.text))
            state.screen.out << "component '" << component.getName() << "' has service '" << service.text
                             << "' already\n";
        else if (component.loadService(service.text))
            state.screen.out << "service '" << service.text << "' loaded into component '" << component.getName()
                             << "'\n";
        else
            complain(state.screen, input, service.begin,
                     "service '" + service.text + "' cannot be loaded" +
                         oroforge::diag::didYouMean(service.text, PluginLoader::Instance()->listServices()));
    }
}

void connect(ConsoleState& state, const Input& input) {
    if (!hasWords(state, input, 2, "the paths of two ports")) return;
    RTT::base::PortInterface* const one = findPort(state, input, input.words[1]);
    RTT::base::PortInterface* const two = findPort(state, input, input.words[2]);
    if (!one || !two) return;
    if (one->connectTo(two))
        state.screen.out << input.words[1].text << " and " << input.words[2].text << " are connected\n";
    else
        complain(state.screen, input, input.words[1].begin, "the ports cannot be connected; the log says why");
}

bool isName(const std::string& text) {
    const auto isLetter = [](char c) { return c == '_' || std::isalpha(static_cast<unsigned char>(c)); };
    return isLetter(text[0]) && std::all_of(text.begin(), text.end(), [&](char c) {
               return isLetter(c) || std::isdigit(static_cast<unsigned char>(c));
           });
}

void beginMacro(ConsoleState& state, const Input& input) {
    if (!hasWords(state, input, 1, "a name for the function")) return;
    const Word& name = input.words[1];
    if (state.macro.recording())
        return complain(state.screen, input, input.words[0].begin,
                        "'" + state.macro.name() + "' is being recorded; '.end' or '.cancel' ends that");
    if (!isName(name.text))
        return complain(state.screen, input, name.begin, "expected a name for the function, found '" + name.text + "'");
    state.macro.begin(name.text);
    std::string first;
    if (std::ifstream there(state.macro.file()); std::getline(there, first) && first != state.macro.title()) {
        complain(state.screen, input, name.begin,
                 "there is a file '" + state.macro.file() + "' that was not recorded; expected another name");
        return state.macro.cancel();
    }
    state.screen.out << "recording; '.end' keeps it as " << state.macro.file() << ", '.cancel' does not\n"
                     << state.macro.head() << '\n';
}

bool isRecording(ConsoleState& state, const Input& input) {
    if (!state.macro.recording()) complain(state.screen, input, input.words[0].begin, "nothing is being recorded");
    return state.macro.recording();
}

void cancelMacro(ConsoleState& state, const Input& input) {
    if (isRecording(state, input)) state.macro.cancel();
}

void endMacro(ConsoleState& state, const Input& input) {
    if (!isRecording(state, input)) return;
    const std::string file = state.macro.file(), text = state.macro.text();
    state.macro.cancel();
    state.screen.out << "}\n";
    std::ofstream out(file);
    out << text;
    out.close();
    if (!out) complain(state.screen, input, input.words[0].begin, "cannot write '" + file + "'");
    RTT::scripting::TypedInput::Answer answer;
    const bool loaded = RTT::scripting::TypedInput(*state.context(), file).execute(text, 1, state.screen.err, answer);
    state.screen.failed = state.screen.failed || !loaded;
    if (!out) return;
    if (loaded)
        state.screen.out << "written to " << file << " and loaded into component '" << state.context()->getName()
                         << "'\n";
    else
        state.screen.err << "written to " << file << ", but not loaded\n";
}

typedef RTT::Scripting::OfName RTT::Scripting::*Operation;

/** Calls the operation of the service "scripting" for each word. */
void forEachWord(ConsoleState& state, const Input& input, Operation operation, const char* expected) {
    if (!hasWords(state, input, 1, expected)) return;
    const auto scripting = state.context()->getProvider<RTT::Scripting>("scripting");
    if (!scripting)
        return complain(state.screen, input, input.words[0].begin,
                        "component '" + state.context()->getName() + "' has no service 'scripting'");
    for (std::size_t i = 1; i != input.words.size(); ++i)
        if (!((*scripting).*operation)(input.words[i].text))
            complain(state.screen, input, input.words[i].begin, "that failed; the log says why");
}

void loadProgram(ConsoleState& state, const Input& input) {
    forEachWord(state, input, &RTT::Scripting::loadPrograms, "a file of programs and functions");
}
void unloadProgram(ConsoleState& state, const Input& input) {
    forEachWord(state, input, &RTT::Scripting::unloadProgram, "the name of a program");
}
void loadStateMachine(ConsoleState& state, const Input& input) {
    forEachWord(state, input, &RTT::Scripting::loadStateMachines, "a file of state machines");
}
void unloadStateMachine(ConsoleState& state, const Input& input) {
    forEachWord(state, input, &RTT::Scripting::unloadStateMachine, "the name of a state machine");
}

/** Loads the service Lua into the present component and executes a file, or the code itself. */
void lua(ConsoleState& state, const Input& input) {
    if (!hasWords(state, input, 1, "code of Lua, or a file FILE.lua")) return;
    RTT::TaskContext& component = *state.context();
    const RTT::Service::shared_ptr service =
        component.loadService("Lua") ? component.provides()->getService("Lua") : nullptr;
    if (!service) return complain(state.screen, input, input.words[0].begin, "the service 'Lua' cannot be loaded");
    const std::string code = input.from(1);
    const std::string suffix = ".lua";
    const bool isFile = input.words.size() == 2 && code.size() > suffix.size() &&
                        code.compare(code.size() - suffix.size(), suffix.size(), suffix) == 0;
    RTT::OperationCaller<bool(const std::string&)> run(service->getOperation(isFile ? "exec_file" : "exec_str"));
    if (!run.ready() || !run(code))
        complain(state.screen, input, input.words[1].begin, "that failed; the log says why");
}

}  // namespace

bool hasWords(ConsoleState& state, const Input& input, std::size_t count, const char* expected) {
    if (input.words.size() > count) return true;
    complain(state.screen, input, input.text.size(), std::string("expected ") + expected);
    return false;
}

RTT::base::PortInterface* findPort(ConsoleState& state, const Input& input, const Word& word) {
    const auto [path, name] = RTT::internal::splitAtLastDot(word.text);
    const ResolvedName owner = RTT::internal::resolve(*state.context(), path);
    if (!owner.target.service) {
        complainOf(state, input, word.begin, owner);
        return nullptr;
    }
    RTT::base::PortInterface* const port = owner.target.service->getPort(name);
    if (!port)
        complain(state.screen, input, word.begin + word.text.size() - name.size(),
                 "'" + owner.target.name + "' has no port '" + name + "'" +
                     oroforge::diag::didYouMean(name, owner.target.service->getPortNames()));
    return port;
}

const std::vector<Command>& dotCommands() {
    static const std::vector<Command> all = {
        {".services", "", "names the services that .provide can load", Argument::None, &services},
        {".plugins", "", "names the plugins that are loaded", Argument::None, &plugins},
        {".typekits", "", "names the typekits that are loaded", Argument::None, &typekits},
        {".types", "", "names the types that values can have", Argument::None, &types},
        {".provide", "SERVICE…", "loads services into the present component", Argument::Service, &provide},
        {".connect", "PORT PORT", "connects two ports with the default policy", Argument::Port, &connect},
        {".watch", "PORT [COUNT]", "shows the samples of an output port as they come, so many or until Enter or Ctrl-C",
         Argument::Port, &watchPort},
        {".hz", "PORT [COUNT]", "shows each second how often an output port is written", Argument::Port, &showRate},
        {".loadProgram", "FILE…", "loads programs and functions into the present component", Argument::File,
         &loadProgram},
        {".unloadProgram", "NAME…", "removes programs", Argument::Scripted, &unloadProgram},
        {".loadStateMachine", "FILE…", "loads state machines into the present component", Argument::File,
         &loadStateMachine},
        {".unloadStateMachine", "NAME…", "stops and removes state machines", Argument::Scripted, &unloadStateMachine},
        {".lua", "FILE.lua|CODE…", "executes a file, or code, in Lua; rtt.getTC() is the present component",
         Argument::File, &lua},
        {".record", "NAME", "makes a function of the lines that are typed from now on", Argument::None, &beginMacro},
        {".end", "", "writes it to NAME.ops and loads it", Argument::None, &endMacro},
        {".cancel", "", "forgets it", Argument::None, &cancelMacro},
        {".hex", "", "shows whole numbers in hexadecimal notation", Argument::None, &hex},
        {".nohex", "", "ends that", Argument::None, &noHex},
        {".dark", "", "colours for a dark background", Argument::None, &dark},
        {".light", "", "colours for a light background", Argument::None, &light},
        {".nocolors", "", "no colours", Argument::None, &noColors},
    };
    return all;
}

}  // namespace OCL::console
