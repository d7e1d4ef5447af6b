// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/TaskContextProxy.hpp>

#include <rtt/Logger.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/transports/corba/RemotePorts.hpp>
#include <rtt/transports/corba/TaskContextServer.hpp>
#include <rtt/transports/corba/detail/naming.hpp>
#include <rtt/transports/corba/detail/remote_peer.hpp>
#include <rtt/transports/corba/detail/remote_requester.hpp>
#include <rtt/transports/corba/detail/remote_service.hpp>
#include <rtt/transports/corba/detail/served_components.hpp>
#include <rtt/transports/corba/detail/serving.hpp>
#include <rtt/transports/corba/detail/watch.hpp>

#include <algorithm>
#include <fstream>
#include <mutex>
#include <set>
#include <utility>

namespace RTT::corba {

IllegalServer::~IllegalServer() = default;

namespace {

/** All proxies, so that a component has one. */
struct Proxies {
    std::mutex mutex;
    std::set<TaskContextProxy*> all;

    TaskContextProxy* find(CTaskContext_ptr task) {
        const std::lock_guard<std::mutex> lock(mutex);
        for (TaskContextProxy* const one : all)
            if (!CORBA::is_nil(one->server()) && one->server()->_is_equivalent(task)) return one;
        return nullptr;
    }
};

Proxies& proxies() {
    static auto* const all = new Proxies();
    return *all;
}

/** Throws IllegalServer. */
CTaskContext_var resolve(const std::string& location, bool is_ior) {
    if (CORBA::is_nil(ApplicationServer::orb)) throw IllegalServer("call InitOrb() before");
    if (location.empty()) throw IllegalServer("its name is empty");
    std::string why;
    CTaskContext_var found;
    try {
        if (is_ior) {
            const CORBA::Object_var object = ApplicationServer::orb->string_to_object(location.c_str());
            found = CTaskContext::_narrow(object);
        } else {
            found = detail::resolveName(location, why);
        }
    } catch (const CORBA::MARSHAL&) {
        why = "it is no complete reference";
    } catch (const CORBA::Exception& error) {
        why = detail::describe(error);
    }
    if (CORBA::is_nil(found)) throw IllegalServer(why.empty() ? "it is no component" : why);
    return found;
}

TaskContextProxy* refused(const std::string& location, const IllegalServer& error) {
    log(Error) << "no proxy for component '" << location << "': " << error.reason << endlog();
    return nullptr;
}

std::string nameOf(CTaskContext_ptr task) {
    const CORBA::String_var name = detail::limited<CTaskContext>(task)->getName();
    return name.in();
}

/** Does something with a port, which is one of the two. */
template <class Action>
void with(base::PortInterface& port, Action action) {
    if (auto* const input = dynamic_cast<RemoteInputPort*>(&port)) action(*input);
    if (auto* const output = dynamic_cast<RemoteOutputPort*>(&port)) action(*output);
}

/** The first word of a file; empty if there is none. */
std::string referenceIn(const std::string& file) {
    std::string reference;
    std::ifstream(file) >> reference;
    return reference;
}

/** For Create(), whose constructors are protected. */
class Made final : public TaskContextProxy {
public:
    explicit Made(CTaskContext_ptr task) : TaskContextProxy(task) {}
};

TaskContextProxy* proxyOf(CTaskContext_ptr task) {
    TaskContextProxy* const known = proxies().find(task);
    if (known) (void)known->synchronize();
    return known ? known : new Made(task);
}

}  // namespace

TaskContextProxy::TaskContextProxy() : TaskContext("NotFound", TaskContext::Stopped) {}

TaskContextProxy::TaskContextProxy(std::string location, bool is_ior) : TaskContextProxy() {
    initFromURIOrTaskname(std::move(location), is_ior);
}

TaskContextProxy::TaskContextProxy(CTaskContext_ptr task) : TaskContext("NotFound", TaskContext::Stopped) {
    begin(task);
}

TaskContextProxy::~TaskContextProxy() {
    {
        const std::lock_guard<std::mutex> lock(proxies().mutex);
        proxies().all.erase(this);
    }
    watch_.reset();
    for (const auto& port : ports_) {
        with(*port,
             [](auto& own) { own.attach(CDataFlowInterface::_nil()); });  // the other component keeps its connections
        if (port->getInterface()) port->getInterface()->removeLocalPort(port->getName());
    }
}

void TaskContextProxy::initFromURIOrTaskname(std::string location, bool is_ior) {
    if (!is_ior) location_ = location;
    begin(resolve(location, is_ior));
}

void TaskContextProxy::begin(CTaskContext_ptr task) {
    setActivity(new extras::SequentialActivity());
    try {
        const std::string name = nameOf(task);
        setServer(task);
        if (location_.empty()) location_ = name;
        remote_ = std::make_shared<detail::RemotePeer>(name);
        provides()->setName(name);
    } catch (const CORBA::Exception& error) {
        throw IllegalServer(detail::describe(error));
    }
    for (const std::string& own : provides()->getNames())
        provides()->remove(own);  // the other component's take their place
    if (!synchronize()) throw IllegalServer("it does not describe its interface");
    detail::addProxied(remote_);
    watch_ = std::make_unique<detail::Watch>([this] { check(); });
    const std::lock_guard<std::mutex> lock(proxies().mutex);
    proxies().all.insert(this);
}

TaskContextProxy* TaskContextProxy::Create(std::string name, bool is_ior) {
    const Logger::In in("TaskContextProxy");
    try {
        return proxyOf(resolve(name, is_ior));
    } catch (const IllegalServer& error) {
        return refused(name, error);
    }
}

TaskContextProxy* TaskContextProxy::CreateFromFile(std::string filename) {
    const std::string reference = referenceIn(filename);
    if (reference.empty()) {
        log(Error) << "no proxy: the file '" << filename << "' has no reference of a component" << endlog();
        return nullptr;
    }
    TaskContextProxy* const made = Create(reference, true);
    if (made) made->followFile(filename);
    return made;
}

TaskContext* TaskContextProxy::Create(CTaskContext_ptr task, bool force_remote) {
    const Logger::In in("TaskContextProxy");
    if (CORBA::is_nil(task)) return nullptr;
    if (TaskContext* const near = force_remote ? nullptr : detail::servedComponent(task)) return near;
    try {
        return proxyOf(task);
    } catch (const IllegalServer& error) {
        return refused("of a reference", error);
    }
}

void TaskContextProxy::DestroyOrb() { TaskContextServer::DestroyOrb(); }

void TaskContextProxy::followFile(const std::string& file) {
    const std::lock_guard<std::recursive_mutex> lock(checkMutex_);
    file_ = file;
}

CTaskContext_ptr TaskContextProxy::server() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return servers_.empty() ? CTaskContext::_nil() : servers_.back().in();
}

