#pragma once
// Cases 55, 59, 60 and 92 of the type matrix: names.
namespace names {
struct Awkward { int _a; int type; int end; int in; int sequence; int value; };
struct Pose { double x; };
struct pose { double x; };
struct POSE { double x; };
namespace other {
struct Pose { double y; };
}
inline namespace v2 {
struct Tagged { int x; };
}
struct Longerererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererererer { int moooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooooore; };
}
