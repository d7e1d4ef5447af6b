// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Construction, and what its parts do. What scripts see of it: deployment_interface.cpp.
#include <ocl/DeploymentComponent.hpp>

#include "component_name.hpp"
#include "chains.hpp"
#include "deployment_parts.hpp"
#include "failure.hpp"
#include "graph.hpp"
#include "libraries.hpp"
#include "replaced.hpp"
#include "scripts.hpp"
#include "shutdown.hpp"
#include "summary.hpp"

#include <rtt/Logger.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/os/SignalCatcher.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

namespace OCL {

using deploy::ActivityKind;
using RTT::endlog;
using RTT::log;
using std::string;

DeploymentComponent::DeploymentComponent(string name, string siteFile, Purpose purpose)
    : DeploymentComponent(std::move(name), std::move(siteFile), purpose, Serve()) {}

DeploymentComponent::DeploymentComponent(string name, string siteFile, Purpose purpose, Serve serve)
    : TaskContext(name, Stopped), impl_(new Impl) {
    impl_->session.deployer = this;
    impl_->session.serve = std::move(serve);
    impl_->session.loaded = [this](RTT::TaskContext* component) { return componentLoaded(component); };
    impl_->session.unloaded = [this](RTT::TaskContext* component) { componentUnloaded(component); };
    impl_->purpose = purpose;
    addDeploymentInterface();
    RTT::internal::FailureReport::add(*provides());
    if (purpose == Purpose::Check) {
        impl_->session.startsNothing = true;
        deploy::holdBack(*this);
    }

    const string site = siteFile.empty() ? name + "-site.cpf" : siteFile;
    std::error_code unreadable;  // reported when it is read
    if (std::filesystem::exists(site, unreadable) || unreadable) {
        log(RTT::Info) << "using site file '" << site << "'" << endlog();
        impl_->siteFileFailed = !(purpose == Purpose::PlanOnly ? planOnly(site) : kickStart(site));
        return;
    }
    (void)configure();
    log(siteFile.empty() ? RTT::Info : RTT::Warning)
        << "there is no site file '" << site << "': importing 'ocl'" << endlog();
    string error;
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

// --- libraries ------------------------------------------------------------------------------------------------------

bool DeploymentComponent::import(const string& package) { return deploy::importPackage(package); }
void DeploymentComponent::path(const string& paths) { deploy::importPath(paths); }
bool DeploymentComponent::loadLibrary(const string& name) {
    string error;
    return deploy::loadLibrary(name, error) || deploy::failed("could not load library '" + name + "': " + error);
}
bool DeploymentComponent::reloadLibrary(const string& filepath) {
    return deploy::doneOr("", [&] { return RTT::ComponentLoader::Instance()->reloadLibrary(filepath); });
}
void DeploymentComponent::displayComponentTypes() const {
    std::cout << "I can create the following component types: " << std::endl;
    const std::vector<string> types = getComponentTypes();
    for (const string& type : types) std::cout << "   " << type << std::endl;
    if (types.empty()) std::cout << "   (none)" << std::endl;
}
std::vector<string> DeploymentComponent::getComponentTypes() const {
    return RTT::ComponentLoader::Instance()->listComponentTypes();
}

// --- single components ----------------------------------------------------------------------------------------------

bool DeploymentComponent::loadComponent(const string& name, const string& type) {
    return impl_->components.load(name, type);
}
bool DeploymentComponent::loadService(const string& name, const string& service) {
    return impl_->components.loadService(name, service);
}
bool DeploymentComponent::unloadComponent(const string& name) { return impl_->components.unload(name); }
bool DeploymentComponent::configureComponent(const string& name) { return impl_->components.configure(name); }
bool DeploymentComponent::startComponent(const string& name) { return impl_->components.start(name); }
bool DeploymentComponent::stopComponent(const string& name) { return impl_->components.stop(name); }
bool DeploymentComponent::cleanupComponent(const string& name) { return impl_->components.cleanup(name); }
bool DeploymentComponent::kickOutComponent(const string& name) { return impl_->components.kickOut(name); }

// --- files ----------------------------------------------------------------------------------------------------------

bool DeploymentComponent::loadComponents(const string& file) { return impl_->files.load(file); }
bool DeploymentComponent::loadConfigurationString(const string& text) { return impl_->files.loadText(text); }
void DeploymentComponent::clearConfiguration() { impl_->files.forget(); }
bool DeploymentComponent::configureComponents() { return impl_->files.configureAll(); }
bool DeploymentComponent::startComponents() { return impl_->files.startAll(); }
bool DeploymentComponent::stopComponents() { return impl_->files.forAllDown("stop", &deploy::stop); }
bool DeploymentComponent::cleanupComponents() { return impl_->files.forAllDown("clean up", &deploy::cleanup); }
bool DeploymentComponent::unloadComponents() { return impl_->files.forAllDown("unload", &deploy::unload); }
bool DeploymentComponent::kickStart(const string& file) {
    return deploy::reported("could not deploy '" + file + "'", [&] { return kickStart2(file, true); });
}
bool DeploymentComponent::kickStart2(const string& file, bool start) { return impl_->files.kickStart(file, start); }
bool DeploymentComponent::kickOutAll() { return impl_->files.kickOutAll(); }
void DeploymentComponent::kickOut(const string& file) { impl_->files.kickOut(file, impl_->components); }
bool DeploymentComponent::planOnly(const string& file) { return impl_->files.plan(file); }
string DeploymentComponent::chains() const { return deploy::chainsOf(impl_->session); }
string DeploymentComponent::planSummary() const {
    return impl_->session.planned.empty() ? "" : deploy::summaryOf(impl_->session);
}
bool DeploymentComponent::siteFileFailed() const { return impl_->siteFileFailed; }
string DeploymentComponent::graph() const { return deploy::graphOf(impl_->session); }
bool DeploymentComponent::runScript(const string& file) {
    string error;
    const string what = "could not run script '" + file + "'";
    const auto run = [&] { return deploy::runScript(*this, deploy::ScriptPlan::Run, file, error); };
    if (deploy::reported(what, run)) return true;
    if (!error.empty()) log(RTT::Error) << what << ": " << error << endlog();
    return false;
}
bool DeploymentComponent::checkScript(const string& file) {
    return deploy::checkScript(impl_->session, file, /*runs=*/impl_->purpose == Purpose::Deploy);
}
void DeploymentComponent::shutdownDeployment() { deploy::shutDownApplication(*this); }

// --- peers, ports, services -----------------------------------------------------------------------------------------

bool DeploymentComponent::addPeer(RTT::TaskContext* peer, string alias) {
    const string name = alias.empty() && peer ? peer->getName() : alias;
    if (const string why = deploy::nameFault(name); !why.empty())
        return deploy::failed("could not add peer '" + deploy::printableName(name) + "': " + why);
    return TaskContext::addPeer(peer, std::move(alias));
}
bool DeploymentComponent::addPeer(const string& from, const string& to) { return impl_->wiring.addPeer(from, to); }
bool DeploymentComponent::aliasPeer(const string& from, const string& to, const string& alias) {
    return impl_->wiring.addPeer(from, to, alias);
}
bool DeploymentComponent::connectPeers(const string& one, const string& two) {
    return impl_->wiring.connectPeers(one, two);
}
bool DeploymentComponent::connectPorts(const string& one, const string& two) {
    return impl_->wiring.connectPorts(one, two);
}
bool DeploymentComponent::connectTwoPorts(const string& one, const string& portOne, const string& two,
                                          const string& portTwo) {
    return connect(one + "." + portOne, two + "." + portTwo, RTT::ConnPolicy());
}
bool DeploymentComponent::connect(const string& portOne, const string& portTwo, RTT::ConnPolicy policy) {
    return impl_->wiring.connect(portOne, portTwo, policy);
}
bool DeploymentComponent::stream(const string& port, RTT::ConnPolicy policy) {
    return impl_->wiring.stream(port, policy);
}
bool DeploymentComponent::createStream(const string& component, const string& port, RTT::ConnPolicy policy) {
    return stream(component + "." + port, policy);
}
bool DeploymentComponent::connectServices(const string& one, const string& two) {
    return impl_->wiring.connectServices(one, two);
}
bool DeploymentComponent::connectOperations(const string& requested, const string& provided) {
    return impl_->wiring.connectOperations(requested, provided);
}

// --- activities -----------------------------------------------------------------------------------------------------

bool DeploymentComponent::setActivity(const string& name, double period, int priority, int scheduler) {
    constexpr double kLikelyPriority = 10;
    if (period > kLikelyPriority && priority == 0 && scheduler == ORO_SCHED_RT)
        log(RTT::Warning) << "component '" << name << "' gets a period of " << period
                          << " s and priority 0 in a real-time scheduler; setActivity() takes the name, the period in "
                             "seconds, the priority and the scheduler, in this order"
                          << endlog();
    return impl_->components.setActivity(name, ActivityKind::Activity, {period, priority, scheduler});
}
bool DeploymentComponent::setActivityOnCPU(const string& name, double period, int priority, int scheduler,
                                           unsigned int cpu) {
    if (cpu >= 32)
        return deploy::failed("could not set the activity of component '" + name + "': CPU " + std::to_string(cpu) +
                              ", expected 0 to 31");
    return impl_->components.setActivity(name, ActivityKind::Activity, {period, priority, scheduler, 1u << cpu});
}
bool DeploymentComponent::setPeriodicActivity(const string& name, double period, int priority, int scheduler) {
    return impl_->components.setActivity(name, ActivityKind::Periodic, {period, priority, scheduler});
}
bool DeploymentComponent::setFileDescriptorActivity(const string& name, double timeout, int priority, int scheduler) {
    return impl_->components.setActivity(name, ActivityKind::FileDescriptor, {timeout, priority, scheduler});
}
bool DeploymentComponent::setSequentialActivity(const string& name) {
    return impl_->components.setActivity(name, ActivityKind::Sequential, {});
}
bool DeploymentComponent::setSlaveActivity(const string& name, double period) {
    return impl_->components.setActivity(name, ActivityKind::Slave, {period});
}
bool DeploymentComponent::setMasterSlaveActivity(const string& master, const string& slave) {
    return impl_->components.setSlaveOf(master, slave);
}
bool DeploymentComponent::chain(const string& name, double period, int priority, int scheduler,
                                const std::vector<string>& members) {
    return impl_->components.chain(name, {period, priority, scheduler}, members);
}
bool DeploymentComponent::setWaitPeriodPolicy(const string& name, int policy) {
    return impl_->components.setWaitPeriodPolicy(name, policy);
}

// --- waiting --------------------------------------------------------------------------------------------------------

void DeploymentComponent::waitForInterrupt() {
    if (deploy::replaysInstead("waitForInterrupt")) return;
    RTT::os::SignalCatcher catcher({SIGINT, SIGTERM, SIGHUP});
    std::cout << "DeploymentComponent: waiting for an interrupt" << std::endl;
    (void)catcher.wait();
    std::cout << "DeploymentComponent: got the interrupt" << std::endl;
}

bool DeploymentComponent::waitForSignal(int signal) {
    if (deploy::replaysInstead("waitForSignal")) return true;
    RTT::os::SignalCatcher catcher({signal});
    if (!catcher.ready()) {
        log(RTT::Error) << "signal " << signal << " cannot be caught" << endlog();
        return false;
    }
    return catcher.wait() == signal;  // otherwise the program must end
}

}  // namespace OCL
