// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/remote_peer.hpp>

#include <rtt/Logger.hpp>

#include <cstring>

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
    if (!isWatched_ || !isLoss(error))
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

}  // namespace RTT::corba::detail
