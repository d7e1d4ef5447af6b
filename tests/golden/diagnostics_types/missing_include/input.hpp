#pragma once
#include "not_there.hpp"
struct After { int x; };
