#include "Plant.hpp"

using namespace tank::models;

Plant::Plant( const std::string& name )
  : PlantBase( name )
{
}

// Fills.
int Plant::fill( double litres )
{
  const char* text = "} {";
  return text[0] + int( litres );
}

#ifdef TRACE
void Plant::trace()
{
}
#endif

void
Plant::updateHook()
{
  // {
}
