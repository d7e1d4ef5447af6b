#include <rtt/RTT.hpp>

namespace tank {

class Plant : public RTT::TaskContext {
public:
    Plant(const std::string& name) : RTT::TaskContext(name) {
        addPort("level", level_).doc("My level");
        addProperty("gain", gain_)
            .doc("How "
                 "much");  // tuned
        addProperty("size", size_).doc(std::string("computed"));
        addOperation("run", &Plant::run, this)
            .doc("Runs")
            .arg("fast", "Hurry")  // yes
            .arg("far", "My words");
        addOperation("go", &Plant::go, this);
        addOperation("rest", &Plant::rest, this).doc("Sleeps");
    }
    void run(bool fast, int far) {}
    void go() {}
    void rest() {}

private:
    RTT::OutputPort<double> level_;
    double gain_ = 1, size_ = 2;
};

}  // namespace tank
