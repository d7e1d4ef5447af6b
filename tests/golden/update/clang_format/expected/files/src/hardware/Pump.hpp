#pragma once
#include <tank/PumpBase.hpp>

namespace tank {
class Pump : public PumpBase {
  public:
	explicit Pump(const std::string& name) : PumpBase(name) {}

    /// Runs at a speed.
    bool run(double /*speed*/) override
    {
      return true;
    }
	void halt( ) override {}

  protected:
    void updateHook() override
    {
      // One step: read inputs, compute, write outputs. Runs
      // in the component's thread; keep it free of blocking
      // calls.
    }
};
}
