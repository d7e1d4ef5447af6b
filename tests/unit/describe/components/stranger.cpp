// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components as control engineers write them: containers of ports, macros, helper objects, names put together.
#include <rtt/RTT.hpp>
#include <rtt/Component.hpp>
#include <boost/bind/bind.hpp>
#include <boost/function.hpp>
#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <vector>

using namespace RTT;

namespace robot {

// 1: names in a std::vector, ports in a std::vector that is resized.
class Wheels : public TaskContext {
public:
    explicit Wheels(const std::string& name) : TaskContext(name, PreOperational) {
        std::vector<std::string> names;
        names.push_back("left");
        names.push_back("right");
        names.emplace_back("rear");
        speeds_.resize(names.size());
        for (std::size_t i = 0; i < names.size(); ++i)
            addPort(names[i] + "_speed", speeds_[i]).doc("of " + names.at(i));
        for (const std::string& one : names) addProperty(one + "_gain", gains_[one]);
        for (auto it = names.begin(); it != names.end(); ++it) addAttribute(*it + "_seen", seen_);
    }
    bool configureHook() override { return true; }

private:
    std::deque<OutputPort<double>> speeds_;
    std::map<std::string, double> gains_;
    int seen_ = 0;
};

// 2: ports made by new and unique_ptr, kept in containers.
class Pool : public TaskContext {
public:
    explicit Pool(const std::string& name) : TaskContext(name) {
        for (int i = 0; i < 2; ++i) {
            raw_.push_back(new InputPort<int>("raw" + std::to_string(i)));
            addPort(*raw_.back()).doc("raw");
            owned_.push_back(std::make_unique<OutputPort<int>>("owned" + std::to_string(i)));
            addPort(*owned_.back());
            shared_.emplace_back(new OutputPort<float>());
            addPort("shared" + std::to_string(i), *shared_[static_cast<std::size_t>(i)]);
        }
        for (auto& one : late_) one = std::make_unique<InputPort<double>>();
        addPort("late_a", *late_[0]);
        addEventPort("late_b", *late_[1], boost::bind(&Pool::arrived, this, boost::placeholders::_1));
    }
    ~Pool() override {
        stop();
        ports()->clear();
        for (auto* one : raw_) delete one;
    }
    void arrived(base::PortInterface*) {}

private:
    std::vector<InputPort<int>*> raw_;
    std::vector<std::unique_ptr<OutputPort<int>>> owned_;
    std::vector<std::shared_ptr<OutputPort<float>>> shared_;
    std::unique_ptr<InputPort<double>> late_[2];
};

// 3: a map from names to ports.
class Mapped : public TaskContext {
public:
    explicit Mapped(const std::string& name) : TaskContext(name) {
        addPort("x", ports_["x"]);
        addPort("y", ports_["y"]).doc("the y");
        addEventPort(events_["e"] = "event_in", event_);
    }

private:
    std::map<std::string, OutputPort<double>> ports_;
    std::map<std::string, std::string> events_;
    InputPort<double> event_;
};

// 4: macros.
#define ADD_PORT(name) addPort(#name, name##_port_).doc("port " #name)
#define DECLARE_IN(type, name) InputPort<type> name##_port_
#define ADD_OP(klass, name) this->addOperation(#name, &klass::name, this, OwnThread).doc("operation " #name)
class Macros : public TaskContext {
public:
    explicit Macros(const std::string& name) : TaskContext(name) {
        ADD_PORT(position);
        ADD_PORT(velocity);
        ADD_OP(Macros, reset);
        ADD_OP(Macros, move).arg("to", "where [m]");
    }
    void reset() {}
    bool move(double) { return true; }

private:
    DECLARE_IN(double, position);
    DECLARE_IN(float, velocity);
};

// 5: CRTP and template bases, a base's hook for adding things.
template <class Derived, class Command>
class Drive : public TaskContext {
public:
    explicit Drive(const std::string& name) : TaskContext(name), command_("command"), limit_(Derived::kLimit) {
        this->ports()->addPort(command_).doc("for " + std::string(Derived::kName));
        this->addProperty("limit", limit_).doc(std::string(Derived::kName) + " limit [rad/s]");
        this->addConstant("axes", Derived::kAxes);
    }

protected:
    InputPort<Command> command_;
    double limit_;
};
class Servo : public Drive<Servo, std::vector<double>> {
public:
    static constexpr double kLimit = 2.5;
    static constexpr int kAxes = 6;
    static constexpr const char* kName = "servo";
    explicit Servo(const std::string& name) : Drive(name) { setup(); }

private:
    void setup() {
        static const char* const kNames[] = {"a", "b"};
        for (unsigned i = 0; i != sizeof(kNames) / sizeof(kNames[0]); ++i)
            this->provides("axis")->provides(kNames[i])->addProperty("offset", offsets_[i]).doc("of axis");
        std::for_each(std::begin(kNames), std::end(kNames),
                      [this](const char* one) { this->addAttribute(std::string("each_") + one, each_); });
    }
    double offsets_[2] = {0.5, -0.5};
    int each_ = 4;
};

// 6: lambdas and boost::function as operations; operations objects in a container.
class Calls : public TaskContext {
public:
    explicit Calls(const std::string& name)
        : TaskContext(name), op_("member_op", &Calls::sum, this, OwnThread, engine()) {
        addOperation("lambda", boost::function<double(double)>([this](double x) { return x * scale_; }), ClientThread)
            .doc("scales")
            .arg("x", "what");
        addOperation("raw_lambda",
                     [this](const std::string& text, int n) { return text.size() + static_cast<std::size_t>(n); });
        addOperation("both", &Calls::both);
        addOperation(op_).doc("member").arg("a", "1").arg("b", "2");
        provides("service")->addOperation("deep", &Calls::sum, this).doc("in service");
        provides("service")->doc("a service");
        provides("service")->addPort("sport", sport_);
        auto reg = [this](const std::string& n,
                          double (Calls::*f)(double, double)
                              const) -> Operation<double(double, double)>& { return addOperation(n, f, this); };
        reg("via", &Calls::csum).doc("registered").arg("l", "left").arg("r", "right");
        auto svc = provides("motor");
        for (auto n : {"start", "stop"}) svc->addOperation(n, &Calls::go, this, OwnThread);
    }
    static int both(int a, int b) { return a + b; }
    double sum(double a, double b) { return a + b; }
    double csum(double a, double b) const { return a + b; }
    void go() {}

private:
    Operation<double(double, double)> op_;
    OutputPort<int> sport_;
    double scale_ = 2;
};

// 7: names from streams and strings that grow.
class Named : public TaskContext {
public:
    explicit Named(const std::string& name) : TaskContext(name) {
        std::ostringstream out;
        out << "joint" << 3;
        addPort(out.str(), z_);
        addProperty(std::string("fixed") + '_' + "name", fixed_);
        std::string built("pre");
        built.append("_").append("fix");
        addAttribute(built, fixed_);
        addAttribute(std::string("abc").substr(1), fixed_);
    }

private:
    OutputPort<double> z_;
    double fixed_ = 1;
};

// 8: a helper object that holds the component, a function object that is called at once.
class Diagnostics {
public:
    explicit Diagnostics(TaskContext* owner) : owner_(owner) {}
    void install() { owner_->addPort("diagnostics", out_).doc("of the helper"); }

private:
    TaskContext* owner_;
    OutputPort<std::string> out_;
};
class Helped : public TaskContext {
public:
    explicit Helped(const std::string& name) : TaskContext(name), diagnostics_(this) {
        diagnostics_.install();
        installer_ = [this] { addPort("from_lambda", lambda_); };
        installer_();
    }

private:
    Diagnostics diagnostics_;
    std::function<void()> installer_;
    OutputPort<int> lambda_;
};

// 9: defaults from constructor arguments, structs, delegating constructors.
struct Config {
    double rate = 10;
    std::string frame = "base";
    std::vector<double> gains = {1, 2, 3};
};
class Configured : public TaskContext {
public:
    explicit Configured(const std::string& name) : Configured(name, 50, Config()) {}
    Configured(const std::string& name, int rate, const Config& config)
        : TaskContext(name), rate_(rate), period_(1.0 / rate), config_(config), frame_("frame", "which", config.frame) {
        addProperty("rate", rate_);
        addProperty("period", period_).doc("[s]");
        addProperty("gains", config_.gains);
        addProperty("config_rate", config_.rate);
        addProperty(frame_);
        frame_.set("map");
        setPeriod(period_);
        if (rate > 20)
            addPort("fast", fast_);
        else
            addPort("slow", fast_);
    }

private:
    int rate_;
    double period_;
    Config config_;
    Property<std::string> frame_;
    OutputPort<double> fast_;
};

// 10: multiple inheritance with a mixin.
class Logged {
protected:
    void addLog(TaskContext& to) { to.addPort("log", log_).doc("text"); }
    OutputPort<std::string> log_;
};
class Mixed : public TaskContext, protected Logged {
public:
    explicit Mixed(const std::string& name) : TaskContext(name) {
        addLog(*this);
        TaskContext* self = this;
        self->addProperty("self", value_);
        auto& me = *this;
        me.addProperty("me", value_);
        Service::shared_ptr s = this->provides();
        s->addProperty("svc", value_);
        tuple();
        try {
            addAttribute("tried", value_);
        } catch (...) {
        }
    }

private:
    void tuple() {
        std::array<std::pair<const char*, OutputPort<int>*>, 2> all = {{{"ta", &a_}, {"tb", &b_}}};
        for (auto& [name, port] : all) addPort(name, *port).doc(name);
    }
    double value_ = 1;
    OutputPort<int> a_, b_;
};

// 11: property bags and property vectors.
class Bags : public TaskContext {
public:
    explicit Bags(const std::string& name)
        : TaskContext(name), bag_("bag", "a bag"), gains_(3, 0.25), text_("t", "a text", "hello") {
        addProperty(bag_);
        addProperty("gains", gains_).doc("each");
        addProperty(text_);
        addProperty("matrix", matrix_);
        this->properties()->ownProperty(new Property<int>("owned", "an owned one", 3));
        this->attributes()->setValue(new Attribute<int>("attr_new", 9));
        text_ = "bye";
    }

private:
    Property<PropertyBag> bag_;
    std::vector<double> gains_;
    Property<std::string> text_;
    std::vector<std::vector<double>> matrix_{{1, 0}, {0, 1}};
};

// 12: services and requesters of one's own.
class GripService : public Service {
public:
    GripService(TaskContext* owner) : Service("grip", owner) {
        addOperation("close", &GripService::close, this).doc("closes").arg("force", "[N]");
        addPort("state", state_);
        doc("the gripper");
    }
    bool close(double) { return true; }
    OutputPort<int> state_;
};
class ArmRequester : public ServiceRequester {
public:
    ArmRequester(TaskContext* owner) : ServiceRequester("arm", owner), move("move"), halt("halt") {
        addOperationCaller(move);
        addOperationCaller(halt);
    }
    OperationCaller<bool(double)> move;
    OperationCaller<void()> halt;
};
class Served : public TaskContext {
public:
    explicit Served(const std::string& name) : TaskContext(name), service_(new GripService(this)) {
        provides()->addService(service_);
        requires()->addServiceRequester(ServiceRequester::shared_ptr(new ArmRequester(this)));
        this->requires("plant")->addOperationCaller(open_);
    }

private:
    Service::shared_ptr service_;
    OperationCaller<void()> open_{"open"};
};

}  // namespace robot
ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(robot::Wheels)
ORO_LIST_COMPONENT_TYPE(robot::Pool)
ORO_LIST_COMPONENT_TYPE(robot::Mapped)
ORO_LIST_COMPONENT_TYPE(robot::Macros)
ORO_LIST_COMPONENT_TYPE(robot::Servo)
ORO_LIST_COMPONENT_TYPE(robot::Calls)
ORO_LIST_COMPONENT_TYPE(robot::Named)
ORO_LIST_COMPONENT_TYPE(robot::Helped)
ORO_LIST_COMPONENT_TYPE(robot::Configured)
ORO_LIST_COMPONENT_TYPE(robot::Mixed)
ORO_LIST_COMPONENT_TYPE(robot::Bags)
ORO_LIST_COMPONENT_TYPE(robot::Served)
