// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_RTT_ROSSERVICE_REGISTRY_SERVICE_H
#define RTT_ROSCOMM_RTT_ROSSERVICE_REGISTRY_SERVICE_H

#include <rtt/Service.hpp>
#include <rtt_roscomm/rosservice_proxy_base.h>

#include <string>
#include <vector>

namespace rtt_roscomm {

/** The global service rosservice_registry: the types of services that this process knows, from the tables of generated
    packages and from users, whose factories come first. Thread-safe; not real-time safe. */
class ROSServiceRegistryService : public RTT::Service {
public:
    typedef boost::shared_ptr<ROSServiceRegistryService> shared_ptr;
    /** In GlobalService; made if there is none. */
    static shared_ptr Instance();
    explicit ROSServiceRegistryService(RTT::TaskContext* owner = nullptr);

    /** Takes ownership. Replaces a factory of that type, which stays alive for those who use it. False for null. */
    bool registerServiceFactory(ROSServiceProxyFactoryBase* factory);
    /** Is this type, such as "std_srvs/Empty", known? */
    bool hasServiceFactory(const std::string& service_type);
    /** Null, with an error logged that names the package to import, if it is unknown. Lives as long as the process. */
    ROSServiceProxyFactoryBase* getServiceFactory(const std::string& service_type);
    /** All types that are known, in alphabetical order. Also logs them. */
    std::vector<std::string> listSrvs();
};

typedef ROSServiceRegistryService::shared_ptr ROSServiceRegistryServicePtr;

}  // namespace rtt_roscomm

// As in versions before 2.10.
using rtt_roscomm::ROSServiceRegistryService;
using rtt_roscomm::ROSServiceRegistryServicePtr;

#endif
