#include "Plant.hpp"

void tank::models::Plant::drain( std::string /*amount*/ )
{
  (void)slowly;
}
