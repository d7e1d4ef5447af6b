// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The commands that begin with a dot.
#include "commands.hpp"

#include "table.hpp"

#include <diag/nearest_match.hpp>
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

void dark(Session& session, const Input&) { session.screen.theme = Theme(Theme::Dark); }
void light(Session& session, const Input&) { session.screen.theme = Theme(Theme::Light); }
void noColors(Session& session, const Input&) { session.screen.theme = Theme(Theme::NoColors); }
void hex(Session& session, const Input&) { session.screen.hex = true; }
void noHex(Session& session, const Input&) { session.screen.hex = false; }

void writeNames(Session& session, const char* title, std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    Screen& screen = session.screen;
    screen.out << screen.paint(Style::Title, title) << (names.empty() ? " none\n" : "\n");
    writeColumns(screen.out, names, screen.theme, Style::Name, "    ", screen.width());
}

void services(Session& session, const Input&) {
    writeNames(session, "Services that can be loaded:", PluginLoader::Instance()->listServices());
}
void plugins(Session& session, const Input&) {
    writeNames(session, "Plugins:", PluginLoader::Instance()->listPlugins());
}
void typekits(Session& session, const Input&) {
    writeNames(session, "Typekits:", PluginLoader::Instance()->listTypekits());
}
void types(Session& session, const Input&) { writeNames(session, "Types:", RTT::types::Types()->getDottedTypes()); }

/** False, with an error, if the command stands alone. */
bool hasWords(Session& session, const Input& input, std::size_t count, const char* expected) {
    if (input.words.size() > count) return true;
    complain(session.screen, input, input.text.size(), std::string("expected ") + expected);
    return false;
}

void provide(Session& session, const Input& input) {
    if (!hasWords(session, input, 1, "the names of services; '.services' shows them")) return;
    RTT::TaskContext& component = *session.context();
    for (std::size_t i = 1; i != input.words.size(); ++i) {
        const Word& service = input.words[i];
        if (component.provides()->hasService(service.text))
            session.screen.out << "component '" << component.getName() << "' has service '" << service.text
                               << "' already\n";
        else if (component.loadService(service.text))
            session.screen.out << "service '" << service.text << "' loaded into component '" << component.getName()
                               << "'\n";
        else
            complain(session.screen, input, service.begin,
                     "service '" + service.text + "' cannot be loaded" +
                         oroforge::diag::didYouMean(service.text, PluginLoader::Instance()->listServices()));
    }
}

RTT::base::PortInterface* findPort(Session& session, const Input& input, const Word& word) {
    const std::size_t dot = word.text.rfind('.');
    const std::string path = dot == std::string::npos ? "" : word.text.substr(0, dot);
    const std::string name = dot == std::string::npos ? word.text : word.text.substr(dot + 1);
    const Lookup owner = lookUp(*session.context(), path);
    if (!owner.target.service) {
        complainOf(session, input, word.begin, owner);
        return nullptr;
    }
    RTT::base::PortInterface* const port = owner.target.service->getPort(name);
    if (!port)
        complain(session.screen, input, word.begin + (dot == std::string::npos ? 0 : dot + 1),
                 "'" + owner.target.name + "' has no port '" + name + "'" +
                     oroforge::diag::didYouMean(name, owner.target.service->getPortNames()));
    return port;
}

void connect(Session& session, const Input& input) {
    if (!hasWords(session, input, 2, "the paths of two ports")) return;
    RTT::base::PortInterface* const one = findPort(session, input, input.words[1]);
    RTT::base::PortInterface* const two = findPort(session, input, input.words[2]);
    if (!one || !two) return;
    if (one->connectTo(two))
        session.screen.out << input.words[1].text << " and " << input.words[2].text << " are connected\n";
    else
        complain(session.screen, input, input.words[1].begin, "the ports cannot be connected; the log says why");
}

bool isName(const std::string& text) {
    const auto isLetter = [](char c) { return c == '_' || std::isalpha(static_cast<unsigned char>(c)); };
    return isLetter(text[0]) && std::all_of(text.begin(), text.end(), [&](char c) {
               return isLetter(c) || std::isdigit(static_cast<unsigned char>(c));
           });
}

