#include "Plant.hpp"
