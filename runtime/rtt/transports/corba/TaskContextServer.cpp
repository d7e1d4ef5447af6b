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
#include <rtt/transports/corba/detail/thread_settings.hpp>
#include <rtt/transports/corba/detail/watch.hpp>

#include <fstream>
#include <iostream>
#include <map>
#include <mutex>

namespace RTT::corba {

/** Recursive: making a server may make others. */
struct TaskContextServer::Servers {
    std::recursive_mutex mutex;
    std::map<TaskContext*, std::shared_ptr<TaskContextServer>> all;
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
    const std::shared_ptr<TaskContextServer> server = owner ? TaskContextServer::find(*owner) : nullptr;
    return server ? server->served_->reference(service.shared_from_this()) : CService::_nil();
}

TaskContextServer::TaskContextServer(TaskContext& component)
    : served_(std::make_shared<detail::ServedComponent>(component)) {
    reference_ = served_->activate<CTaskContext>(new detail::TaskContextServant(served_));
}

TaskContextServer::~TaskContextServer() {
    unbind();
    served_->close();
}

void TaskContextServer::unbind() {
    std::set<std::string> names;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        names.swap(bound_);
    }
    for (const std::string& name : names) detail::unbindName(name, reference_);
}

std::shared_ptr<TaskContextServer> TaskContextServer::find(TaskContext& component) {
    auto& all = servers().all;
    const auto found = all.find(&component);
    if (found == all.end()) return nullptr;
    if (!found->second->served_->isGone()) return found->second;
    // Of an earlier component that was at this address. Its end may call the naming service, and there is a lock.
    detail::later([last = found->second] {});
    all.erase(found);
    return nullptr;
}

namespace {

/** Not for components that are served because others mention them: this changes their interface. */
void addShutdown(TaskContext& component) {
    if (component.provides()->hasOperation("shutdown")) return;
    component.addOperation("shutdown", &TaskContextServer::EndRun)
        .doc("Ends the program, if it waits for calls of other processes.");
}

}  // namespace

std::shared_ptr<TaskContextServer> TaskContextServer::make(TaskContext* tc, const std::string& alias, bool use_naming,
                                                           bool require, bool emits) {
    const Logger::In in("TaskContextServer");
    if (!hasOrb(tc)) return nullptr;
    try {
        std::shared_ptr<TaskContextServer> server;
        bool isNew = false;
        {
            const std::lock_guard<std::recursive_mutex> lock(servers().mutex);
            server = find(*tc);
            isNew = !server;
            if (isNew) {
                if (emits) addShutdown(*tc);  // before threads of the ORB read the interface
                server.reset(new TaskContextServer(*tc));
                servers().all[tc] = server;
            }
        }
        if (server->bind(alias, use_naming, require, emits)) return server;
        if (isNew) CleanupServer(tc);
    } catch (const CORBA::Exception& error) {
        log(Error) << "no server for component '" << tc->getName() << "': " << detail::describe(error) << endlog();
    }
    return nullptr;
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
            remember(name);
            return true;
        case detail::Bound::Again:
            log(Warning) << "the naming service had another component '" << name << "', which this one replaces"
                         << endlog();
            remember(name);
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
                 << (emits ? "; others can use the reference in " + name + ".ior" : std::string()) << endlog();
    if (emits) emit(name);
    return true;
}

void TaskContextServer::remember(const std::string& name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    bound_.insert(name);
}

void TaskContextServer::emit(const std::string& name) const {
    const CORBA::String_var text = orb->object_to_string(reference_);
    std::cerr << text.in() << std::endl;
    std::ofstream(name + ".ior") << text.in() << '\n';
}

TaskContextServer* TaskContextServer::Create(TaskContext* tc, bool use_naming, bool require_name_service) {
    return make(tc, tc ? tc->getName() : "", use_naming, require_name_service, true).get();
}

TaskContextServer* TaskContextServer::Create(TaskContext* tc, const std::string& alias, bool use_naming,
                                             bool require_name_service) {
    return make(tc, alias, use_naming, require_name_service, true).get();
}

CTaskContext_ptr TaskContextServer::CreateServer(TaskContext* tc, bool use_naming, bool require_name_service) {
    return CreateServer(tc, tc ? tc->getName() : "", use_naming, require_name_service);
}

CTaskContext_ptr TaskContextServer::CreateServer(TaskContext* tc, const std::string& alias, bool use_naming,
                                                 bool require_name_service) {
    if (const auto* const proxy = dynamic_cast<const TaskContextProxy*>(tc))
        return CTaskContext::_duplicate(proxy->server());
    const std::shared_ptr<TaskContextServer> server = make(tc, alias, use_naming, require_name_service, false);
    return server ? CTaskContext::_duplicate(server->reference_) : CTaskContext::_nil();
}

void TaskContextServer::CleanupServer(TaskContext* tc) {
    std::shared_ptr<TaskContextServer> last;  // ends without the lock
    const std::lock_guard<std::recursive_mutex> lock(servers().mutex);
    const auto found = servers().all.find(tc);
    if (found == servers().all.end()) return;
    last = std::move(found->second);
    servers().all.erase(found);
}

void TaskContextServer::CleanupServers() {
    std::map<TaskContext*, std::shared_ptr<TaskContextServer>> last;  // end without the lock
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
    const detail::ThreadSettings wanted =
        detail::threadSettings("OrbRunner", nullptr, {scheduler, priority, cpu_affinity});
    servers().runner = std::make_unique<OrbRunner>(wanted.scheduler, wanted.priority, wanted.cpuAffinity);
    (void)servers().runner->start();
}

void TaskContextServer::ShutdownOrb(bool wait) {
    EndRun();
    const CORBA::ORB_var own = orb;
    if (CORBA::is_nil(own)) return;
    std::map<TaskContext*, std::shared_ptr<TaskContextServer>> all;
    {
        const std::lock_guard<std::recursive_mutex> lock(servers().mutex);
        all = servers().all;
    }
    for (const auto& entry : all) entry.second->unbind();
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
    // Nobody calls this process any more when the references of the ORB go.
    detail::endWatches();
    detail::endLater();
    if (CORBA::is_nil(orb)) return;
    try {
        orb->shutdown(true);
        detail::endLater();
        const CORBA::ORB_var own = orb._retn();
        rootPOA = PortableServer::POA::_nil();
        own->destroy();
    } catch (const CORBA::Exception& error) {
        log(Error) << "the ORB does not end: " << error._name() << endlog();
    }
}

std::string TaskContextServer::getIOR(TaskContext* tc) {
    const std::lock_guard<std::recursive_mutex> lock(servers().mutex);
    const std::shared_ptr<TaskContextServer> server = tc ? find(*tc) : nullptr;
    if (!server) return "";
    const CORBA::String_var text = orb->object_to_string(server->reference_);
    return text.in();
}

}  // namespace RTT::corba
