#pragma once
#include "../first.hpp"
namespace two_headers { struct Second { First first; unsigned long long big; }; }
