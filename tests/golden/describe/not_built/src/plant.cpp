#include "plant.hpp"
#include <plant/types.hpp>
