// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Everything that a constructor can do and --describe has to understand; what it cannot is not in here.
#include <rtt/RTT.hpp>
#include <rtt/Component.hpp>
#include <boost/bind/bind.hpp>
#include <array>
#include <memory>

namespace tricky {

enum class Mode { Idle, Fast };
enum Old { Left, Right };
struct Pose {
    double x = 1, y = 2;
};

/// A base that others share.
class Base : public RTT::TaskContext {
protected:
    explicit Base(const std::string& name, TaskState initial = PreOperational) : RTT::TaskContext(name, initial) {
        addProperty("verbose", verbose_).doc("prints more");
        init();
    }
    virtual void init() { addAttribute("fromBase", fromBase_); }
    void addIn(const std::string& name, RTT::base::InputPortInterface& port, const std::string& doc) {
        addEventPort(name, port).doc("input: " + doc);
    }
    bool verbose_ = false;
    int fromBase_ = 7;
};

void addOut(RTT::TaskContext& to, const char* name, RTT::base::PortInterface& port) { to.ports()->addPort(name, port); }

template <class T>
void tunable(RTT::TaskContext* to, const std::string& name, T& value, const char* doc = "to be tuned") {
    to->addProperty(name, value).doc(doc);
}

struct Io {
    RTT::InputPort<double> in{"io_in", RTT::ConnPolicy::buffer(8)};
    RTT::OutputPort<std::vector<double>> out{"io_out"};
    explicit Io(RTT::TaskContext* owner) {
        owner->addPort(in);
        owner->addPort(out).doc("of the io");
    }
};

/** The tricky one.
 *  It has everything. */
class Tricky : public Base {
public:
    ~Tricky() override {
        stop();
        delete raw_;
    }
    explicit Tricky(const std::string& name) : Base(name), op_("bound"), io_(this), gain_("gain", "a gain", 0.25f) {
        addIn("first", first_, "the first");
        addOut(*this, "second", second_);
        for (int i = 0; i < 3; ++i)
            addPort("wheel" + std::to_string(i), wheels_[i]).doc("wheel number " + std::to_string(i + 1));
        int n = 0;
        for (auto& leg : legs_) {
            addPort("leg_" + std::to_string(++n), leg);
        }
        const struct {
            const char* name;
            double& value;
        } table[] = {{"kp", kp_}, {"ki", ki_}};
        for (const auto& row : table) addProperty(row.name, row.value);
        for (const char* word : {"a", "b"}) provides("words")->addOperation(word, [](int x) { return x; });
        tunable(this, "mode", mode_);
        tunable(this, "side", side_, "left or right");
        tunable(this, "list", list_);
        addProperty("pose", pose_);
        addProperty("label", label_)
            .doc(
                "a "
                "label");
        addProperty(gain_);
        addConstant("answer", 42);
        addConstant("limit", kLimit);
        addAttribute("big", big_);
        op_.calls(&Tricky::bound, this, RTT::OwnThread);
        addOperation(op_).doc("bound later").arg("what", "it is");
        addOperation("binds",
                     boost::function<double(double)>(boost::bind(&Tricky::scale, this, boost::placeholders::_1, 2.0)))
            .doc("with boost::bind");
        addOperation("free", &Tricky::twice);
        auto inner = provides("outer")->provides("inner");
        inner->doc("nested");
        inner->addOperation("deep", &Tricky::scale, this).doc("deep down").arg("a", "1").arg("b", "2");
        inner->addProperty("depth", depth_);
        auto add = [&](const char* n, auto& p) { addPort(n, p); };
        add("lambda", lambda_);
        heap_ = std::make_unique<RTT::OutputPort<int>>("heap");
        addPort(*heap_);
        raw_ = new RTT::InputPort<unsigned char>("raw");
        ports()->addPort(*raw_);
        requires("arm")->addOperationCaller(caller_);
        setActivity(new RTT::Activity(ORO_SCHED_RT, 12, 0.02, 0, getName()));
        kp_ = 3 * 0.5;
        configure();
        label_ += " of it";
        if (kLimit > 3) addPort("always", always_);
    }

private:
    void init() override { Base::init(); }
    bool configureHook() override {
        addProperty("own", own_);  // as the constructor calls configure()
        return own_ == 4;          // so that it is as it was made
    }
    void updateHook() override {}
    static int twice(int x) { return 2 * x; }
    double scale(double a, double b) { return a * b; }
    bool bound(const std::string& what) { return !what.empty(); }
    static constexpr int kLimit = 4;

    RTT::Operation<bool(const std::string&)> op_;
    RTT::InputPort<double> first_;
    RTT::OutputPort<std::string> second_;
    RTT::OutputPort<float> wheels_[3];
    std::array<RTT::InputPort<std::uint8_t>, 2> legs_;
    RTT::InputPort<Pose> lambda_;
    RTT::OutputPort<bool> always_;
    std::unique_ptr<RTT::OutputPort<int>> heap_;
    RTT::InputPort<unsigned char>* raw_;
    RTT::OperationCaller<void(int, const std::string&)> caller_{"grip"};
    Io io_;
    double kp_ = 1.5e-3, ki_ = 1;
    Mode mode_ = Mode::Fast;
    Old side_ = Right;
    std::vector<double> list_{1, 2.5};
    Pose pose_;
    std::string label_ = "name";
    RTT::Property<float> gain_;
    std::uint64_t big_ = 18446744073709551615ull;
    int depth_ = -4, own_ = 3;
};

}  // namespace tricky
ORO_CREATE_COMPONENT(tricky::Tricky)
