#include "Plant.hpp"

namespace tank
{
Plant::Plant( const std::string& name ) : RTT::TaskContext( name )
{
}

void Plant::drain() { gain=0; }

void Plant::updateHook()
{
}
}