void beginMacro(Session& session, const Input& input) {
    if (!hasWords(session, input, 1, "a name for the function")) return;
    const Word& name = input.words[1];
    if (session.macro.recording())
        return complain(session.screen, input, input.words[0].begin,
                        "'" + session.macro.name() + "' is being recorded; '.end' or '.cancel' ends that");
    if (!isName(name.text))
        return complain(session.screen, input, name.begin,
                        "expected a name for the function, found '" + name.text + "'");
    session.macro.begin(name.text);
    std::string first;
    if (std::ifstream there(session.macro.file()); std::getline(there, first) && first != session.macro.title()) {
        complain(session.screen, input, name.begin,
                 "there is a file '" + session.macro.file() + "' that was not recorded; expected another name");
        return session.macro.cancel();
    }
    session.screen.out << "recording; '.end' keeps it as " << session.macro.file() << ", '.cancel' does not\n"
                       << session.macro.head() << '\n';
}

bool isRecording(Session& session, const Input& input) {
    if (!session.macro.recording()) complain(session.screen, input, input.words[0].begin, "nothing is being recorded");
    return session.macro.recording();
}

void cancelMacro(Session& session, const Input& input) {
    if (isRecording(session, input)) session.macro.cancel();
}

void endMacro(Session& session, const Input& input) {
    if (!isRecording(session, input)) return;
    const std::string file = session.macro.file(), text = session.macro.text();
    session.macro.cancel();
    session.screen.out << "}\n";
    std::ofstream out(file);
    out << text;
    out.close();
    if (!out) complain(session.screen, input, input.words[0].begin, "cannot write '" + file + "'");
    RTT::scripting::TypedInput::Answer answer;
    const bool loaded =
        RTT::scripting::TypedInput(*session.context(), file).execute(text, 1, session.screen.err, answer);
    session.screen.failed = session.screen.failed || !loaded;
    if (!out) return;
    if (loaded)
        session.screen.out << "written to " << file << " and loaded into component '" << session.context()->getName()
                           << "'\n";
    else
        session.screen.err << "written to " << file << ", but not loaded\n";
}

typedef RTT::Scripting::OfName RTT::Scripting::*Operation;

/** The operation of the service "scripting", for each word. */
void forEachWord(Session& session, const Input& input, Operation operation, const char* expected) {
    if (!hasWords(session, input, 1, expected)) return;
    const auto scripting = session.context()->getProvider<RTT::Scripting>("scripting");
    if (!scripting)
        return complain(session.screen, input, input.words[0].begin,
                        "component '" + session.context()->getName() + "' has no service 'scripting'");
    for (std::size_t i = 1; i != input.words.size(); ++i)
        if (!((*scripting).*operation)(input.words[i].text))
            complain(session.screen, input, input.words[i].begin, "that failed; the log says why");
}

void loadProgram(Session& session, const Input& input) {
    forEachWord(session, input, &RTT::Scripting::loadPrograms, "a file of programs and functions");
}
void unloadProgram(Session& session, const Input& input) {
    forEachWord(session, input, &RTT::Scripting::unloadProgram, "the name of a program");
}
void loadStateMachine(Session& session, const Input& input) {
    forEachWord(session, input, &RTT::Scripting::loadStateMachines, "a file of state machines");
}
void unloadStateMachine(Session& session, const Input& input) {
    forEachWord(session, input, &RTT::Scripting::unloadStateMachine, "the name of a state machine");
}

}  // namespace

const std::vector<Command>& dotCommands() {
    static const std::vector<Command> all = {
        {".services", "", "names the services that .provide can load", Argument::None, &services},
        {".plugins", "", "names the plugins that are loaded", Argument::None, &plugins},
        {".typekits", "", "names the typekits that are loaded", Argument::None, &typekits},
        {".types", "", "names the types that values can have", Argument::None, &types},
        {".provide", "SERVICE…", "loads services into the present component", Argument::Service, &provide},
        {".connect", "PORT PORT", "connects two ports with the default policy", Argument::Port, &connect},
        {".loadProgram", "FILE…", "loads programs and functions into the present component", Argument::File,
         &loadProgram},
        {".unloadProgram", "NAME…", "removes programs", Argument::Scripted, &unloadProgram},
        {".loadStateMachine", "FILE…", "loads state machines into the present component", Argument::File,
         &loadStateMachine},
        {".unloadStateMachine", "NAME…", "stops and removes state machines", Argument::Scripted, &unloadStateMachine},
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
