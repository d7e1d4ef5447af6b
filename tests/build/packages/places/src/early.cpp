// Made before the typekit; needs its headers, not its library.
#include <places/root-types.hpp>
#include <rtt/Component.hpp>
#include <rtt/TaskContext.hpp>
class Early : public RTT::TaskContext {
public:
    explicit Early(const std::string& name) : TaskContext(name) { root.a = 0; }
    places::Root root;
};
ORO_CREATE_COMPONENT(Early)
