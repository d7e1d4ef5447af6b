#pragma once
namespace needy {
using Metres = double;
enum class Frame { World, Tool };
}
