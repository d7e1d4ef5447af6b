#pragma once
#include <string>
namespace bad {
#pragma pack(push, 1)
struct Packed { char head; std::string text; };
#pragma pack(pop)
}
