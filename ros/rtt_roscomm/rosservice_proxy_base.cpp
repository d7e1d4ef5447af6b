// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt_roscomm/rosservice_proxy_base.h>

#include <utility>

namespace rtt_roscomm {

ROSServiceProxyBase::ROSServiceProxyBase(const std::string& service_name) : service_name_(service_name) {}
ROSServiceProxyBase::~ROSServiceProxyBase() = default;

std::string ROSServiceServerProxyBase::describe(const RTT::TaskContext* owner,
                                                const RTT::OperationInterfacePart& operation) {
    return "operation '" + operation.getName() + "'" + (owner ? " of component '" + owner->getName() + "'" : "");
}

bool ROSServiceServerProxyBase::advertise(const ServiceType& type, boost::shared_ptr<ServiceAnswer> answer) {
    return served_.advertise(getServiceName(), type, std::move(answer));
}

bool ROSServiceServerProxyBase::refuse(const ServiceType& type, const RTT::TaskContext* owner,
                                       const RTT::OperationInterfacePart& operation,
                                       const std::vector<std::string>& wanted) const {
    std::string list;
    for (const std::string& one : wanted) list += (list.empty() ? "" : ", or ") + one;
    RTT::log(RTT::Error) << describe(owner, operation) << " cannot be service '" << getServiceName() << "' of type "
                         << type.service << ": its signature is " << textOf(operation.signature()) << ", expected "
                         << list << RTT::endlog();
    return false;
}

ROSServiceClientProxyBase::~ROSServiceClientProxyBase() {
    if (connection_) connection_->close();
}

bool ROSServiceClientProxyBase::bind(const ServiceType& type, Form form, RTT::TaskContext* owner,
                                     RTT::base::OperationCallerBaseInvoker& caller) {
    const std::string who =
        "operation caller '" + caller.getName() + "'" + (owner ? " of component '" + owner->getName() + "'" : "");
    std::string resolved, why;
    if (!resolveService(getServiceName(), resolved, why)) {
        RTT::log(RTT::Error) << who << " cannot use service '" << getServiceName() << "': " << why << RTT::endlog();
        return false;
    }
    auto made = std::make_shared<ServiceConnection>(resolved, type, timeout_, who, owner);
    if (!bindCaller(caller, made, std::move(form), owner ? owner->engine() : nullptr)) return false;
    if (connection_) connection_->close();
    connection_ = std::move(made);
    return true;
}

ROSServiceProxyFactoryBase::ROSServiceProxyFactoryBase(const std::string& service_type) : service_type_(service_type) {}
ROSServiceProxyFactoryBase::~ROSServiceProxyFactoryBase() = default;

}  // namespace rtt_roscomm
