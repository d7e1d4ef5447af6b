#ifndef PAIR_SINK_HPP
#define PAIR_SINK_HPP

#include <pair/SinkBase.hpp>

namespace pair {

/// Ports, properties and attributes are members of the base class: SinkBase, generated from pair.xml.
class Sink : public SinkBase {
public:
    explicit Sink(const std::string& name);
    ~Sink() override;

    /// Sum of all values so far.
    double sum() override;

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;
};

}  // namespace pair

#endif
