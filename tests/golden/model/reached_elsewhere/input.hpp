#pragma once
#include "other/types.hpp"
namespace demo {
#ifndef __orogen
class Hidden { int* p; };
#endif
struct Uses { other::Point point; std::vector<other::Kind> kinds; };
}
