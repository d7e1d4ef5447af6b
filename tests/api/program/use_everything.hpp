// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What components use without including it. No header of a test library here: that would bring the standard headers along.
// Included after the header whose closure is tried; PART names the place.
#ifndef ORO_API_USE_EVERYTHING_HPP
#define ORO_API_USE_EVERYTHING_HPP

namespace PART {

using namespace RTT;

class Component : public RTT::TaskContext {
    std::string text;
    std::vector<double> values;
    std::map<std::string, int> table;
    InputPort<double> in;
    OutputPort<double> out;
    OperationCaller<double(double)> caller;
    Property<double> gain;
    PropertyBag bag;
    Attribute<int> count;
    boost::shared_ptr<int> shared;
    boost::function<void(base::PortInterface*)> function;
    ConnPolicy policy;
    os::Mutex mutex;
    os::TimeService::ticks ticks;
    boost::shared_ptr<ServiceRequester> requester;

public:
    int called;
    Component(std::string const& name)
        : TaskContext(name, PreOperational),
          in("in"),
          out("out"),
          caller("twice"),
          gain("gain", "a gain", 2.0),
          count("count", 0),
          shared(new int(5)),
          policy(ConnPolicy::buffer(3)),
          ticks(os::TimeService::Instance()->getTicks()),
          called(0) {
        function = boost::bind(&Component::onData, this, _1);
        addEventPort(in, function);
        addPort(out);
        addProperty(gain);
        addAttribute(count);
        addOperation("twice", &Component::twice, this, OwnThread).doc("Doubles.").arg("x", "what");
        requires_("peer")->addOperationCaller(caller);
#if __cplusplus < 202002L
        requester = this->requires("peer");
#else
        requester = this->requires_("peer");
#endif
    }
    double twice(double x) { return 2 * x; }
    void onData(base::PortInterface*) { ++called; }

    /** The number of what is wrong. */
    int check() {
        assert(shared);
        char raw[8];
        memset(raw, 0, sizeof(raw));
        memcpy(raw, "abc", 3);
        if (strcmp(raw, "abc") != 0) return 1;
        std::stringstream stream;
        stream << sqrt(4.0) << std::sqrt(9.0) << fabs(-1.0) << pow(2.0, 3) << (sin(0.0) + cos(0.0));
        if (stream.str() != "23181") return 2;
        snprintf(raw, sizeof(raw), "%d", 12);
        if (std::string(raw) != "12") return 3;
        {
            os::MutexLock lock(mutex);
            usleep(10);
            sleep(0);
        }
        table["x"] = 1;
        values.push_back(gain.get());
        bag.add(&gain);
        if (table.size() != values.size() || bag.size() != 1) return 4;
        if (!requester->connectTo(this->provides()) || !caller.ready()) return 5;
        caller.setCaller(this->engine());
        if (caller(1.5) != 3.0) return 6;
        if (!out.connectTo(&in, policy)) return 7;
        if (!this->setActivity(new Activity(0, 0.0, 0, "mine"))) return 8;
        if (os::TimeService::Instance()->secondsSince(ticks) < 0) return 9;
        log(Debug) << "checked " << this->getName() << endlog();
        RTT::Logger::In in_log("check");
        std::cout << getName() << " " << fixedText() << std::endl;
        return 0;
    }
    std::string fixedText() { return text.empty() ? "ok" : text; }
};

}  // namespace PART

#endif
