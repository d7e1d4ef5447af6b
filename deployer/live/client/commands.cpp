// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The table of commands.
#include "command.hpp"

namespace oroforge::live_client {
namespace {

const Argument kComponent{"COMPONENT", "name of the component", Names::Component};
const Argument kPort{"PORT", "output port, as in arm.position, or a field of its samples, as in arm.position.x",
                     Names::Port};
const Option kCsv{"--csv", nullptr,
                  "A line of commas per sample, below a line with the names; the time in seconds first."};
const Option kJson{"--json", nullptr, "The same as --format=json."};
const Option kField{"--field", "NAME", "Only this field of the samples, as in pose.x or joints[2]."};
const Option kInterval{"--interval", "SECONDS", "Time between two reports; 1 if not given."};

std::vector<Command> lookingCommands() {
    return {
        {"list",
         "the deployments of this user that are running",
         "Shows the deployments of this user on this computer: name, process, since when, the number of components and "
         "their states. Removes what deployments that were killed have left.",
         {},
         {},
         {{"oro list", ""}},
         listDeployments},
        {"tree",
         "components and services, with their states",
         "Shows all components with their types, states, services and the number of their parts.",
         {{"COMPONENT", "only this one", Names::Component, 0, 1}},
         {},
         {{"oro tree", ""}},
         showTree},
        {"show",
         "the interface of a component or of a part of it",
         "Shows what a component has: properties with units and values, attributes, operations, ports, services and "
         "peers. "
         "The path of a part shows that alone.",
         {{"PATH", "component, or a part of it, as in arm.gain", Names::Part}},
         {},
         {{"oro show arm", ""}, {"oro show arm.moveTo", "an operation with its arguments"}},
         showPart},
        {"get",
         "the value of a property or attribute",
         "Reads a value in the thread of its component and writes it as the console does.",
         {{"PATH", "property or attribute, or a part of its value, as in arm.pose.x", Names::Value}},
         {},
         {{"oro get arm.gain", ""}},
         getValue},
        {"graph",
         "which ports are connected",
         "Shows the connections between ports, with their types and policies.",
         {},
         {{"--dot", nullptr, "In the language of Graphviz."}},
         {{"oro graph", ""}, {"oro graph --dot | dot -Tsvg > graph.svg", ""}},
         showGraph},
        {"top",
         "times and load of the components",
         "Shows, for each component, its period, how long its steps take (mean and longest), how late the latest one "
         "began, the share "
         "of a processor, scheduler, priority and steps that took longer than a period. On a terminal it goes on until "
         "Ctrl-C.",
         {},
         {{"--once", nullptr, "Shows it once."}, {"--interval", "SECONDS", "How long it measures; 1 if not given."}},
         {{"oro top", ""}},
         showTop},
        {"log",
         "lines of the log",
         "Shows the latest lines of the deployment's log file; with --follow also those that come, until Ctrl-C.",
         {},
         {{"-f,--follow", nullptr, "Goes on with the lines that the deployment logs from now on."},
          {"-n,--lines", "N", "So many lines of the past; 20 if not given."},
          {"--count", "N", "Follows, and ends after so many new lines."},
          {"--level", "LEVEL",
           "Only lines of this level and those that are worse: Debug, Info, Warning, Error, Critical, Fatal.",
           Names::Level}},
         {{"oro log -f", ""}, {"oro log -n 100 --level Warning", ""}},
         showLog},
    };
}

std::vector<Command> changingCommands() {
    return {
        {"set",
         "changes a property or attribute",
         "Sets a value in the thread of its component, and writes it as it is then. The value is written as the "
         "console "
         "shows it, or in JSON. Members of a struct that are not given stay as they are.",
         {{"PATH", "property or attribute, or a part of its value", Names::Value}, {"VALUE", "the new value"}},
         {},
         {{"oro set arm.gain 0.5", ""}, {"oro set arm.pose '{x = 1, y = 2}'", ""}},
         setValue},
        {"call",
         "calls an operation",
         "Calls an operation with these arguments and writes its result, and the arguments that it has changed. It is "
         "executed in the thread of its component, unless it is one with ClientThread.",
         {{"OPERATION", "path of the operation, as in arm.moveTo", Names::Operation},
          {"ARGUMENT", "in the order of the operation, as for set", Names::None, 0, kAny}},
         {{"--wait", "SECONDS", "How long the operation may take; 1 if not given."}},
         {{"oro call tank.fill 0.75", ""}, {"oro call arm.home --wait 30", ""}},
         callOperation},
        {"start",
         "starts a component",
         "Starts a component, in order: its startHook() is called.",
         {kComponent},
         {},
         {{"oro start arm", ""}},
         startComponent},
        {"stop",
         "stops a component, or ends the deployment",
         "Stops a component. Without a component it ends the deployment in order, as SIGTERM does, and waits for that.",
         {{"COMPONENT", "name of the component; none: the whole deployment", Names::Component, 0, 1}},
         {},
         {{"oro stop arm", ""}, {"oro stop", "ends the deployment"}},
         stopSomething},
        {"configure",
         "configures a component",
         "Configures a component: its configureHook() is called.",
         {kComponent},
         {},
         {{"oro configure arm", ""}},
         configureComponent},
        {"cleanup",
         "takes back the configuration of a component",
         "Takes a stopped component back to the state before it was configured: its cleanupHook() is called.",
         {kComponent},
         {},
         {{"oro cleanup arm", ""}},
         cleanUpComponent},
        {"recover",
         "takes a component out of an error",
         "Takes a component that is in a run-time error, or in the state Exception, out of it.",
         {kComponent},
         {},
         {{"oro recover arm", ""}},
         recoverComponent},
    };
}

std::vector<Command> portCommands() {
    return {
        {"echo",
         "samples of a port, as they come",
         "Shows the samples that a port writes, until Ctrl-C. Samples that could not be taken in time are counted.",
         {kPort},
         {kCsv,
          kJson,
          kField,
          {"--once", nullptr, "Ends after one sample."},
          {"--count", "N", "Ends after so many samples."},
          {"--rate", "HZ", "At most so many samples per second, the newest ones."}},
         {{"oro echo arm.position", ""}, {"oro echo arm.pose --field x --csv > x.csv", ""}},
         echoPort},
        {"hz",
         "how often a port writes",
         "Shows the rate of a port's samples, and the spread of the time between them, each second; and at the end, "
         "which is Ctrl-C, in all. The times are those at which the port was written to.",
         {kPort},
         {{"--count", "N", "Ends after so many reports."}, kInterval},
         {{"oro hz arm.position", ""}},
         showRate},
        {"delay",
         "how old samples are when they come",
         "Shows the time between the time stamp within a sample and now. Stamps are numbers of seconds or nanoseconds, "
         "of "
         "the clock of the world or of the monotonic one, or a struct of both parts. The fields header.stamp, stamp, "
         "timestamp and time are found.",
         {kPort},
         {kField, {"--count", "N", "Ends after so many reports."}, kInterval},
         {{"oro delay camera.image --field header.stamp", ""}},
         showDelay},
        {"plot",
         "a curve of a number that a port writes",
         "Draws a number over the time, until Ctrl-C. Where the output is no terminal, it draws once, at the end.",
         {kPort},
         {kField,
          {"--seconds", "S", "Time that the curve shows; 10 if not given."},
          {"--height", "LINES", "Height of the picture; 16 if not given."},
          {"--count", "N", "Ends after so many samples."},
          {"--once", nullptr, "Draws once, when the time has passed."}},
         {{"oro plot arm.position.x", ""}, {"oro plot tank.level --seconds 60", ""}},
         plotPort},
        {"record",
         "records ports to a file for Foxglove and PlotJuggler",
         "Writes all samples of output ports to an MCAP file, until Ctrl-C or the end of the deployment: all ports and "
         "the log, or those that the patterns match. Components that come later are recorded, too. Samples that did "
         "not find room are gaps in the numbers of the messages, and are counted. A file that exists is refused. "
         "'oro-mcap' reads recordings.",
         {{"PATTERN",
           "ports, as in 'arm.*'; a component or service, with all its ports; a topic, as in /arm/position; rosout: "
           "the log",
           Names::Port, 0, kAny}},
         {{"-o,--output", "FILE", "The file; if not given, the name of the deployment with date and time.",
           Names::File},
          {"--force", nullptr, "Overwrites a file that exists."},
          {"--duration", "SECONDS", "Ends after so many seconds."},
          {"--compression", "NAME", "zstd, lz4 or none; zstd if not given.", Names::Compression},
          {"--split", "SIZE|TIME",
           "When a file ends and the next one begins, as in '500 MB' or '60 s'; they are FILE_1, FILE_2 and so on."},
          {"--buffer", "N", "So many samples of a port may wait in the deployment; 200 if not given."}},
         {{"oro record", "all ports"}, {"oro record 'arm.*' camera.image -o run.mcap --duration 10", ""}},
         recordPorts},
    };
}

std::vector<Command> programCommands() {
    return {
        {"console",
         "the console of the deployment",
         "Opens a prompt at which the deployment executes commands and statements, as the one of deployer does. Ctrl-C "
         "stops the "
         "command that is executed, Ctrl-D leaves the console; the deployment goes on. Without a terminal it executes "
         "the "
         "lines of standard input.",
         {},
         {},
         {{"oro console", ""}, {"echo 'arm.gain = 0.5' | oro console", ""}},
         runConsole},
        {"mcap",
         "reads recordings",
         "Reads recordings (MCAP files), as the program oro-mcap does, without a deployment: info, cat, convert, diff "
         "and "
         "recover. 'oro mcap --help' lists the commands, 'oro mcap cat --help' explains one. The exit status is 0 if "
         "all "
         "is well, 1 if part of a file is damaged or two files differ, 2 if the command line is wrong or a file cannot "
         "be "
         "read.",
         {{"COMMAND", "info, cat, convert, diff or recover", Names::Recording},
          {"FILE", "recordings", Names::File, 0, kAny}},
         {},
         {{"oro mcap info run.mcap", ""},
          {"oro mcap cat run.mcap --topic /arm/position", ""},
          {"oro mcap diff before.mcap after.mcap", ""}},
         readRecording,
         "oro-mcap"},
        {"completion",
         "the completion of a shell",
         "Writes a script that makes a shell complete the commands of oro, and names of the deployment that is "
         "running. Packages "
         "have it installed.",
         {{"SHELL", "bash, zsh or fish", Names::Shell}},
         {},
         {{"eval \"$(oro completion bash)\"", ""}},
         writeCompletion},
        {"man",
         "the manual page of oro or of a command",
         "Writes a manual page. 'oro man echo | man -l -' shows it.",
         {{"COMMAND", "name of a command; none: oro itself", Names::None, 0, 1}},
         {{"--directory", "DIR", "Writes all pages into this directory instead.", Names::File}},
         {{"oro man echo | man -l -", ""}},
         writeManual},
    };
}

}  // namespace

const std::vector<Command>& commands() {
    static const std::vector<Command> kCommands = [] {
        std::vector<Command> all;
        for (const std::vector<Command>& some :
             {lookingCommands(), changingCommands(), portCommands(), programCommands()})
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }();
    return kCommands;
}

const std::vector<Option>& commonOptions() {
    static const std::vector<Option> kOptions{
        {"-d,--deployment", "NAME|PID",
         "Deployment to talk to, by its name, its process or the path of its socket. Needed only if there is more "
         "than one. ORO_DEPLOYMENT sets it, too.",
         Names::Deployment},
        {"--url", "URL",
         "Address that deployer --web has printed, as in ws://127.0.0.1:8765/?token=...; the token may be in ORO_TOKEN "
         "instead."},
        {"--format", "FORMAT", "text, or json for other programs.", Names::Format},
        {"--timeout", "SECONDS", "How long the deployment may take to answer; 5 if not given."},
    };
    return kOptions;
}

const Command* commandNamed(const std::string& name) {
    for (const Command& command : commands())
        if (name == command.name) return &command;
    return nullptr;
}

std::string keyOf(const Option& option) {
    const std::string names = option.names;
    return names.substr(names.rfind("--") + 2);
}

std::string usageOf(const Command& command) {
    std::string text;
    for (const Argument& argument : command.arguments) {
        const std::string word = argument.most == kAny ? std::string(argument.name) + "..." : argument.name;
        text += (text.empty() ? "" : " ") + (argument.least ? word : "[" + word + "]");
    }
    return text;
}

}  // namespace oroforge::live_client
