#pragma once
#include "not_there.hpp"
struct FromMissing { Missing m; int* hidden; };
struct InBroken { int& r; };
struct Open { int x;
