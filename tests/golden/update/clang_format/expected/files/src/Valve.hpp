#ifndef TANK_VALVE_HPP
#define TANK_VALVE_HPP

#include <tank/ValveBase.hpp>

namespace tank
{

/// Ports, properties and attributes are members of the base
/// class: ValveBase, generated from tank.xml.
class Valve : public ValveBase
{
  public:
    explicit Valve(const std::string& name);
    ~Valve() override;

    void open() override;

  protected:
    bool configureHook() override;
    bool startHook() override;
    void updateHook() override;
    void stopHook() override;
    void cleanupHook() override;
};

} // namespace tank

#endif
