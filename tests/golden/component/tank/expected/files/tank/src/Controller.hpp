#ifndef TANK_CONTROLLER_HPP
#define TANK_CONTROLLER_HPP

#include <tank/ControllerBase.hpp>

namespace tank {

/// Keeps the level at the set point.
/// Ports, properties and attributes are members of the base class: ControllerBase, generated from tank.xml.
class Controller : public ControllerBase {
public:
    explicit Controller(const std::string& name);
    ~Controller() override;

    bool reset(double level) override;

protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
};

}  // namespace tank

#endif
