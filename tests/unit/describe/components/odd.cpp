// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// More that --describe has to understand: what is seldom written, but can be.
#include <rtt/RTT.hpp>
#include <rtt/Component.hpp>
#include <boost/bind/bind.hpp>
#include <boost/make_shared.hpp>
#include <functional>

using namespace Orocos;

namespace odd {
typedef std::vector<double> Samples;
struct Limits {
    double low = -1;
    double high = 1;
};
#define PORT_NAME "macro_port"

class Helper : public RTT::Service {
public:
    Helper(TaskContext* owner, const std::string& name) : RTT::Service(name, owner) {
        addOperation("help", &Helper::help, this).doc("helps");
        addProperty("level", level_);
    }
    int help() const noexcept { return level_; }
    int level_ = 5;
};

template <class T>
class Generic : public TaskContext {
public:
    explicit Generic(const std::string& name) : TaskContext(name), prop_("prop", "of T", T(3)) {
        ports()
            ->addEventPort("cb", cb_, boost::bind(&Generic::onData, this, boost::placeholders::_1))
            .doc("calls back");
        properties()->addProperty(prop_);
    }
    void onData(base::PortInterface*) {}
    InputPort<T> cb_;
    Property<T> prop_;
};

class Odd : public TaskContext {
public:
    Odd(std::string const& n)
        : TaskContext(n, TaskContext::PreOperational),
          samples("samples", "three", Samples(3, 0.5)),
          attr("attr", 3.5),
          cons("cons", "fixed"),
          none("none"),
          macro(PORT_NAME) {
        addProperty(samples);
        addAttribute(attr);
        addConstant(cons);
        attributes()->addAttribute("limits", limits);
        addPort(macro);
        addPort(none).doc(std::string("docs of ") + PORT_NAME);
        int i = 0;
        while (i < 2) {
            addPort("w" + std::to_string(i), w[i]);
            ++i;
        }
        do {
            addPort("never", never);
        } while (false);
        switch (i) {
            case 2: addAttribute("switched", i2); break;
            default: break;
        }
        addOperation("overloaded", static_cast<int (Odd::*)(int)>(&Odd::over), this).arg("a", "b");
        addOperation("named", &Odd::named, this);
        addOperation("fn", std::function<bool(const Samples&)>([](const Samples& s) { return s.empty(); }));
        addOperation("fp", fp_);
        provides()->addService(boost::make_shared<Helper>(this, "helper"));
        Service::shared_ptr made(new Service("made", this));
        made->addAttribute("x", i2);
        provides()->addService(made);
        RTT::Service::shared_ptr created = RTT::Service::Create("created", this);
        created->addAttribute("y", i2);
        ConnPolicy p = ConnPolicy::buffer(7);
        p.init = true;
        delayed = new InputPort<int>("delayed", p);
        addPort(*delayed);
        setPeriod(0.5);
        if (n.empty() || true) addPort("orred", orred);
        std::vector<std::pair<std::string, double*>> all = {{"ma", &ma}, {"mb", &mb}};
        for (auto& one : all) addProperty(one.first, *one.second);
        [this] { addProperty("iife", ma); }();
        auto& r = addOperation("ref", &Odd::named, this);
        r.doc("by reference");
        getPort("none")->doc("found again");
        ma = 2 > 1 ? 7 : 8;
    }
    ~Odd() override {
        stop();
        delete delayed;
    }
    int over(int) { return 1; }
    double over(double) { return 1; }
    const std::string& named() const { return getName(); }
    static int free(int value) { return value; }
    int (*fp_)(int) = &Odd::free;
    Property<Samples> samples;
    Attribute<double> attr;
    Constant<std::string> cons;
    InputPort<int> none;
    OutputPort<Samples> macro;
    OutputPort<int> w[2], never, orred;
    InputPort<int>* delayed;
    Limits limits = {-2, 2};
    int i2 = 1;
    double ma = 1, mb = 2;
    struct Inner : TaskContext {
        explicit Inner(const std::string& n) : TaskContext(n) {}
    };
};
}  // namespace odd
ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(odd::Odd)
ORO_LIST_COMPONENT_TYPE(odd::Generic<double>)
ORO_LIST_COMPONENT_TYPE(odd::Odd::Inner)
