#include <rtt/RTT.hpp>

namespace tank {

class Plant : public RTT::TaskContext {
public:
    Plant(const std::string& name) : RTT::TaskContext(name) {
        addEventPort("level", level_).doc("The \"height\"");
        addProperty("gain", gain_)
            .doc("How much more");  // tuned
        addProperty("size", size_).doc(std::string("computed"));
        addOperation("run", &Plant::run, this, RTT::OwnThread)
            .doc("Runs")
            .arg("steps", "How many")  // yes
            .arg("far", "In km")
            .arg("last", "");
        addOperation("go", &Plant::go, this).doc("Goes");
        addOperation("rest", &Plant::rest, this).doc("Mine");
    }
    void run(int /*steps*/, int far, bool /*last*/) {}
    void go() {}
    void rest() {}

private:
    RTT::InputPort<double> level_;
    double gain_ = 1, size_ = 2;
};

}  // namespace tank
