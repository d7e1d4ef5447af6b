#include "support.hpp"
#include <classic/classic-types.hpp>
#include <rtt/RTT.hpp>
#include <rtt/Component.hpp>
using namespace RTT;
using namespace Orocos;

class Classic : public RTT::TaskContext {
public:
    Classic(std::string const& name) : TaskContext(name, PreOperational), in("in"), out("out"), count(0), gain("gain", "Gain", 2.0) {
        addEventPort(in).doc("Tracks to shorten");
        addPort(out).doc("Shortened tracks");
        addPort("count", countPort);
        addProperty(gain);
        addProperty("track", track).doc("A track");
        addAttribute("count", count);
        addOperation("answer", &Classic::answer, this, OwnThread).doc("The answer").arg("plus", "added to it");
        this->provides("tools")->addOperation("half", &Classic::half, this, ClientThread);
    }
    bool configureHook() { Logger::In here(getName()); log(Info) << "configured with gain " << gain.get() << endlog(); return true; }
    bool startHook() { return true; }
    void updateHook() {
        classic::Track t;
        if (in.read(t) == NewData) {
            if (!t.points.empty()) t.points.pop_back();
            out.write(t);
            ++count;
            countPort.write(count);
        }
    }
private:
    int answer(int plus) { return classicAnswer() + plus; }
    double half(double x) { return x / 2; }
    RTT::InputPort<classic::Track> in;
    RTT::OutputPort<classic::Track> out;
    OutputPort<int> countPort;
    int count;
    Property<double> gain;
    classic::Track track;
};
ORO_CREATE_COMPONENT(Classic)
