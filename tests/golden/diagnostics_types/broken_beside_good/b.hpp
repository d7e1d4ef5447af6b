#pragma once
#include "not_there_either.hpp"
struct Good { int x; };
struct Bad { int* p; };
