#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <rtt/internal/GlobalService.hpp>

namespace linked {
struct Shared : RTT::TaskContext {
    explicit Shared(const std::string& name) : RTT::TaskContext(name) {}
    bool startHook() override {
        if (!loadService("byhand")) return false;
        RTT::OperationCaller<int(int)> twice = provides("byhand")->getOperation("twice");
        RTT::OperationCaller<std::string()> greet =
            RTT::internal::GlobalService::Instance()->provides("linked.global")->getOperation("greet");
        std::cout << getName() << ": " << twice(21) << ", " << greet() << std::endl;
        return true;
    }
};
struct Other : RTT::TaskContext {
    explicit Other(const std::string& name) : RTT::TaskContext(name) {}
};
}  // namespace linked
ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(linked::Shared)
ORO_LIST_COMPONENT_TYPE(linked::Other)
