// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Construction, libraries, files and groups. Single components and wiring: deployment_operations.cpp.
#include <ocl/DeploymentComponent.hpp>

#include "deployment_state.hpp"
#include "failure.hpp"
#include "graph.hpp"
#include "read_value.hpp"
#include "report.hpp"
#include "scripts.hpp"
#include "summary.hpp"
#include "xml_to_plan.hpp"

#include <rtt/Logger.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/os/SignalCatcher.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/threads.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

namespace OCL {

using deploy::failed;
using deploy::Plan;
using deploy::reported;
using oroforge::diag::Sink;
using RTT::endlog;
using RTT::log;

DeploymentComponent::DeploymentComponent(std::string name, std::string siteFile, Purpose purpose)
    : TaskContext(name, Stopped), impl_(new Impl) {
    impl_->session.deployer = this;
    impl_->session.loaded = [this](RTT::TaskContext* component) { return componentLoaded(component); };
    impl_->session.unloaded = [this](RTT::TaskContext* component) { componentUnloaded(component); };
    impl_->purpose = purpose;
    addDeploymentInterface();
    RTT::internal::FailureReport::add(*provides());
    if (purpose == Purpose::Check) {
        impl_->session.startsNothing = true;
        deploy::holdBack(*this);
    }

    const std::string site = siteFile.empty() ? name + "-site.cpf" : siteFile;
    std::error_code unreadable;  // reported when it is read
    if (std::filesystem::exists(site, unreadable) || unreadable) {
        log(RTT::Info) << "using site file '" << site << "'" << endlog();
        impl_->siteFileFailed = !(purpose == Purpose::PlanOnly ? planOnly(site) : kickStart(site));
        return;
    }
    (void)configure();
    log(siteFile.empty() ? RTT::Info : RTT::Warning)
        << "there is no site file '" << site << "': importing 'ocl'" << endlog();
    std::string error;
    if (!RTT::ComponentLoader::Instance()->importInstalled("ocl", error))
        log(RTT::Info) << "no component library: " << error << endlog();
}

DeploymentComponent::~DeploymentComponent() {
    if (impl_->autoUnload) (void)kickOutAll();
    RTT::internal::FailureReport::remove(*provides());
    // Hooks of a derived class must not run while this part is taken apart.
    stopForGood();
    clear();
}

bool DeploymentComponent::componentLoaded(RTT::TaskContext*) { return true; }
void DeploymentComponent::componentUnloaded(RTT::TaskContext*) {}

bool DeploymentComponent::configureHook() {
    const RTT::ComponentLoader::shared_ptr components = RTT::ComponentLoader::Instance();
    if (impl_->componentPath.empty()) {
        impl_->componentPath = components->getComponentPath();
        return true;
    }
    if (impl_->componentPath == components->getComponentPath()) return true;
    log(RTT::Info) << "searching RTT_COMPONENT_PATH " << impl_->componentPath << endlog();
    components->setComponentPath(impl_->componentPath);
    RTT::plugin::PluginLoader::Instance()->setPluginPath(impl_->componentPath);
    (void)components->import(impl_->componentPath);  // packages below it are imported later, by name
    return true;
}

// --- libraries -----------------------------------------------------------------------------------------------------

bool DeploymentComponent::import(const std::string& package) {
    std::string error;
    bool done = false;
    {
        const RTT::internal::FailureReport::Pause others;
        done = RTT::ComponentLoader::Instance()->import(package, std::string(), error);
    }
    return done || failed("could not import '" + package + "': " + error);
}

void DeploymentComponent::path(const std::string& paths) {
    for (const std::string& directory : deploy::missingDirectories(paths))
        log(RTT::Warning) << "there is no directory '" << directory << "' to search" << endlog();
    deploy::addSearchPath(paths);
    RTT::ComponentLoader::Instance()->import(paths);
}

bool DeploymentComponent::loadLibrary(const std::string& name) {
    std::string error;
    return deploy::loadLibrary(name, error) || failed("could not load library '" + name + "': " + error);
}

bool DeploymentComponent::reloadLibrary(const std::string& filepath) {
    const auto reload = [&] { return RTT::ComponentLoader::Instance()->reloadLibrary(filepath); };
    return deploy::doneOr(std::string(), reload);
}

void DeploymentComponent::displayComponentTypes() const {
    std::cout << "I can create the following component types: " << std::endl;
    const std::vector<std::string> types = getComponentTypes();
    for (const std::string& type : types) std::cout << "   " << type << std::endl;
    if (types.empty()) std::cout << "   (none)" << std::endl;
}

std::vector<std::string> DeploymentComponent::getComponentTypes() const {
    return RTT::ComponentLoader::Instance()->listComponentTypes();
}

// --- files ---------------------------------------------------------------------------------------------------------

bool DeploymentComponent::loadComponents(const std::string& file) {
    return reported("could not load what '" + file + "' describes", [&] {
        Sink sink;
        return impl_->load(deploy::readPlanFile(file, sink), sink);
    });
}

bool DeploymentComponent::planOnly(const std::string& file) {
    Sink sink;
    return impl_->plan(deploy::readPlanFile(file, sink), sink);
}

std::string DeploymentComponent::planSummary() const {
    return impl_->session.planned.empty() ? "" : deploy::summaryOf(impl_->session);
}

bool DeploymentComponent::checkScript(const std::string& file) { return impl_->checkScript(file); }

bool DeploymentComponent::siteFileFailed() const { return impl_->siteFileFailed; }

std::string DeploymentComponent::graph() const { return deploy::graphOf(impl_->session); }

bool DeploymentComponent::loadConfigurationString(const std::string& text) {
    return reported("could not load what the text describes", [&] {
        Sink sink;
        return impl_->load(deploy::readPlanText(text, "configuration string", sink), sink);
    });
}

void DeploymentComponent::clearConfiguration() {
    impl_->session.records.policies.clear();
    for (deploy::ComponentRecord& record : impl_->session.records.all) record.plan = deploy::ComponentPlan();
}

bool DeploymentComponent::configureComponents() {
    if (impl_->session.records.all.empty()) return failed("there are no components to configure: none was loaded");
    return reported("could not configure all components", [&] {
        bool all = true;
        for (int group = 0; group < impl_->session.nextGroup; ++group) all &= impl_->configure(group);
        return all;
    });
}

bool DeploymentComponent::startComponents() {
    if (!impl_->valid) return failed("not starting components: the last configuration was not valid");
    return reported("could not start all components", [&] {
        bool all = true;
        if (impl_->session.startsNothing) return all;
        for (int group = 0; group < impl_->session.nextGroup; ++group) all &= impl_->start(group);
        return all;
    });
}

bool DeploymentComponent::stopComponents() {
    return reported("could not stop all components", [&] { return impl_->forGroupsDown(&deploy::stop); });
}

bool DeploymentComponent::cleanupComponents() {
    return reported("could not clean up all components", [&] { return impl_->forGroupsDown(&deploy::cleanup); });
}

bool DeploymentComponent::unloadComponents() {
    return reported("could not unload all components", [&] { return impl_->forGroupsDown(&deploy::unload); });
}

bool DeploymentComponent::kickStart(const std::string& file) {
    return reported("could not deploy '" + file + "'", [&] { return kickStart2(file, true); });
}

bool DeploymentComponent::kickStart2(const std::string& file, bool start) {
    const Impl::State before = impl_->state();
    if (!loadComponents(file)) return false;
    const int group = impl_->session.nextGroup - 1;
    start = start && !impl_->session.startsNothing;
    if (impl_->goesOn(file) && impl_->configure(group) && (!start || (impl_->goesOn(file) && impl_->start(group)))) {
        log(RTT::Info) << "loaded, configured " << (start ? "and started " : "") << "the components of " << file
                       << endlog();
        return true;
    }
    log(RTT::Error) << "undoing what " << file << " created" << endlog();
    impl_->undo(group, before);
    return false;
}

bool DeploymentComponent::kickOutAll() {
    return reported("could not kick out all components", [&] {
        const bool all = impl_->forGroupsDown(&deploy::takeDown);
        if (all) impl_->session.nextGroup = 1;
        return all;
    });
}

bool DeploymentComponent::kickOutComponent(const std::string& name) {
    const deploy::ComponentRecord* record = impl_->session.records.find(name);
    if (!record || !record->loadedHere)
        return failed("could not kick out component '" + name + "': it was not loaded by " + getName());
    const RTT::internal::FailureReport::Pause others;
    RTT::TaskContext& component = *record->instance;
    (void)deploy::stopOne(component);
    (void)deploy::cleanupOne(impl_->session, component);
    (void)deploy::unloadOne(impl_->session, component);
    return true;
}

void DeploymentComponent::kickOut(const std::string& file) {
    Sink sink;
    const Plan plan = deploy::readPlanFile(file, sink);
    deploy::report(sink);
    for (auto component = plan.components.rbegin(); component != plan.components.rend(); ++component)
        if (impl_->session.records.find(component->name.value)) (void)kickOutComponent(component->name.value);
}

bool DeploymentComponent::runScript(const std::string& file) {
    std::string error;
    const std::string what = "could not run script '" + file + "'";
    const auto run = [&] { return deploy::runScript(*this, deploy::ScriptPlan::Run, file, error); };
    if (reported(what, run)) return true;
    if (!error.empty()) log(RTT::Error) << what << ": " << error << endlog();
    return false;
}

// --- waiting -------------------------------------------------------------------------------------------------------

void DeploymentComponent::waitForInterrupt() {
    RTT::os::SignalCatcher catcher({SIGINT, SIGTERM, SIGHUP});
    std::cout << "DeploymentComponent: waiting for an interrupt" << std::endl;
    (void)catcher.wait();
    std::cout << "DeploymentComponent: got the interrupt" << std::endl;
}

bool DeploymentComponent::waitForSignal(int signal) {
    RTT::os::SignalCatcher catcher({signal});
    if (!catcher.ready()) {
        log(RTT::Error) << "signal " << signal << " cannot be caught" << endlog();
        return false;
    }
    return catcher.wait() == signal;  // otherwise the program must end
}

}  // namespace OCL
