#pragma once
#include "tyre.hpp"
namespace odd_files {
struct Wheel { Tyre tyre; };
}
