#include <rtt/RTT.hpp>

namespace tank {

class Plant : public RTT::TaskContext {
public:
    Plant(std::string const& name)
        : RTT::TaskContext(name), m_level("level") {
        ports()->addPort(m_level).doc("The level");
        ports()->addPort("old", m_old);
        addProperty("gain", m_gain).doc("How much");  // tuned by hand
        addOperation("run", &Plant::run, this);
    }
    void run() {}

private:
    virtual void updateHook() { m_level.write(m_gain); }
    RTT::OutputPort<double> m_level, m_old;
    double m_gain;  ///< how much
};

}  // namespace tank
