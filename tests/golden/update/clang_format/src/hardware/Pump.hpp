#pragma once
#include <tank/PumpBase.hpp>

namespace tank {
class Pump : public PumpBase {
  public:
	explicit Pump(const std::string& name) : PumpBase(name) {}
	void halt( ) override {}
};
}
