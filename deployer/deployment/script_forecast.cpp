// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "script_forecast.hpp"

#include "lookup.hpp"

#include <diag/nearest_match.hpp>
#include <diag/type_match.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <algorithm>
#include <exception>
#include <iterator>
#include <map>
#include <utility>

namespace OCL::deploy {

using RTT::ComponentLoader;
using RTT::plugin::PluginLoader;

namespace {

enum class Effect { None, Import, Path, Library, Component, Peers, Service, Require, Change, ChangeAll };

/** Others may do anything. */
const std::map<std::string, Effect>& effects() {
    static const std::map<std::string, Effect> all = {
        {"import", Effect::Import},
        {"path", Effect::Path},
        {"loadLibrary", Effect::Library},
        {"loadComponent", Effect::Component},
        {"addPeer", Effect::Peers},
        {"aliasPeer", Effect::Peers},
        {"connectPeers", Effect::Peers},
        {"loadService", Effect::Service},
        {"require", Effect::Require},
        {"configureComponent", Effect::Change},
        {"startComponent", Effect::Change},
        {"stopComponent", Effect::Change},
        {"configureComponents", Effect::ChangeAll},
        {"startComponents", Effect::ChangeAll},
        {"stopComponents", Effect::ChangeAll},
        {"displayComponentTypes", Effect::None},
        {"getComponentTypes", Effect::None},
        {"connect", Effect::None},
        {"connectPorts", Effect::None},
        {"connectTwoPorts", Effect::None},
        {"stream", Effect::None},
        {"createStream", Effect::None},
        {"connectServices", Effect::None},
        {"connectOperations", Effect::None},
        {"setActivity", Effect::None},
        {"setActivityOnCPU", Effect::None},
        {"setPeriodicActivity", Effect::None},
        {"setFileDescriptorActivity", Effect::None},
        {"setSequentialActivity", Effect::None},
        {"setSlaveActivity", Effect::None},
        {"setMasterSlaveActivity", Effect::None},
        {"setWaitPeriodPolicy", Effect::None},
        {"waitForInterrupt", Effect::None},
        {"waitForSignal", Effect::None},
        {"getPeriod", Effect::None},
        {"setPeriod", Effect::None},
        {"getCpuAffinity", Effect::None},
        {"setCpuAffinity", Effect::None},
        {"isActive", Effect::None},
        {"isConfigured", Effect::None},
        {"isRunning", Effect::None},
    };
    return all;
}

/** Which arguments name a component, or "component.port". */
struct Named {
    std::size_t argument;
    bool isPort;
};

const std::multimap<std::string, Named>& namedArguments() {
    static const std::multimap<std::string, Named> all = {
        {"addPeer", {0, false}},
        {"addPeer", {1, false}},
        {"aliasPeer", {0, false}},
        {"aliasPeer", {1, false}},
        {"connectPeers", {0, false}},
        {"connectPeers", {1, false}},
        {"loadService", {0, false}},
        {"configureComponent", {0, false}},
        {"startComponent", {0, false}},
        {"stopComponent", {0, false}},
        {"connect", {0, true}},
        {"connect", {1, true}},
        {"connectPorts", {0, false}},
        {"connectPorts", {1, false}},
        {"connectTwoPorts", {0, false}},
        {"connectTwoPorts", {2, false}},
        {"stream", {0, true}},
        {"createStream", {0, false}},
        {"connectServices", {0, false}},
        {"connectServices", {1, false}},
        {"setActivity", {0, false}},
        {"setActivityOnCPU", {0, false}},
        {"setPeriodicActivity", {0, false}},
        {"setFileDescriptorActivity", {0, false}},
        {"setSequentialActivity", {0, false}},
        {"setSlaveActivity", {0, false}},
        {"setMasterSlaveActivity", {0, false}},
        {"setMasterSlaveActivity", {1, false}},
        {"setWaitPeriodPolicy", {0, false}},
    };
    return all;
}

/** Services whose operations load nothing. */
bool isHarmless(const std::vector<std::string>& path) {
    static const char* const pauses[] = {"getenv", "isenv",      "argc",   "argv",
                                         "sleep",  "millisleep", "usleep", "nanosleep"};
    const bool isPause = std::find(std::begin(pauses), std::end(pauses), path.back()) != std::end(pauses);
    return path.size() == 2 && (path.front() == "print" || (path.front() == "os" && isPause));
}

/** What every component has and executes no code of its own. */
bool isQuery(const std::string& operation) {
    static const char* const all[] = {"getPeriod",   "setPeriod",     "getCpuAffinity", "setCpuAffinity",
                                      "isActive",    "isConfigured",  "isRunning",      "inFatalError",
                                      "inException", "inRunTimeError"};
    return std::find(std::begin(all), std::end(all), operation) != std::end(all);
}

const std::string* textOf(const RTT::scripting::ForeseenCall& call, std::size_t argument) {
    return argument < call.texts.size() ? call.texts[argument] : nullptr;
}

RTT::scripting::CallProblem problem(std::string text, const char* code, std::size_t argument) {
    RTT::scripting::CallProblem result;
    result.text = std::move(text);
    result.code = code;
    result.argument = argument;
    return result;
}

/** What the loader will say of a type that it does not have; empty if it has it. */
std::string unknownType(const std::string& type) {
    const std::vector<std::string> known = ComponentLoader::Instance()->listComponentTypes();
    if (std::find(known.begin(), known.end(), type) != known.end()) return {};
    const std::string likely = oroforge::diag::didYouMeanType(type, known);
    return "unknown component type '" + type + "'" +
           (likely.empty() ? "; import the package that has it first" : likely);
}

}  // namespace

RTT::scripting::CallProblem ScriptForecast::foresee(const Call& call, Expectations& expected) {
    std::vector<std::string> path = call.path;
    while (path.size() > 1 && session_.isDeployer(path.front())) path.erase(path.begin());
    if (path.size() > 1 && path.front() == "task") path.erase(path.begin());
    if (path.size() == 1) return callOfDeployer(path.front(), call, expected);
    if (isHarmless(path) || expected.components.count(path.front())) return {};
    RTT::TaskContext* const component = session_.deployer->getPeer(path.front());
    if (component && path.size() == 2 && isQuery(path.back())) return {};
    if (component)
        touch(*component, expected);
    else
        expected.anything();
    return {};
}

RTT::scripting::CallProblem ScriptForecast::callOfDeployer(const std::string& operation, const Call& call,
                                                           Expectations& expected) {
    const auto effect = effects().find(operation);
    if (effect == effects().end()) {
        expected.anything();
        return {};
    }
    switch (effect->second) {
        case Effect::Import: return import(call, false, expected);
        case Effect::Library: return import(call, true, expected);
        case Effect::Path: return path(call, expected);
        case Effect::Component: return component(call, expected);
        case Effect::Require: return require(call, expected);
        default: break;
    }
    Problem found = names(operation, call, expected);
    switch (effect->second) {
        case Effect::Peers: return found.text.empty() ? peers(operation, call, expected) : found;
        case Effect::Service: return found.text.empty() ? service(call, expected) : found;
        case Effect::Change: (void)change(call, expected); break;
        case Effect::ChangeAll: touchAll(expected); break;
        default: break;
    }
    return found;
}

/** Only what fails for certain, whatever the script did before, and is not looked at by the script itself. */
bool ScriptForecast::tells(const Call& call, const Expectations& expected) const {
    return call.certain && call.ignored && !expected.names;
}

RTT::scripting::CallProblem ScriptForecast::import(const Call& call, bool isLibrary, Expectations& expected) {
    const std::string* const what = textOf(call, 0);
    const bool wasOpen = expected.names;
    if (!what || !call.certain || (wasOpen && foresight_ == Foresight::Run)) {
        expected.anything();
        return {};
    }
    std::string error;
    const bool done =
        isLibrary ? loadLibrary(*what, error) : ComponentLoader::Instance()->import(*what, std::string(), error);
    if (done) return {};
    const bool tell = tells(call, expected);
    expected.anything();
    if (!tell) return {};
    return problem("could not " + std::string(isLibrary ? "load" : "import") + " '" + *what + "': " + error, "DEP030",
                   0);
}

RTT::scripting::CallProblem ScriptForecast::path(const Call& call, Expectations& expected) {
    const std::string* const directories = textOf(call, 0);
    if (!directories || !call.certain) {
        expected.anything();
        return {};
    }
    addSearchPath(*directories);
    try {
        ComponentLoader::Instance()->import(*directories);
    } catch (const std::exception&) {
        expected.anything();  // it will be told by the script
    }
    return {};
}

RTT::scripting::CallProblem ScriptForecast::component(const Call& call, Expectations& expected) {
    const std::string* const name = textOf(call, 0);
    const std::string* const type = textOf(call, 1);
    if (!name) {
        expected.anything();
        return {};
    }
    const bool isThere = session_.component(*name) || expected.components.count(*name);
    if (!isThere) expected.components.insert(*name);
    if (!type || !call.certain || expected.names) return {};
    std::string error;
    const std::string wanted = componentTypeOf(*type, error);
    if (error.empty()) error = unknownType(wanted);
    if (!error.empty())
        return tells(call, expected) ? problem("could not load component '" + *name + "': " + error, "DEP031", 1)
                                     : Problem();
    if (foresight_ == Foresight::Run) return {};
    if (isThere)
        return tells(call, expected)
                   ? problem("could not load component '" + *name + "': a component of that name is already there",
                             "DEP032", 0)
                   : Problem();
    if (create(session_, *name, wanted, 0, error)) {
        expected.components.erase(*name);
        return {};
    }
    // Where the script will run, it may be otherwise: a device is there.
    Problem result = problem("could not load component '" + *name + "': " + error, "DEP032", 0);
    result.isWarning = true;
    return result;
}

RTT::scripting::CallProblem ScriptForecast::peers(const std::string& operation, const Call& call,
                                                  Expectations& expected) {
    const std::string* const one = textOf(call, 0);
    const std::string* const two = textOf(call, 1);
    const std::string* const alias = operation == "aliasPeer" ? textOf(call, 2) : two;
    if (!one || !two || !alias) {
        touchAll(expected);
        return {};
    }
    RTT::TaskContext* const first = session_.component(*one);
    RTT::TaskContext* const second = session_.component(*two);
    const bool mutual = operation == "connectPeers";
    if (foresight_ == Foresight::Check && call.certain && first && second) {
        const std::string known = operation == "aliasPeer" ? *alias : second->getName();
        if (!first->hasPeer(known)) first->addPeer(second, known);
        if (mutual && !second->hasPeer(first->getName())) second->addPeer(first, first->getName());
        return {};
    }
    if (first == session_.deployer) expected.components.insert(*alias);
    // One that is not there yet may do with the deployer what it likes.
    if (second == session_.deployer || (mutual && first == session_.deployer)) expected.anything();
    if (first) expected.more.insert(first);
    if (second && mutual) expected.more.insert(second);
    return {};
}

RTT::scripting::CallProblem ScriptForecast::service(const Call& call, Expectations& expected) {
    const std::string* const name = textOf(call, 0);
    const std::string* const wanted = textOf(call, 1);
    RTT::TaskContext* const component = name ? session_.component(*name) : nullptr;
    if (component)
        expected.more.insert(component);
    else if (!name)
        touchAll(expected);
    if (!wanted || foresight_ == Foresight::Run || !tells(call, expected)) return {};
    const std::vector<std::string> plugins = PluginLoader::Instance()->listPlugins();
    const std::vector<std::string> known = PluginLoader::Instance()->listServices();
    const auto has = [&](const std::vector<std::string>& names) {
        return std::find(names.begin(), names.end(), *wanted) != names.end();
    };
    if (!component || has(known) || has(plugins) || component->provides()->hasService(*wanted)) return {};
    return problem("could not load service '" + *wanted + "' into component '" + *name +
                       "': there is no service or plugin of that name" + oroforge::diag::didYouMean(*wanted, known),
                   "DEP033", 1);
}

/** Global services: they are loaded, so that what they bring is known. */
RTT::scripting::CallProblem ScriptForecast::require(const Call& call, Expectations& expected) {
    const std::string* const name = textOf(call, 0);
    const auto global = RTT::internal::GlobalService::Instance();
    if (name && (global->hasService(*name) || (call.certain && PluginLoader::Instance()->loadService(*name, nullptr))))
        return {};
    expected.anything();
    return {};
}

RTT::scripting::CallProblem ScriptForecast::change(const Call& call, Expectations& expected) {
    const std::string* const name = textOf(call, 0);
    if (!name)
        touchAll(expected);
    else if (RTT::TaskContext* const component = session_.component(*name))
        touch(*component, expected);
    return {};
}

RTT::scripting::CallProblem ScriptForecast::names(const std::string& operation, const Call& call,
                                                  const Expectations& expected) const {
    if (foresight_ == Foresight::Run || !tells(call, expected)) return {};
    const auto arguments = namedArguments().equal_range(operation);
    for (auto named = arguments.first; named != arguments.second; ++named) {
        const std::string* const given = textOf(call, named->second.argument);
        if (!given) continue;
        Problem found = name(*given, named->second.isPort, expected);
        found.argument = named->second.argument;
        if (!found.text.empty()) return found;
    }
    return {};
}

RTT::scripting::CallProblem ScriptForecast::name(const std::string& given, bool isPort,
                                                 const Expectations& expected) const {
    const std::string component = isPort ? given.substr(0, given.find('.')) : given;
    RTT::TaskContext* const known = session_.component(component);
    if (!known && expected.components.count(component)) return {};
    if (!known)
        return problem(
            "no component '" + component + "'" + oroforge::diag::didYouMean(component, session_.componentNames()),
            "OPS420", 0);
    std::string error;
    if (!isPort || expected.more.count(known) || findPort(session_, given, error)) return {};
    return problem(error, "OPS420", 0);
}

void ScriptForecast::touch(RTT::TaskContext& component, Expectations& expected) const {
    if (&component == session_.deployer) return expected.anything();
    expected.types = true;
    if (!expected.more.insert(&component).second) return;
    for (const std::string& name : component.getPeerList())
        if (RTT::TaskContext* const peer = component.getPeer(name)) touch(*peer, expected);
}

void ScriptForecast::touchAll(Expectations& expected) const {
    for (const std::string& name : session_.deployer->getPeerList())
        if (RTT::TaskContext* const peer = session_.deployer->getPeer(name)) touch(*peer, expected);
}

}  // namespace OCL::deploy
