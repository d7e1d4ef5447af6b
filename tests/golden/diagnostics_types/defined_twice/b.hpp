#pragma once
namespace bad {
struct Pose { float x, y; };
struct Fine { int a; };
}
