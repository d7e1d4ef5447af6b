#include <classic/classic-types.hpp>
#include "include/user/user-types.hpp"
#include <rtt/RTT.hpp>
#include <rtt/Component.hpp>
class User : public RTT::TaskContext {
public:
    explicit User(const std::string& name) : RTT::TaskContext(name) {
        addPort("map", map_);
        addProperty("start", start_);
    }
private:
    RTT::OutputPort<user::Map> map_;
    user::Map start_;
};
ORO_CREATE_COMPONENT(User)