CTaskContext_var TaskContextProxy::limited() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return limited_;
}

void TaskContextProxy::setServer(CTaskContext_ptr task) {
    const CTaskContext_var own = detail::limited<CTaskContext>(task);
    const std::lock_guard<std::mutex> lock(mutex_);
    servers_.push_back(CTaskContext::_duplicate(task));
    limited_ = own;
}

bool TaskContextProxy::synchronize() {
    const std::lock_guard<std::recursive_mutex> lock(checkMutex_);
    const CTaskContext_var from = limited();
    if (CORBA::is_nil(from)) return false;
    try {
        const CTaskContextDescription_var described = from->getCTaskContextDescription();
        detail::fill(*provides(), described->mainprovider, described->mainprovider_description, remote_, ports_);
        detail::fill(*requires_(), described->mainrequester, described->mainrequester_description, remote_, callers_);
        return true;
    } catch (const CORBA::Exception& error) {
        remote_->failed(error);
        return false;
    }
}

bool TaskContextProxy::answers() {
    const CTaskContext_var from = limited();
    if (CORBA::is_nil(from)) return false;
    try {
        (void)from->getTaskState();
        return true;
    } catch (const CORBA::Exception& error) {
        remote_->failed(error);
        return false;
    }
}

/** Takes the component that has the place of this one now. */
bool TaskContextProxy::findAgain() {
    std::string why;
    CTaskContext_var found;
    try {
        const std::string reference = file_.empty() ? "" : referenceIn(file_);
        if (reference.empty()) {
            found = detail::resolveName(location_, why);
        } else {
            const CORBA::Object_var object = orb->string_to_object(reference.c_str());
            found = CTaskContext::_narrow(object);
        }
        if (CORBA::is_nil(found) || found->_is_equivalent(server())) return false;
        (void)detail::limited<CTaskContext>(found)->getTaskState();
    } catch (const CORBA::Exception&) {
        return false;  // the name is still that of the process that has ended
    }
    setServer(found);
    return true;
}

void TaskContextProxy::check() {
    const std::lock_guard<std::recursive_mutex> lock(checkMutex_);
    if (CORBA::is_nil(orb)) return;
    const bool isThere = answers();
    if (remote_->isLost() && !std::exchange(isLossKnown_, true))
        for (const auto& port : ports_) with(*port, [](auto& own) { own.lost(); });
    if (!isThere && !findAgain()) return;
    if (remote_->isLost()) {
        if (!synchronize()) return;
        remote_->found();
        isLossKnown_ = false;
    }
    for (const auto& port : ports_) with(*port, [](auto& own) { own.restore(); });
}

template <class Result, class Call>
Result TaskContextProxy::askBy(const CTaskContext_var& reference, Result otherwise, Call call) const {
    if (CORBA::is_nil(reference) || remote_->isLost()) return otherwise;
    try {
        return detail::whileServing([&] { return call(reference.in()); });
    } catch (const CORBA::Exception& error) {
        remote_->failed(error);
        return otherwise;
    }
}

template <class Result, class Call>
Result TaskContextProxy::ask(Result otherwise, Call call) const {
    return askBy(CTaskContext_var(CTaskContext::_duplicate(server())), otherwise, call);
}

