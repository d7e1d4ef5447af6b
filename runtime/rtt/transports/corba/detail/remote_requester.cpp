// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/remote_requester.hpp>

#include <rtt/Logger.hpp>
#include <rtt/Service.hpp>
#include <rtt/transports/corba/detail/remote_part.hpp>
#include <rtt/transports/corba/detail/served_components.hpp>
#include <rtt/transports/corba/detail/serving.hpp>

#include <algorithm>
#include <mutex>
#include <string>
#include <utility>

namespace RTT::corba::detail {

namespace {

/** A caller of another process: binding it binds that one. */
class RemoteCaller final : public base::OperationCallerBaseInvoker {
public:
    RemoteCaller(const std::string& name, ServiceRequester& requester, std::shared_ptr<RemotePeer> peer)
        : OperationCallerBaseInvoker(name), requester_(requester), peer_(std::move(peer)) {}

    void attach(CServiceRequester_ptr reference) {
        const CServiceRequester_var own = limited<CServiceRequester>(reference);
        const std::lock_guard<std::mutex> lock(mutex_);
        reference_ = own;
    }
    bool ready() const override {
        return ask([this](CServiceRequester_ptr there) { return there->callerReady(name_.c_str()); });
    }
    bool setImplementationPart(OperationInterfacePart* part, ExecutionEngine* = nullptr) override {
        if (!part) {
            disconnect();
            return true;
        }
        const CService_var service = serviceOf(*part);
        if (!CORBA::is_nil(service) && part->getName() == name_)
            return ask([&](CServiceRequester_ptr there) { return there->connectCallerTo(name_.c_str(), service); });
        log(Error) << "operation caller '" << name_ << "' of component '" << peer_->name()
                   << "' of another process is connected with a service that has an operation of this name, as by "
                      "connectServices(); '"
                   << part->getName() << "' is none" << endlog();
        return false;
    }
    bool setImplementation(base::DisposableInterface::shared_ptr, ExecutionEngine* = nullptr) override {
        log(Error) << "operation caller '" << name_ << "' of component '" << peer_->name()
                   << "' of another process cannot use a function of this one: make it an operation" << endlog();
        return false;
    }
    void disconnect() override {
        (void)ask([this](CServiceRequester_ptr there) { return there->disconnectCaller(name_.c_str()); });
    }
    void setCaller(ExecutionEngine*) override {}

private:
    /** Nil if it is unknown. */
    CService_var serviceOf(OperationInterfacePart& part) const {
        if (const auto* const remote = dynamic_cast<const RemotePart*>(&part)) return remote->service();
        const Service::shared_ptr referenced = requester_.getReferencedService();
        return referenced && referenced->findOperation(name_) == &part ? serve(*referenced) : CService::_nil();
    }
    template <class Call>
    bool ask(Call call) const {
        CServiceRequester_var there;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!peer_->isLost()) there = reference_;
        }
        if (CORBA::is_nil(there)) return false;
        try {
            return whileServing([&]() -> bool { return call(there.in()); });
        } catch (const CORBA::Exception& error) {
            peer_->failed(error);
            return false;
        }
    }

    ServiceRequester& requester_;
    const std::shared_ptr<RemotePeer> peer_;
    mutable std::mutex mutex_;
    CServiceRequester_var reference_;
};

}  // namespace

void fill(ServiceRequester& requester, CServiceRequester_ptr reference, const CServiceRequesterDescription& described,
          const std::shared_ptr<RemotePeer>& peer, RemoteCallerList& callers) {
    for (CORBA::ULong i = 0; i != described.operationcallernames.length(); ++i) {
        const std::string name = described.operationcallernames[i].in();
        auto* known = dynamic_cast<RemoteCaller*>(requester.getOperationCaller(name));
        if (!known) {
            callers.push_back(std::make_unique<RemoteCaller>(name, requester, peer));
            known = static_cast<RemoteCaller*>(callers.back().get());
            if (!requester.addOperationCaller(*known)) continue;
        }
        known->attach(reference);
    }
    const CORBA::ULong children = std::min(described.children.length(), described.children_descriptions.length());
    for (CORBA::ULong i = 0; i != children; ++i) {
        const CServiceRequesterDescription& child = described.children_descriptions[i];
        fill(*requester.requires_(child.name.in()), described.children[i], child, peer, callers);
    }
}

}  // namespace RTT::corba::detail
