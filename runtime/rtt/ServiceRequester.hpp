// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SERVICE_REQUESTER_HPP
#define ORO_SERVICE_REQUESTER_HPP

#include <rtt/OperationCaller.hpp>
#include <rtt/Service.hpp>

#include <boost/enable_shared_from_this.hpp>
#include <boost/shared_ptr.hpp>

#include <map>
#include <string>
#include <vector>

namespace RTT {

/** The operations that a component requires of another, grouped under a name. Not thread safe; not real-time safe. */
class RTT_API ServiceRequester : public boost::enable_shared_from_this<ServiceRequester> {
public:
    typedef boost::shared_ptr<ServiceRequester> shared_ptr;
    typedef boost::shared_ptr<const ServiceRequester> shared_constptr;
    typedef std::vector<std::string> RequesterNames;
    typedef std::vector<std::string> OperationCallerNames;

    static shared_ptr Create(const std::string& name, TaskContext* owner = nullptr);
    explicit ServiceRequester(const std::string& name, TaskContext* owner = nullptr);
    virtual ~ServiceRequester();
    ServiceRequester(const ServiceRequester&) = delete;
    ServiceRequester& operator=(const ServiceRequester&) = delete;

    /** The caller has the name of the operation that it will be bound to. False if the name is taken. */
    bool addOperationCaller(base::OperationCallerBaseInvoker& caller);
    OperationCallerNames getOperationCallerNames() const;
    base::OperationCallerBaseInvoker* getOperationCaller(const std::string& name) const;

    const std::string& getRequestName() const { return name_; }
    TaskContext* getServiceOwner() const { return owner_; }
    /** For the component. With null, the callers keep their engine. */
    void setOwner(TaskContext* owner);
    /** The service to which this was connected last. */
    Service::shared_ptr getReferencedService() const { return service_; }

    /** This requester, and the one of that name, made if there is none. */
    shared_ptr requires_();
    shared_ptr requires_(const std::string& name);
#if __cplusplus < 202002L
    shared_ptr requires() { return requires_(); }
    shared_ptr requires(const std::string& name) { return requires_(name); }
#endif
    bool addServiceRequester(shared_ptr requester);
    bool requiresService(const std::string& name) const;
    RequesterNames getRequesterNames() const;

    /** Binds each caller that is not ready to the operation of its name. True if all are ready afterwards; an Info line
        names those that the service lacks. */
    virtual bool connectTo(Service::shared_ptr service);
    /** The names of the callers that are not ready, in alphabetical order, separated by commas. */
    std::string missingOperations() const;
    /** True if all callers are ready. */
    bool ready() const;
    void disconnect();
    void clear();

private:
    std::map<std::string, base::OperationCallerBaseInvoker*> callers_;
    std::map<std::string, shared_ptr> requesters_;
    Service::shared_ptr service_;
    std::string name_;
    TaskContext* owner_;
};

typedef boost::shared_ptr<ServiceRequester> ServiceRequesterPtr;

}  // namespace RTT

#endif