template <class Result, class Call>
Result TaskContextProxy::askBriefly(Result otherwise, Call call) const {
    const CTaskContext_var from = limited();
    return askBy(from, otherwise, call);
}

bool TaskContextProxy::configure() {
    return ask(false, [](CTaskContext_ptr server) -> bool { return server->configure(); });
}
bool TaskContextProxy::start() {
    return ask(false, [](CTaskContext_ptr server) -> bool { return server->start(); });
}
bool TaskContextProxy::activate() {
    return ask(false, [](CTaskContext_ptr server) -> bool { return server->activate(); });
}
bool TaskContextProxy::stop() {
    return ask(false, [](CTaskContext_ptr server) -> bool { return server->stop(); });
}
bool TaskContextProxy::recover() {
    return ask(false, [](CTaskContext_ptr server) -> bool { return server->recover(); });
}
bool TaskContextProxy::cleanup() {
    return ask(false, [](CTaskContext_ptr server) -> bool { return server->cleanup(); });
}
bool TaskContextProxy::isActive() const {
    return askBriefly(false, [](CTaskContext_ptr server) -> bool { return server->isActive(); });
}
bool TaskContextProxy::isRunning() const {
    return askBriefly(false, [](CTaskContext_ptr server) -> bool { return server->isRunning(); });
}
bool TaskContextProxy::isConfigured() const {
    return askBriefly(false, [](CTaskContext_ptr server) -> bool { return server->isConfigured(); });
}
bool TaskContextProxy::inFatalError() const {
    return askBriefly(false, [](CTaskContext_ptr server) -> bool { return server->inFatalError(); });
}
bool TaskContextProxy::inRunTimeError() const {
    return askBriefly(false, [](CTaskContext_ptr server) -> bool { return server->inRunTimeError(); });
}
bool TaskContextProxy::inException() const {
    return askBriefly(false, [](CTaskContext_ptr server) -> bool { return server->inException(); });
}
base::TaskCore::TaskState TaskContextProxy::getTaskState() const {
    return askBriefly(Init, [](CTaskContext_ptr server) { return static_cast<TaskState>(server->getTaskState()); });
}
bool TaskContextProxy::ready() {
    return detail::whileServing([this] {
        check();
        return !remote_->isLost();
    });
}

CTaskContext_var TaskContextProxy::referenceOf(TaskContext* peer) const {
    return peer ? TaskContextServer::CreateServer(peer, false, false) : CTaskContext::_nil();
}

bool TaskContextProxy::addPeer(TaskContext* peer, std::string alias) {
    const CTaskContext_var reference = referenceOf(peer);
    if (CORBA::is_nil(reference)) return false;
    return ask(false, [&](CTaskContext_ptr server) -> bool { return server->addPeer(reference, alias.c_str()); });
}
void TaskContextProxy::removePeer(const std::string& name) {
    (void)ask(false, [&](CTaskContext_ptr server) -> bool { return server->removePeer(name.c_str()); });
}
void TaskContextProxy::removePeer(TaskContext* peer) {
    if (peer) removePeer(peer->getName());
}
bool TaskContextProxy::connectPeers(TaskContext* peer) {
    const CTaskContext_var reference = referenceOf(peer);
    if (CORBA::is_nil(reference)) return false;
    return ask(false, [&](CTaskContext_ptr server) -> bool { return server->connectPeers(reference); });
}
void TaskContextProxy::disconnectPeers(const std::string& name) {
    (void)ask(false, [&](CTaskContext_ptr server) -> bool { return server->disconnectPeers(name.c_str()); });
}
TaskContext::PeerList TaskContextProxy::getPeerList() const {
    return askBriefly(PeerList(), [](CTaskContext_ptr server) {
        CTaskContext::CPeerNames_var names = server->getPeerList();
        PeerList list;
        for (CORBA::ULong i = 0; i != names->length(); ++i) list.push_back(names[i].in());
        return list;
    });
}
bool TaskContextProxy::hasPeer(const std::string& name) const {
    return askBriefly(false, [&](CTaskContext_ptr server) -> bool { return server->hasPeer(name.c_str()); });
}
TaskContext* TaskContextProxy::getPeer(const std::string& name) const {
    const CTaskContext_var peer = askBriefly(
        CTaskContext_var(), [&](CTaskContext_ptr server) { return CTaskContext_var(server->getPeer(name.c_str())); });
    return CORBA::is_nil(peer) ? nullptr : Create(peer.in());
}
bool TaskContextProxy::connectPorts(TaskContext* peer) {
    const CTaskContext_var reference = referenceOf(peer);
    if (CORBA::is_nil(reference)) return false;
    return ask(false, [&](CTaskContext_ptr server) -> bool { return server->connectPorts(reference); });
}
bool TaskContextProxy::connectServices(TaskContext* peer) {
    const CTaskContext_var reference = referenceOf(peer);
    if (CORBA::is_nil(reference)) return false;
    return ask(false, [&](CTaskContext_ptr server) -> bool { return server->connectServices(reference); });
}

}  // namespace RTT::corba
