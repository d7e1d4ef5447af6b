#pragma once
#include <tank/PlantBase.hpp>

namespace tank {
class Plant : public PlantBase
{
      public:
	explicit Plant( const std::string& name ) : PlantBase( name ) {}

	void drain() override {
	}
};
}
