#include "Plant.hpp"

using namespace tank::models;

Plant::Plant( const std::string& name )
  : PlantBase( name )
{
}

// Fills.
bool Plant::fill( double /*rate*/, double litres )
{
  const char* text = "} {";
  return text[0] + int( litres );
}

double Plant::sample()
{
  return {};
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

bool
Plant::startHook()
{
  // Prepare for updateHook(). False keeps the component stopped.
  return true;
}

void
Plant::stopHook()
{
  // Leave outputs in a safe state.
}
