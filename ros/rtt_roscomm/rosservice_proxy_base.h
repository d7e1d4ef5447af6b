// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What connects operations with services, without the type of the service.
#ifndef RTT_ROSCOMM_ROSSERVICE_PROXY_BASE_H
#define RTT_ROSCOMM_ROSSERVICE_PROXY_BASE_H

#include <rtt_roscomm/service_client.hpp>
#include <rtt_roscomm/service_server.hpp>

#include <memory>
#include <string>
#include <vector>

namespace RTT {
class TaskContext;
}

namespace rtt_roscomm {

/** One end of a service. Made and destroyed by the component service rosservice. */
class ROSServiceProxyBase {
public:
    explicit ROSServiceProxyBase(const std::string& service_name);
    virtual ~ROSServiceProxyBase();
    ROSServiceProxyBase(const ROSServiceProxyBase&) = delete;
    ROSServiceProxyBase& operator=(const ROSServiceProxyBase&) = delete;
    const std::string& getServiceName() const { return service_name_; }

private:
    const std::string service_name_;
};

/** Offers an operation as a service until it is destroyed. */
class ROSServiceServerProxyBase : public ROSServiceProxyBase {
public:
    using ROSServiceProxyBase::ROSServiceProxyBase;
    /** Asks the master, so it blocks. False, with an error logged, if that is impossible. `owner` may be null. */
    virtual bool connect(RTT::TaskContext* owner, RTT::OperationInterfacePart* operation) = 0;

protected:
    /** "operation 'f' of component 'c'" */
    static std::string describe(const RTT::TaskContext* owner, const RTT::OperationInterfacePart& operation);
    bool advertise(const ServiceType& type, boost::shared_ptr<ServiceAnswer> answer);
    /** Logs which signatures fit; returns false. */
    bool refuse(const ServiceType& type, const RTT::TaskContext* owner, const RTT::OperationInterfacePart& operation,
                const std::vector<std::string>& wanted) const;

private:
    ServedService served_;
};

/** Puts a service behind an operation caller. When it is destroyed, the caller, and its copies, are not ready any more. */
class ROSServiceClientProxyBase : public ROSServiceProxyBase {
public:
    using ROSServiceProxyBase::ROSServiceProxyBase;
    ~ROSServiceClientProxyBase() override;
    /** The service need not exist yet. False, with an error logged, if that is impossible. `owner` may be null. */
    virtual bool connect(RTT::TaskContext* owner, RTT::base::OperationCallerBaseInvoker* caller) = 0;
    /** For calls of the next connect(): how many seconds they wait for the response; 0, as at first: for ever. */
    void setTimeout(double seconds) { timeout_ = seconds; }

protected:
    bool bind(const ServiceType& type, Form form, RTT::TaskContext* owner,
              RTT::base::OperationCallerBaseInvoker& caller);

private:
    double timeout_ = 0;
    std::shared_ptr<ServiceConnection> connection_;
};

/** Makes the proxies of one type of services. */
class ROSServiceProxyFactoryBase {
public:
    /** `service_type` as "std_srvs/Empty". */
    explicit ROSServiceProxyFactoryBase(const std::string& service_type);
    virtual ~ROSServiceProxyFactoryBase();
    ROSServiceProxyFactoryBase(const ROSServiceProxyFactoryBase&) = delete;
    ROSServiceProxyFactoryBase& operator=(const ROSServiceProxyFactoryBase&) = delete;
    const std::string& getType() const { return service_type_; }

    /** The caller owns the result. */
    virtual ROSServiceClientProxyBase* create_client_proxy(const std::string& service_name) = 0;
    virtual ROSServiceServerProxyBase* create_server_proxy(const std::string& service_name) = 0;

private:
    const std::string service_type_;
};

}  // namespace rtt_roscomm

// As in versions before 2.10.
using rtt_roscomm::ROSServiceClientProxyBase;
using rtt_roscomm::ROSServiceProxyBase;
using rtt_roscomm::ROSServiceProxyFactoryBase;
using rtt_roscomm::ROSServiceServerProxyBase;

#endif
