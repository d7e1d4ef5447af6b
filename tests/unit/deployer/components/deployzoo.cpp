// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component with something of everything that deployment files can name.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <rtt/types/SequenceTypeInfo.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/Types.hpp>

#include <boost/serialization/nvp.hpp>

#include <string>
#include <vector>

namespace zoo {

struct Gains {
    double kp = 0, ki = 0;

    template <class Archive>
    void serialize(Archive& archive, unsigned) {
        archive& boost::serialization::make_nvp("kp", kp);
        archive& boost::serialization::make_nvp("ki", ki);
    }
};

struct Control {
    Gains gains;
    std::vector<Gains> axes;

    template <class Archive>
    void serialize(Archive& archive, unsigned) {
        archive& boost::serialization::make_nvp("gains", gains);
        archive& boost::serialization::make_nvp("axes", axes);
    }
};

/** With the library, as that of a typekit would: files are read before there are components. */
const bool typesAreThere = [] {
    const auto types = RTT::types::Types();
    types->addType(new RTT::types::StructTypeInfo<Gains>("zoo.Gains"));
    types->addType(new RTT::types::SequenceTypeInfo<std::vector<Gains>>("zoo.Gains[]"));
    types->addType(new RTT::types::StructTypeInfo<Control>("zoo.Control"));
    return true;
}();

class Robot : public RTT::TaskContext {
public:
    explicit Robot(const std::string& name) : RTT::TaskContext(name, PreOperational), joints_(2, 0.0) {
        addSimpleProperties();
        addProperty("joints", joints_);
        addProperty("frames", frames_);
        limits_.ownProperty(new RTT::Property<double>("lower", "", -1));
        limits_.ownProperty(new RTT::Property<double>("upper", "", 1));
        RTT::PropertyBag home;
        home.ownProperty(new RTT::Property<int>("tries", "", 3));
        limits_.ownProperty(new RTT::Property<RTT::PropertyBag>("home", "", home));
        addProperty("limits", limits_);
        addAttribute("configured", configured_);
        addAttribute("started", started_);
        addPorts();
        addOperation("add", &Robot::add, this);
        requires_("math")->addOperationCaller(add_);
        provides("math")->addOperation("add", &Robot::add, this);
    }

protected:
    bool configureHook() override { return ++configured_ != 0 && fail_ != "configure"; }
    bool startHook() override { return ++started_ != 0 && fail_ != "start"; }
    void updateHook() override {}

private:
    void addSimpleProperties() {
        addProperty("flag", flag_);
        addProperty("count", count_);
        addProperty("index", index_);
        addProperty("gain", gain_);
        addProperty("ratio", ratio_);
        addProperty("letter", letter_);
        addProperty("octet", octet_);
        addProperty("label", label_);
        addProperty("big", big_);
        addProperty("huge", huge_);
        addProperty("fail", fail_);
    }

    void addPorts() {
        addPort("out", out_);
        addPort("in", in_);
        addEventPort("event", event_);
        addPort("num_out", numOut_);
        addPort("num_in", numIn_);
        addPort("vec_out", vecOut_);
        addPort("vec_in", vecIn_);
        provides("arm")->addPort("command", command_);
        provides("arm")->addProperty("stiffness", stiffness_);
        provides("arm")->provides("wrist")->addPort("angle", angle_);
    }

    double add(double a, double b) { return a + b; }

    bool flag_ = false;
    int count_ = 0;
    unsigned index_ = 0;
    double gain_ = 0, stiffness_ = 0;
    float ratio_ = 0;
    char letter_ = 'a';
    unsigned char octet_ = 'a';
    std::string label_ = "label", fail_;
    long long big_ = 0;
    unsigned long long huge_ = 0;
    std::vector<double> joints_;
    std::vector<std::string> frames_;
    RTT::PropertyBag limits_;
    int configured_ = 0, started_ = 0;
    RTT::OutputPort<double> out_, angle_;
    RTT::InputPort<double> in_, event_, command_;
    RTT::OutputPort<int> numOut_;
    RTT::InputPort<int> numIn_;
    RTT::OutputPort<std::vector<double>> vecOut_;
    RTT::InputPort<std::vector<double>> vecIn_;
    RTT::OperationCaller<double(double, double)> add_{"add"};
};

/** One more property, with members. */
class Controlled : public Robot {
public:
    explicit Controlled(const std::string& name) : Robot(name) { addProperty("control", control_); }

private:
    Control control_;
};

}  // namespace zoo

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(zoo::Robot)
ORO_LIST_COMPONENT_TYPE(zoo::Controlled)
