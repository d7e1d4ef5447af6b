// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MARSHALLING_SERVICE_HPP
#define ORO_MARSHALLING_SERVICE_HPP

#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <string>

namespace RTT {
namespace marsh {

/**
 * The service "marshalling" offers the functions of PropertyLoader as operations. They work on the properties of the
 * service into which it was loaded (normally the component itself) and of its sub-services. All run in the caller's
 * thread. If nothing was changed they return false and log the reasons; if a script calls, also the place of the call.
 */
class RTT_API MarshallingService : public Service {
public:
    typedef boost::shared_ptr<MarshallingService> shared_ptr;

    explicit MarshallingService(TaskContext* parent);
    ~MarshallingService() override;

    bool loadProperties(const std::string& filename);
    bool storeProperties(const std::string& filename);
    bool readProperties(const std::string& filename);
    bool readProperty(const std::string& name, const std::string& filename);
    bool updateProperties(const std::string& filename);
    bool writeProperties(const std::string& filename);
    bool writeProperty(const std::string& name, const std::string& filename);
    bool updateFile(const std::string& filename);

    bool loadServiceProperties(const std::string& filename, const std::string& servicename);
    bool storeServiceProperties(const std::string& filename, const std::string& servicename);
    bool readServiceProperties(const std::string& filename, const std::string& servicename);
    bool readServiceProperty(const std::string& name, const std::string& filename, const std::string& servicename);
    bool updateServiceProperties(const std::string& filename, const std::string& servicename);
    bool writeServiceProperties(const std::string& filename, const std::string& servicename);
    bool writeServiceProperty(const std::string& name, const std::string& filename, const std::string& servicename);
    bool updateServiceFile(const std::string& filename, const std::string& servicename);

private:
    /** The service that owns this one. */
    Service* target();
    /** A sub-service. Logs an error and returns null if there is none of that name. */
    Service* target(const std::string& servicename);
    void addWholeOperations();
    void addServiceOperations();
};

}  // namespace marsh
}  // namespace RTT

#endif
