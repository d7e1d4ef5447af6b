#include <string>

#include <rtt/RTT.hpp>
#include <rtt/plugin/ServicePlugin.hpp>

/// loadService("my_pkg_service") adds it to a component.
class My_pkgService : public RTT::Service {
public:
    /// `owner` is the component; null where only the interface is asked for.
    explicit My_pkgService(RTT::TaskContext* owner) : RTT::Service("my_pkg_service", owner) {
        this->doc("A service of the package my-pkg.");
        this->addOperation("getOwnerName", &My_pkgService::getOwnerName, this).doc("Name of the component that loaded the service.");
    }

    std::string getOwnerName() const { return this->getOwner()->getName(); }
};

ORO_SERVICE_NAMED_PLUGIN(My_pkgService, "my_pkg_service")
