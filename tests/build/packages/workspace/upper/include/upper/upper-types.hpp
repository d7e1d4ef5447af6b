#pragma once
#include <lower/typekit/Types.hpp>
namespace upper { struct Pair { lower::Sample first, second; }; }
