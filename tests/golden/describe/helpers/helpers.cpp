#include <rtt/RTT.hpp>

#include <array>

namespace {

void publish(RTT::TaskContext& component, const std::string& prefix, RTT::base::PortInterface& port) {
    component.addPort(prefix + "_out", port).doc("made by a helper");
}

struct Wheel {
    RTT::OutputPort<double> speed{"speed"};
    double radius = 0.25;
};

}  // namespace

class Base : public RTT::TaskContext {
protected:
    explicit Base(const std::string& name) : TaskContext(name) { addProperty("verbose", verbose_); }
    template <class T>
    void tunable(const char* name, T& value) {
        addProperty(name, value).doc("can be tuned");
    }
    bool verbose_ = true;
};

class Cart : public Base {
public:
    explicit Cart(const std::string& name) : Base(name) {
        publish(*this, "cart", state_);
        tunable("gain", gain_);
        int number = 0;
        for (Wheel& wheel : wheels_) {
            const std::string own = "wheel" + std::to_string(++number);
            addPort(own, wheel.speed);
            provides("of_" + own)->addProperty("radius", wheel.radius);
        }
        for (const char* side : {"left", "right"}) provides("lights")->provides(side)->doc(std::string(side) + " light");
        const auto add = [this](const char* name, auto function) { addOperation(name, function); };
        add("twice", [](int value) { return 2 * value; });
        requires("battery")->addOperationCaller(charge_);
        gain_ *= 3;
    }

private:
    RTT::OutputPort<int> state_;
    RTT::OperationCaller<double(const std::string&)> charge_{"charge"};
    std::array<Wheel, 2> wheels_;
    float gain_ = 0.1F;
};
