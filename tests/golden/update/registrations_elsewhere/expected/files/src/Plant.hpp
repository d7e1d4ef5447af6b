#include <rtt/RTT.hpp>

namespace tank {

class Pump : public RTT::TaskContext {
    RTT::OutputPort<double> out_;

public:
    Pump(const std::string& name) : RTT::TaskContext(name), out_("pressure") { addPort(out_); }
};

class Plant : public RTT::TaskContext {
public:
    Plant(const std::string& name) : RTT::TaskContext(name), out_("level") { setUp(); 
        this->addPort("flow", flow).doc("Through the valve");
        this->addProperty("force", force_).doc("Of */ all");
        this->provides("gripper")->addProperty("speed", gripper_speed);
    }
    void setUp() {
        addPort(out_).doc("The level");
        provides("gripper")->addProperty("force", force); addProperty("speed", speed);
        RTT::Service::shared_ptr arm = provides("arm");
        arm->addProperty("reach", reach);
    }

private:
    RTT::OutputPort<double> out_;
    RTT::InputPort<int> flow;  /**< Through the valve */ double force, speed; double reach;
    double force_{};  /**< Of * / all */
    int gripper_speed{}; bool other = true;
};

}  // namespace tank
