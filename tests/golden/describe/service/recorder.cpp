#include <rtt/RTT.hpp>
#include <rtt/plugin/ServicePlugin.hpp>

namespace tape {

class Recorder : public RTT::Service {
public:
    explicit Recorder(RTT::TaskContext* owner) : RTT::Service("recorder", owner), input_("input") {
        doc("Records what arrives.");
        addPort(input_);
        addOperation("record", &Recorder::record, this).doc("begins").arg("file", "where to write");
        addAttribute("count", count_);
    }

private:
    bool record(const std::string&) { return true; }
    RTT::InputPort<double> input_;
    int count_ = 0;
};

}  // namespace tape

ORO_SERVICE_NAMED_PLUGIN(tape::Recorder, "recorder")
