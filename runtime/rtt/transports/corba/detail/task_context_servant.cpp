// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/task_context_servant.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/transports/corba/TaskContextProxy.hpp>
#include <rtt/transports/corba/TaskContextServer.hpp>

#include <string>

namespace RTT::corba::detail {

namespace {

/** Calls a function of the component, which exists meanwhile. */
template <class Function>
auto call(const Served& served, Function function) {
    const ServedComponent::Use use(*served);
    return function(served->component());
}

/** The component itself if it is in this process; otherwise its proxy. Null, with an error logged, if it does not
    answer. */
TaskContext* peerOf(CTaskContext_ptr reference) {
    return CORBA::is_nil(reference) ? nullptr : TaskContextProxy::Create(reference);
}

}  // namespace

char* TaskContextServant::getName() {
    return call(served_, [](TaskContext& own) { return CORBA::string_dup(own.getName().c_str()); });
}

char* TaskContextServant::getDescription() {
    return call(served_, [](TaskContext& own) { return CORBA::string_dup(own.provides()->doc().c_str()); });
}

CTaskContextDescription* TaskContextServant::getCTaskContextDescription() {
    const ServedComponent::Use use(*served_);
    CTaskContextDescription_var made = new CTaskContextDescription();
    const CServiceRequester_var requester = served_->reference(served_->component().requires_());
    const CService_var provider = served_->reference(served_->component().provides());
    made->mainrequester = requester;
    made->mainrequester_description =
        CServiceRequesterDescription_var(requester->getCServiceRequesterDescription()).in();
    made->mainprovider = provider;
    made->mainprovider_description = CServiceDescription_var(provider->getCServiceDescription()).in();
    return made._retn();
}

CTaskState TaskContextServant::getTaskState() {
    return call(served_, [](TaskContext& own) { return static_cast<CTaskState>(own.getTaskState()); });
}

CORBA::Boolean TaskContextServant::configure() {
    return call(served_, [](TaskContext& own) { return own.configure(); });
}
CORBA::Boolean TaskContextServant::start() {
    return call(served_, [](TaskContext& own) { return own.start(); });
}
CORBA::Boolean TaskContextServant::activate() {
    return call(served_, [](TaskContext& own) { return own.activate(); });
}
CORBA::Boolean TaskContextServant::stop() {
    return call(served_, [](TaskContext& own) { return own.stop(); });
}
CORBA::Boolean TaskContextServant::recover() {
    return call(served_, [](TaskContext& own) { return own.recover(); });
}
CORBA::Boolean TaskContextServant::resetException() {
    return call(served_, [](TaskContext& own) { return own.inException() && own.recover(); });
}
CORBA::Boolean TaskContextServant::cleanup() {
    return call(served_, [](TaskContext& own) { return own.cleanup(); });
}
CORBA::Boolean TaskContextServant::isActive() {
    return call(served_, [](TaskContext& own) { return own.isActive(); });
}
CORBA::Boolean TaskContextServant::isRunning() {
    return call(served_, [](TaskContext& own) { return own.isRunning(); });
}
CORBA::Boolean TaskContextServant::isConfigured() {
    return call(served_, [](TaskContext& own) { return own.isConfigured(); });
}
CORBA::Boolean TaskContextServant::inFatalError() {
    return call(served_, [](TaskContext& own) { return own.inFatalError(); });
}
CORBA::Boolean TaskContextServant::inRunTimeError() {
    return call(served_, [](TaskContext& own) { return own.inRunTimeError(); });
}
CORBA::Boolean TaskContextServant::inException() {
    return call(served_, [](TaskContext& own) { return own.inException(); });
}

CDataFlowInterface_ptr TaskContextServant::ports() { return getProvider("this"); }

CService_ptr TaskContextServant::getProvider(const char* service_name) {
    const ServedComponent::Use use(*served_);
    const Service::shared_ptr root = served_->component().provides();
    const std::string name = service_name;
    const Service::shared_ptr found = name == "this" ? root : root->getService(name);
    return found ? served_->reference(found) : corba::CService::_nil();
}

CServiceRequester_ptr TaskContextServant::getRequester(const char* service_name) {
    const ServedComponent::Use use(*served_);
    const ServiceRequester::shared_ptr root = served_->component().requires_();
    const std::string name = service_name;
    if (name == "this") return served_->reference(root);
    return root->requiresService(name) ? served_->reference(root->requires_(name)) : corba::CServiceRequester::_nil();
}

corba::CTaskContext::CPeerNames* TaskContextServant::getPeerList() {
    const ServedComponent::Use use(*served_);
    corba::CTaskContext::CPeerNames_var list = new corba::CTaskContext::CPeerNames();
    const TaskContext::PeerList names = served_->component().getPeerList();
    list->length(static_cast<CORBA::ULong>(names.size()));
    for (CORBA::ULong i = 0; i != list->length(); ++i) list[i] = names[i].c_str();
    return list._retn();
}

CTaskContext_ptr TaskContextServant::getPeer(const char* name) {
    const ServedComponent::Use use(*served_);
    TaskContext* const peer = served_->component().getPeer(name);
    return peer ? TaskContextServer::CreateServer(peer, false, false) : corba::CTaskContext::_nil();
}

CORBA::Boolean TaskContextServant::hasPeer(const char* name) {
    return call(served_, [name](TaskContext& own) { return own.hasPeer(name); });
}

CORBA::Boolean TaskContextServant::addPeer(CTaskContext_ptr p, const char* peer_alias) {
    return call(served_, [&](TaskContext& own) {
        TaskContext* const peer = peerOf(p);
        return peer && own.addPeer(peer, peer_alias);
    });
}

CORBA::Boolean TaskContextServant::removePeer(const char* name) {
    return call(served_, [name](TaskContext& own) {
        if (!own.hasPeer(name)) return false;
        own.removePeer(name);
        return true;
    });
}

CORBA::Boolean TaskContextServant::connectPeers(CTaskContext_ptr p) {
    return call(served_, [p](TaskContext& own) {
        TaskContext* const peer = peerOf(p);
        return peer && own.connectPeers(peer);
    });
}

CORBA::Boolean TaskContextServant::disconnectPeers(const char* name) {
    return call(served_, [name](TaskContext& own) {
        if (!own.hasPeer(name)) return false;
        own.disconnectPeers(name);
        return true;
    });
}

CORBA::Boolean TaskContextServant::connectPorts(CTaskContext_ptr p) {
    return call(served_, [p](TaskContext& own) {
        TaskContext* const peer = peerOf(p);
        return peer && own.connectPorts(peer);
    });
}

CORBA::Boolean TaskContextServant::connectServices(CTaskContext_ptr p) {
    return call(served_, [p](TaskContext& own) {
        TaskContext* const peer = peerOf(p);
        return peer && own.connectServices(peer);
    });
}

}  // namespace RTT::corba::detail
