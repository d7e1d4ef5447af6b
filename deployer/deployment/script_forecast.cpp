// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "script_forecast.hpp"

#include "chains.hpp"
#include "libraries.hpp"
#include "lookup.hpp"
#include "scripts.hpp"
#include "xml_to_plan.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <utility>

namespace OCL::deploy {

using RTT::ComponentLoader;
using RTT::plugin::PluginLoader;

namespace {

RTT::scripting::CallProblem problem(std::string text, const char* code, std::size_t argument) {
    RTT::scripting::CallProblem result;
    result.text = std::move(text);
    result.code = code;
    result.argument = argument;
    return result;
}

/** A warning of what may be right when the script runs; given only if the text suggests another name. */
RTT::scripting::CallProblem doubtful(std::string text, const char* code, std::size_t argument,
                                     const RTT::scripting::ForeseenCall& call) {
    if (!call.ignored || text.find("; did you mean '") == std::string::npos) return {};
    RTT::scripting::CallProblem result = problem(std::move(text), code, argument);
    result.isWarning = true;
    return result;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/** True for services of the toolchain, which add nothing but themselves. */
bool isOfToolchain(const std::string& service) { return service == "scripting" || service == "marshalling"; }

bool isThere(const std::filesystem::path& file) {
    std::error_code unknown;
    return std::filesystem::exists(file, unknown) || unknown;
}

/** The path of a script that another one runs; empty if there is none. */
std::string fileOf(const std::string& script, const std::string& caller) {
    if (isThere(script)) return script;
    const std::filesystem::path beside = std::filesystem::path(caller).parent_path() / script;
    return isThere(beside) ? beside.string() : std::string();
}

}  // namespace

RTT::scripting::CallProblem ScriptForecast::foresee(const Call& call, Expectations& expected) {
    std::vector<std::string> path = call.path;
    while (path.size() > 1 && session_.isDeployer(path.front())) path.erase(path.begin());
    if (path.size() > 1 && path.front() == "task") path.erase(path.begin());
    const bool isService = path.size() == 2 && path.front() == "scripting" && path.back() == "runScript";
    if (isService) path.erase(path.begin());
    if (path.size() == 1) return callOfDeployer(path.front(), call, expected);
    const Problem wrong = callOfService(path, call, expected);
    expected.begun = true;
    return wrong;
}

/** Operations of a component that load services and run scripts, as those of the deployer do. */
RTT::scripting::CallProblem ScriptForecast::callOfService(const std::vector<std::string>& path, const Call& call,
                                                          Expectations& expected) {
    const bool isCheck = !isRun() && known(path.front(), expected);
    if (isCheck && path.size() == 2 && path.back() == "loadService" && call.texts.size() == 1) {
        Call same = call;
        same.texts.insert(same.texts.begin(), &path.front());
        Problem found = service(same, expected);
        found.argument = 0;
        return found;
    }
    if (isCheck && path.size() == 3 && path[1] == "scripting" && path.back() == "runScript") {
        const Problem missing = missingScript(call, expected);
        if (!missing.text.empty()) return missing;
    }
    callOfOthers(path, expected);
    return {};
}

void ScriptForecast::callOfOthers(const std::vector<std::string>& path, Expectations& expected) const {
    const std::string& first = path.front();
    if (failed_.count(first)) return;
    if (expected.components.count(first)) return foreignCode(expected);
    if (RTT::TaskContext* const component = session_.component(first)) {
        if (!isQuery(*component, {path.begin() + 1, path.end()})) touch(*component, expected);
    } else if (isQuery(*session_.deployer, path) || isHarmless(path)) {
        return;
    } else if (first != "scripting" && session_.deployer->provides()->hasService(first)) {
        expected.anything();  // such as a program or a state machine
    } else {
        anyOperation(expected);
    }
}

RTT::scripting::CallProblem ScriptForecast::callOfDeployer(const std::string& operation, const Call& call,
                                                           Expectations& expected) {
    const CallEffect& called = effectOf(operation);
    switch (called.effect) {
        case Effect::Import: return import(call, false, expected);
        case Effect::Library: return import(call, true, expected);
        case Effect::Path: path(call, expected); return {};
        case Effect::Require: return require(call, expected);
        default: break;
    }
    if (!isRun()) recordFor(operation, call, expected);
    Problem wrong = wrongName(called.names, call, expected);
    if (wrong.text.empty() && operation == "setMasterSlaveActivity") wrong = ownMaster(call, expected);
    const bool fails = !wrong.text.empty();
    expected.begun = true;
    switch (called.effect) {
        case Effect::Component: return operation == "chain" ? chain(call, expected) : component(call, expected);
        case Effect::Description: return description(call, expected);
        case Effect::Script: return script(call, expected);
        case Effect::Service: return fails ? wrong : service(call, expected);
        case Effect::Unload: return fails ? wrong : unload(call, expected);
        case Effect::Peers:
            if (!fails) peers(operation, call, expected);
            break;
        case Effect::Wiring:
            if (!fails) wiring(called.names, call, expected);
            break;
        case Effect::Change:
            if (!fails) change(call, expected);
            break;
        case Effect::ChangeAll: touchAll(expected); break;
        case Effect::UnloadAll:
        case Effect::Anything: anyOperation(expected); break;
        default: break;
    }
    return wrong;
}

/** True if a failure must be reported: the call is certain to fail, and the script ignores its result. */
bool ScriptForecast::tells(const Call& call, const Expectations& expected) const {
    return call.certain && call.ignored && !expected.names;
}

RTT::scripting::CallProblem ScriptForecast::import(const Call& call, bool isLibrary, Expectations& expected) {
    const std::string* const what = textOf(call, 0);
    // A script that runs imports it itself, because earlier statements may prepare the import, or take long.
    if (!what || !call.certain || (isRun() && expected.begun)) {
        foreignCode(expected);
        return {};
    }
    std::string error;
    const bool done =
        isLibrary ? loadLibrary(*what, error) : ComponentLoader::Instance()->import(*what, std::string(), error);
    if (done) return {};
    const bool isSure = isRun() ? call.ignored : tells(call, expected);
    // What the library would add is unknown, but the operations of the deployer are known.
    expected.anyGlobals();
    const std::string text = "could not " + std::string(isLibrary ? "load" : "import") + " '" + *what + "': " + error;
    return isSure ? problem(text, "DEP030", 0) : isRun() ? Problem() : doubtful(text, "DEP030", 0, call);
}

void ScriptForecast::path(const Call& call, Expectations& expected) {
    const std::string* const directories = textOf(call, 0);
    if (!directories || !call.certain || (isRun() && expected.begun)) return foreignCode(expected);
    addSearchPath(*directories);
    try {
        ComponentLoader::Instance()->import(*directories);
    } catch (const std::exception&) {
        expected.anyGlobals();  // the script will report it
    }
}

/** A chain of a known name is changed; otherwise it is made. */
RTT::scripting::CallProblem ScriptForecast::chain(const Call& call, Expectations& expected) {
    const std::string* const name = textOf(call, 0);
    if (name && known(*name, expected)) return {};
    static const std::string type = kChainType;
    Call load = call;
    load.texts = {name, &type};
    return component(load, expected);
}

RTT::scripting::CallProblem ScriptForecast::component(const Call& call, Expectations& expected) {
    const std::string* const name = textOf(call, 0);
    const std::string* const type = textOf(call, 1);
    if (!name) {
        foreignCode(expected);
        expected.anything();  // a component of any name
        return {};
    }
    if (!session_.component(*name)) expected.components.insert(*name);
    std::string error;
    // A script that runs loads the library itself.
    const bool waits = isRun() && type && type->find(".so") != std::string::npos;
    if (type && call.certain && !waits) {
        const std::string wanted = componentTypeOf(*type, error);
        if (error.empty()) error = unknownType(wanted);
    }
    const bool isSure = tells(call, expected) && !expected.globals;
    if (!error.empty() && isSure && *type != "PropertyBag" && *type != "RTT::PropertyBag") {
        failed_.insert(*name);
        return problem("could not load component '" + *name + "': " + error, "DEP031", 1);
    }
    if (isRun()) {
        foreignCode(expected);
        return {};
    }
    if (!error.empty()) return doubtful("could not load component '" + *name + "': " + error, "DEP031", 1, call);
    if (!type || !call.certain) return {};
    if (known(*name, expected))
        return tells(call, expected)
                   ? problem("could not load component '" + *name + "': a component of that name is already there",
                             "DEP032", 0)
                   : Problem();
    return session_.component(*name) ? Problem() : made(*name, *type, expected);
}

RTT::scripting::CallProblem ScriptForecast::made(const std::string& name, const std::string& type,
                                                 Expectations& expected) {
    std::string error;
    failed_.erase(name);
    if (create(session_, name, type, 0, error)) {
        expected.components.erase(name);
        return {};
    }
    // It may succeed where the script will run, for example with a device.
    Problem result = problem("could not load component '" + name + "': " + error, "DEP032", 0);
    result.isWarning = true;
    return result;
}

RTT::scripting::CallProblem ScriptForecast::service(const Call& call, Expectations& expected) const {
    const std::string* const name = textOf(call, 0);
    const std::string* const wanted = textOf(call, 1);
    if (!name) {
        touchAll(expected);
        return {};
    }
    RTT::TaskContext* const component = known(*name, expected);
    if (!wanted || !component) {
        if (component) touch(*component, expected);
        if (!component) foreignCode(expected);
        return {};
    }
    if (component->provides()->hasService(*wanted)) return {};
    if (isOfToolchain(*wanted)) {
        if (isRun() || !call.certain || !loadService(*component, *wanted)) expected.more.insert(component);
        return {};
    }
    Problem found;
    if (!isRun() && tells(call, expected) && !expected.globals)
        found = noService(*wanted, " into component '" + *name + "'");
    if (found.text.empty()) touch(*component, expected);
    return found;
}

RTT::scripting::CallProblem ScriptForecast::noService(const std::string& wanted, const std::string& into) const {
    const std::vector<std::string> known = PluginLoader::Instance()->listServices();
    if (contains(known, wanted) || contains(PluginLoader::Instance()->listPlugins(), wanted)) return {};
    return problem("could not load service '" + wanted + "'" + into + ": there is no service or plugin of that name" +
                       oroforge::diag::didYouMean(wanted, known),
                   "DEP033", into.empty() ? 0 : 1);
}

/** Loads a global service, so that its operations are known. */
RTT::scripting::CallProblem ScriptForecast::require(const Call& call, Expectations& expected) const {
    const std::string* const name = textOf(call, 0);
    if (name && RTT::internal::GlobalService::Instance()->hasService(*name)) return {};
    if (!name || !call.certain || (isRun() && expected.begun)) {
        foreignCode(expected);
        return {};
    }
    const Problem unknown = noService(*name, "");
    if (unknown.text.empty() && PluginLoader::Instance()->loadService(*name, nullptr)) return {};
    const bool tell = !isRun() && tells(call, expected) && !expected.globals;
    expected.anyGlobals();
    return tell ? unknown : Problem();
}

void ScriptForecast::change(const Call& call, Expectations& expected) const {
    const std::string* const name = textOf(call, 0);
    RTT::TaskContext* const component = name ? known(*name, expected) : nullptr;
    if (component)
        touch(*component, expected);
    else if (!name)
        touchAll(expected);
    else if (!failed_.count(*name))
        foreignCode(expected);
}

/** A component that is unloaded may be loaded again with another type. */
RTT::scripting::CallProblem ScriptForecast::unload(const Call& call, Expectations& expected) {
    const std::string* const name = textOf(call, 0);
    if (!name) {
        anyOperation(expected);
        return {};
    }
    change(call, expected);
    expected.components.insert(*name);
    failed_.erase(*name);
    return {};
}

RTT::scripting::CallProblem ScriptForecast::description(const Call& call, Expectations& expected) const {
    const std::string* const file = textOf(call, 0);
    const bool tell = !isRun() && file && tells(call, expected) && !isThere(*file);
    if (!tell) expected.anything();
    return tell ? problem("cannot read the file '" + *file + "': No such file or directory", "DEP020", 0) : Problem();
}

RTT::scripting::CallProblem ScriptForecast::script(const Call& call, Expectations& expected) const {
    const std::string* const file = textOf(call, 0);
    const bool isKnown = file && !isRun() && serviceFor(ScriptPlan::Run, *file) == "scripting";
    Problem found;
    if (isKnown) found.script = fileOf(*file, call.script);
    if (isKnown && !found.script.empty()) return found;
    found = missingScript(call, expected);
    if (found.text.empty()) anyOperation(expected);
    return found;
}

RTT::scripting::CallProblem ScriptForecast::missingScript(const Call& call, const Expectations& expected) const {
    const std::string* const file = textOf(call, 0);
    if (isRun() || !file || !tells(call, expected) || !fileOf(*file, call.script).empty()) return {};
    return problem("cannot read the script '" + *file + "': No such file or directory", "OPS411", 0);
}

RTT::scripting::CallProblem ScriptForecast::wrongName(const std::vector<NamedArgument>& names, const Call& call,
                                                      const Expectations& expected) const {
    if (isRun() || !tells(call, expected)) return {};
    for (const NamedArgument& named : names) {
        const std::string* const given = textOf(call, named.argument);
        if (!given) continue;
        Problem found = wrongName(*given, named.kind, expected);
        found.argument = named.argument;
        if (!found.text.empty()) return found;
    }
    return {};
}

RTT::scripting::CallProblem ScriptForecast::wrongName(const std::string& given, NamedArgument::Kind kind,
                                                      const Expectations& expected) const {
    const bool isPath = kind != NamedArgument::Component;
    const std::string name = isPath ? given.substr(0, given.find('.')) : given;
    if (expected.components.count(name)) return {};
    RTT::TaskContext* const component = session_.component(name);
    if (!component)
        return problem("no component '" + name + "'" + oroforge::diag::didYouMean(name, session_.componentNames()),
                       "OPS420", 0);
    std::string error;
    if (kind != NamedArgument::Port || expected.more.count(component) || findPort(session_, given, error)) return {};
    return problem(error, "OPS420", 0);
}

RTT::scripting::CallProblem ScriptForecast::ownMaster(const Call& call, const Expectations& expected) const {
    const std::string* const master = textOf(call, 0);
    const std::string* const slave = textOf(call, 1);
    if (isRun() || !tells(call, expected) || !master || !slave || *master != *slave) return {};
    return problem("component '" + *slave + "' would be its own master", "OPS420", 1);
}

}  // namespace OCL::deploy
