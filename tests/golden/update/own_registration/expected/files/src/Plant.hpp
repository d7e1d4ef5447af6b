#include <rtt/RTT.hpp>

namespace tank {

class Plant : public RTT::TaskContext {
public:
    Plant(std::string const& name)
        : RTT::TaskContext(name), m_level("level") {
        ports()->addPort(m_level).doc("The level");
        ports()->addPort("old", m_old);
        ports()->addEventPort("valve", m_valve).doc("Set by the controller");
        addProperty("gain", m_gain).doc("How much");  // tuned by hand
        addProperty("samples", m_samples).doc("How many");
        addOperation("run", &Plant::run, this);
        addAttribute("count", m_count);
        addOperation("reset", &Plant::reset, this, RTT::ClientThread).doc("Begins again").arg("hard", "All of it");
    }

    /// Begins again
    bool reset(bool /*hard*/) {
        return true;
    }
    void run() {}

private:
    virtual void updateHook() { m_level.write(m_gain); }

    virtual bool startHook() {
        // Prepare for updateHook(). False keeps the component stopped.
        return true;
    }
    RTT::OutputPort<double> m_level, m_old;
    RTT::InputPort<int> m_valve;  ///< Set by the controller
    float m_gain;  ///< how much
    int m_samples = 3;  ///< How many
    int m_count{};
};

}  // namespace tank
