// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/TaskContextServer.hpp>

#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/transports/corba/TaskContextProxy.hpp>
#include <rtt/transports/corba/detail/later.hpp>
#include <rtt/transports/corba/detail/naming.hpp>
#include <rtt/transports/corba/detail/orb_run.hpp>
#include <rtt/transports/corba/detail/remote_peer.hpp>
#include <rtt/transports/corba/detail/served_components.hpp>
#include <rtt/transports/corba/detail/task_context_servant.hpp>
#include <rtt/transports/corba/detail/watch.hpp>

#include <fstream>
#include <iostream>
#include <map>
#include <mutex>

namespace RTT::corba {

/** Recursive: making a server may make others. */
struct TaskContextServer::Servers {
    std::recursive_mutex mutex;
    std::map<TaskContext*, std::unique_ptr<TaskContextServer>> all;
    std::unique_ptr<Activity> runner;
};

namespace {

class OrbRunner final : public Activity {
public:
    OrbRunner(int scheduler, int priority, unsigned cpuAffinity)
        : Activity(scheduler, priority, 0.0, cpuAffinity, nullptr, "OrbRunner") {}

protected:
    void loop() override { TaskContextServer::RunOrb(); }
    bool breakLoop() override {
        TaskContextServer::EndRun();
        return true;
    }
};

bool hasOrb(const TaskContext* component) {
    if (component && !CORBA::is_nil(ApplicationServer::orb)) return true;
    log(Error) << "no server for component '" << (component ? component->getName() : "null")
               << "': call InitOrb() before" << endlog();
    return false;
}

}  // namespace

TaskContextServer::Servers& TaskContextServer::servers() {
    static auto* const servers = new Servers();  // never destroyed: threads of the ORB may use it until the end
    return *servers;
}

Service::shared_ptr detail::servedService(CORBA::Object_ptr reference) {
    auto& servers = TaskContextServer::servers();
    const std::lock_guard<std::recursive_mutex> lock(servers.mutex);
    for (const auto& entry : servers.all)
        if (const Service::shared_ptr found = entry.second->served_->find(reference)) return found;
    return nullptr;
}

TaskContext* detail::servedComponent(CTaskContext_ptr reference) {
    auto& servers = TaskContextServer::servers();
    const std::lock_guard<std::recursive_mutex> lock(servers.mutex);
    for (const auto& [component, server] : servers.all)
        if (!server->served_->isGone() && server->reference_->_is_equivalent(reference)) return component;
    return nullptr;
}

CService_ptr detail::serve(Service& service) {
    TaskContext* const owner = service.getOwner();
    const CTaskContext_var component =
        owner ? TaskContextServer::CreateServer(owner, false, false) : CTaskContext::_nil();
    auto& servers = TaskContextServer::servers();
    const std::lock_guard<std::recursive_mutex> lock(servers.mutex);
    const TaskContextServer* const server = owner ? TaskContextServer::find(*owner) : nullptr;
    return server ? server->served_->reference(service.shared_from_this()) : CService::_nil();
}

TaskContextServer::TaskContextServer(TaskContext& component)
    : served_(std::make_shared<detail::ServedComponent>(component)) {
    hasShutdown_ = !component.provides()->hasOperation("shutdown");
    if (hasShutdown_)
        component.addOperation("shutdown", &TaskContextServer::EndRun)
            .doc("Ends the program, if it waits for calls of other processes.");
    // Last: from now on threads of the ORB read the interface.
    reference_ = served_->activate<CTaskContext>(new detail::TaskContextServant(served_));
}

TaskContextServer::~TaskContextServer() {
    unbind();
    served_->close();
    if (!hasShutdown_) return;
    try {
        const detail::ServedComponent::Use use(*served_);
        served_->component().provides()->removeOperation("shutdown");
    } catch (const CORBA::Exception&) {
        // The component was destroyed.
    }
}

void TaskContextServer::unbind() {
    for (const std::string& name : bound_) detail::unbindName(name, reference_);
    bound_.clear();
}

TaskContextServer* TaskContextServer::find(TaskContext& component) {
    auto& all = servers().all;
    const auto found = all.find(&component);
    if (found == all.end()) return nullptr;
    if (!found->second->served_->isGone()) return found->second.get();
    all.erase(found);  // of an earlier component that was at this address
    return nullptr;
}

TaskContextServer* TaskContextServer::make(TaskContext* tc, const std::string& alias, bool use_naming, bool require,
                                           bool emits) {
    const Logger::In in("TaskContextServer");
    if (!hasOrb(tc)) return nullptr;
    const std::lock_guard<std::recursive_mutex> lock(servers().mutex);
    try {
        if (TaskContextServer* const known = find(*tc))
            return known->bind(alias, use_naming, require, emits) ? known : nullptr;
        std::unique_ptr<TaskContextServer> made(new TaskContextServer(*tc));
        if (!made->bind(alias, use_naming, require, emits)) return nullptr;
        return (servers().all[tc] = std::move(made)).get();
    } catch (const CORBA::Exception& error) {
        log(Error) << "no server for component '" << tc->getName() << "': " << detail::describe(error) << endlog();
        return nullptr;
    }
}

bool TaskContextServer::bind(const std::string& name, bool use_naming, bool require, bool emits) {
    if (!use_naming) {
        if (emits) emit(name);
        return true;
    }
    std::string why;
    switch (detail::bindName(name, reference_, why)) {
        case detail::Bound::New:
            log(Info) << "component '" << name << "' is in the naming service" << endlog();
            bound_.insert(name);
            return true;
        case detail::Bound::Again:
            log(Warning) << "the naming service had another component '" << name << "', which this one replaces"
                         << endlog();
            bound_.insert(name);
            return true;
        case detail::Bound::NoService:
        case detail::Bound::Failed: break;
    }
    if (require) {
        log(Error) << "component '" << name << "' does not get into the naming service, which is required: " << why
                   << endlog();
        return false;
    }
    log(Warning) << "component '" << name << "' does not get into the naming service: " << why
                 << "; others can use the reference in " << name << ".ior" << endlog();
    if (emits) emit(name);
    return true;
}

void TaskContextServer::emit(const std::string& name) const {
    const CORBA::String_var text = orb->object_to_string(reference_);
    std::cerr << text.in() << std::endl;
    std::ofstream(name + ".ior") << text.in() << '\n';
}

TaskContextServer* TaskContextServer::Create(TaskContext* tc, bool use_naming, bool require_name_service) {
    return make(tc, tc ? tc->getName() : "", use_naming, require_name_service, true);
}

TaskContextServer* TaskContextServer::Create(TaskContext* tc, const std::string& alias, bool use_naming,
                                             bool require_name_service) {
    return make(tc, alias, use_naming, require_name_service, true);
}

CTaskContext_ptr TaskContextServer::CreateServer(TaskContext* tc, bool use_naming, bool require_name_service) {
    return CreateServer(tc, tc ? tc->getName() : "", use_naming, require_name_service);
}

CTaskContext_ptr TaskContextServer::CreateServer(TaskContext* tc, const std::string& alias, bool use_naming,
                                                 bool require_name_service) {
    if (const auto* const proxy = dynamic_cast<const TaskContextProxy*>(tc))
        return CTaskContext::_duplicate(proxy->server());
    const TaskContextServer* const server = make(tc, alias, use_naming, require_name_service, false);
    return server ? CTaskContext::_duplicate(server->reference_) : CTaskContext::_nil();
}

void TaskContextServer::CleanupServer(TaskContext* tc) {
    std::unique_ptr<TaskContextServer> last;
    const std::lock_guard<std::recursive_mutex> lock(servers().mutex);
    const auto found = servers().all.find(tc);
    if (found == servers().all.end()) return;
    last = std::move(found->second);
    servers().all.erase(found);
}

void TaskContextServer::CleanupServers() {
    std::map<TaskContext*, std::unique_ptr<TaskContextServer>> last;
    const std::lock_guard<std::recursive_mutex> lock(servers().mutex);
    last.swap(servers().all);
}

void TaskContextServer::RunOrb(int endsOn) {
    if (CORBA::is_nil(orb))
        log(Error) << "RunOrb() without an ORB: call InitOrb() before" << endlog();
    else
        detail::waitForEndOfRun(endsOn);
}

void TaskContextServer::EndRun() { detail::endRun(); }

void TaskContextServer::ThreadOrb() { ThreadOrb(ORO_SCHED_RT); }

void TaskContextServer::ThreadOrb(int scheduler, int priority, unsigned cpu_affinity) {
    const std::lock_guard<std::recursive_mutex> lock(servers().mutex);
    if (servers().runner) return;
    servers().runner = std::make_unique<OrbRunner>(scheduler, priority, cpu_affinity);
    (void)servers().runner->start();
}

void TaskContextServer::ShutdownOrb(bool wait) {
    EndRun();
    const CORBA::ORB_var own = orb;
    if (CORBA::is_nil(own)) return;
    {
        const std::lock_guard<std::recursive_mutex> lock(servers().mutex);
        for (const auto& entry : servers().all) entry.second->unbind();
    }
    try {
        own->shutdown(wait);
    } catch (const CORBA::Exception& error) {
        log(Error) << "the ORB does not end: " << error._name() << endlog();
    }
}

void TaskContextServer::DestroyOrb() {
    CleanupServers();
    std::unique_ptr<Activity> runner;
    {
        const std::lock_guard<std::recursive_mutex> lock(servers().mutex);
        runner = std::move(servers().runner);
    }
    EndRun();
    runner.reset();
    detail::endLater();
    detail::endWatches();
    const CORBA::ORB_var own = orb._retn();
    rootPOA = PortableServer::POA::_nil();
    if (CORBA::is_nil(own)) return;
    try {
        own->destroy();
    } catch (const CORBA::Exception& error) {
        log(Error) << "the ORB does not end: " << error._name() << endlog();
    }
}

std::string TaskContextServer::getIOR(TaskContext* tc) {
    const std::lock_guard<std::recursive_mutex> lock(servers().mutex);
    const TaskContextServer* const server = tc ? find(*tc) : nullptr;
    if (!server) return "";
    const CORBA::String_var text = orb->object_to_string(server->reference_);
    return text.in();
}

}  // namespace RTT::corba
