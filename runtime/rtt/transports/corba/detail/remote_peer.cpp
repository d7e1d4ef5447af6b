// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/remote_peer.hpp>

#include <rtt/Logger.hpp>

#include <algorithm>
#include <cstring>
#include <vector>

namespace RTT::corba::detail {

std::string describe(const CORBA::Exception& error) {
    static const struct {
        const char* name;
        const char* meaning;
    } meanings[] = {
        {"COMM_FAILURE", "its process has ended, or the connection to it is broken"},
        {"TRANSIENT", "its process cannot be reached"},
        {"OBJECT_NOT_EXIST", "it was destroyed"},
        {"OBJ_ADAPTER", "its process is ending"},
        {"TIMEOUT", "it does not answer in time"},
        {"INV_OBJREF", "its reference is wrong"},
        {"BAD_OPERATION", "it has another interface, such as that of the original before version 2.9"},
        {"MARSHAL", "a value is too large, or of a type that one of the two does not know"},
    };
    for (const auto& one : meanings)
        if (std::strcmp(one.name, error._name()) == 0) return std::string(one.name) + ": " + one.meaning;
    return error._name();
}

namespace {

bool isLoss(const CORBA::Exception& error) {
    return CORBA::COMM_FAILURE::_downcast(&error) || CORBA::TRANSIENT::_downcast(&error) ||
           CORBA::TIMEOUT::_downcast(&error) || CORBA::OBJECT_NOT_EXIST::_downcast(&error) ||
           CORBA::OBJ_ADAPTER::_downcast(&error);
}

}  // namespace

void RemotePeer::failed(const CORBA::Exception& error) {
    if (!isLoss(error))
        log(Error) << "a call of component '" << name_ << "' of another process fails (" << describe(error) << ")"
                   << endlog();
    else if (!lost_.exchange(true))
        log(Error) << "component '" << name_ << "' of another process does not answer (" << describe(error) << ")"
                   << endlog();
}

void RemotePeer::found() {
    if (lost_.exchange(false))
        log(Warning) << "component '" << name_ << "' of another process answers again" << endlog();
}

std::shared_ptr<RemoteReference> RemotePeer::service(const std::string& path) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::shared_ptr<RemoteReference>& known = services_[path];
    if (!known) known = std::make_shared<RemoteReference>();
    return known;
}

std::shared_ptr<RemoteReference> RemotePeer::service(CService_ptr reference) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& [path, one] : services_) {
        const CService_var known = one->get();
        if (!CORBA::is_nil(known) && known->_is_equivalent(reference)) return one;
    }
    return nullptr;
}

namespace {

struct Proxied {
    std::mutex mutex;
    std::vector<std::weak_ptr<RemotePeer>> all;
};

Proxied& proxiedPeers() {
    static auto* const peers = new Proxied();  // never destroyed: threads of the ORB use it
    return *peers;
}

}  // namespace

void addProxied(const std::shared_ptr<RemotePeer>& peer) {
    const std::lock_guard<std::mutex> lock(proxiedPeers().mutex);
    std::vector<std::weak_ptr<RemotePeer>>& all = proxiedPeers().all;
    all.erase(std::remove_if(all.begin(), all.end(), [](const auto& one) { return one.expired(); }), all.end());
    all.push_back(peer);
}

std::shared_ptr<RemoteReference> proxied(CService_ptr service) {
    std::vector<std::weak_ptr<RemotePeer>> all;
    {
        const std::lock_guard<std::mutex> lock(proxiedPeers().mutex);
        all = proxiedPeers().all;
    }
    for (const auto& one : all) {
        const std::shared_ptr<RemotePeer> peer = one.lock();
        const std::shared_ptr<RemoteReference> found = peer ? peer->service(service) : nullptr;
        if (found) return found;
    }
    return nullptr;
}

}  // namespace RTT::corba::detail
