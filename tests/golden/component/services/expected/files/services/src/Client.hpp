#ifndef SERVICES_CLIENT_HPP
#define SERVICES_CLIENT_HPP

#include <services/ClientBase.hpp>

namespace services {

/// Ports, properties and attributes are members of the base class: ClientBase, generated from services.xml.
class Client : public ClientBase {
public:
    explicit Client(const std::string& name);
    ~Client() override;

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;
};

}  // namespace services

#endif
