#include "Plant.hpp"

void tank::models::Plant::drain( double /*amount*/, bool slowly )
{
  (void)slowly;
}
