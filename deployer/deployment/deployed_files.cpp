// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "deployed_files.hpp"

#include "failure.hpp"
#include "report.hpp"
#include "scripts.hpp"
#include "xml_to_plan.hpp"

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/SignalCatcher.hpp>

#include <utility>

namespace OCL::deploy {

using RTT::endlog;
using RTT::log;

namespace {

/** Reports and returns false if a signal has come that ends the program. */
bool goesOn(const std::string& file) {
    const int signal = RTT::os::pendingSignal();
    if (signal != 0)
        log(RTT::Error) << "signal " << signal << " came while '" << file << "' was being deployed" << endlog();
    return signal == 0;
}

}  // namespace

bool DeployedFiles::load(const Plan& plan, diag::Sink& sink) {
    const RTT::Logger::In in(session_.deployer->getName());
    const State before = state();
    const int group = session_.nextGroup++;
    valid = deploy::load(session_, plan, group, sink);
    report(sink);
    if (!valid) {
        undo(group, before);
        return false;
    }
    for (const RTT::plugin::DeployedText& one : plan.texts) RTT::plugin::noteDeployedText(one.file, one.text);
    return true;
}

bool DeployedFiles::plan(const std::string& file) {
    diag::Sink sink;
    Plan plan = readPlanFile(file, sink);
    const RTT::Logger::In in(session_.deployer->getName());
    const bool good = prepare(session_, plan, /*planOnly=*/true, sink);
    report(sink);
    session_.planned.push_back(std::move(plan));
    return good;
}

bool DeployedFiles::configure(int group) {
    const RTT::Logger::In in(session_.deployer->getName());
    diag::Sink sink;
    valid = deploy::configure(session_, group, sink);
    // The components have the values now. Until then a file serves all groups.
    if (group + 1 == session_.nextGroup) session_.propertyFiles->clear();
    report(sink);
    return valid;
}

bool DeployedFiles::start(int group) {
    const RTT::Logger::In in(session_.deployer->getName());
    diag::Sink sink;
    const bool started = deploy::start(session_, group, sink);
    report(sink);
    return started;
}

void DeployedFiles::undo(int group, const State& before) {
    (void)takeDown(session_, group);
    session_.propertyFiles->clear();
    session_.records.policies = before.policies;
    if (const auto former = session_.formerDefaults.find(group); former != session_.formerDefaults.end()) {
        RTT::ConnPolicy::Default() = former->second;
        session_.formerDefaults.erase(former);
    }
    // Components that scripts created or that could not be removed must stay known.
    for (const ComponentRecord& old : before.records)
        if (ComponentRecord* const left = session_.records.find(old.instance)) {
            unloadScripts(*left->instance, left->loaded, old.loaded);
            *left = old;
        }
}

bool DeployedFiles::load(const std::string& file) {
    return reported("could not load what '" + file + "' describes", [&] {
        diag::Sink sink;
        return load(readPlanFile(file, sink), sink);
    });
}

bool DeployedFiles::loadText(const std::string& text) {
    return reported("could not load what the text describes", [&] {
        diag::Sink sink;
        return load(readPlanText(text, "configuration string", sink), sink);
    });
}

void DeployedFiles::forget() {
    session_.records.policies.clear();
    for (ComponentRecord& record : session_.records.all) record.plan = ComponentPlan();
}

bool DeployedFiles::configureAll() {
    if (session_.records.all.empty()) return failed("there are no components to configure: none was loaded");
    return reported("could not configure all components", [&] {
        bool all = true;
        for (int group = 0; group < session_.nextGroup; ++group) all &= configure(group);
        return all;
    });
}

bool DeployedFiles::startAll() {
    if (!valid) return failed("not starting components: the last configuration was not valid");
    return reported("could not start all components", [&] {
        bool all = true;
        if (session_.startsNothing) return all;
        for (int group = 0; group < session_.nextGroup; ++group) all &= start(group);
        return all;
    });
}

bool DeployedFiles::forAllDown(const char* toDo, bool (*step)(Session&, int)) {
    return reported(std::string("could not ") + toDo + " all components", [&] {
        const RTT::Logger::In in(session_.deployer->getName());
        bool all = true;
        for (int group = session_.nextGroup; group >= 0; --group) all &= step(session_, group);
        return all;
    });
}

bool DeployedFiles::kickStart(const std::string& file, bool starts) {
    const State before = state();
    if (!load(file)) return false;
    const int group = session_.nextGroup - 1;
    starts = starts && !session_.startsNothing;
    if (goesOn(file) && configure(group) && (!starts || (goesOn(file) && start(group)))) {
        log(RTT::Info) << "loaded, configured " << (starts ? "and started " : "") << "the components of " << file
                       << endlog();
        return true;
    }
    log(RTT::Error) << "undoing what " << file << " created" << endlog();
    undo(group, before);
    return false;
}

bool DeployedFiles::kickOutAll() {
    const bool all = forAllDown("kick out", &takeDown);
    if (all) session_.nextGroup = 1;
    return all;
}

void DeployedFiles::kickOut(const std::string& file, NamedComponents& components) {
    diag::Sink sink;
    const Plan plan = readPlanFile(file, sink);
    report(sink);
    for (auto component = plan.components.rbegin(); component != plan.components.rend(); ++component)
        if (session_.records.find(component->name.value)) (void)components.kickOut(component->name.value);
}

}  // namespace OCL::deploy
