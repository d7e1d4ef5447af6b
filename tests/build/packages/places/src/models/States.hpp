#pragma once
#include "Sibling.hpp"
namespace places { enum class State { Off, On }; struct States { State now; Sibling s; }; }
