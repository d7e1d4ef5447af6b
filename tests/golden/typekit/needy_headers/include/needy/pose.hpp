#pragma once
// Compiles only after config.hpp and units.hpp.
namespace needy {
struct Pose {
    Metres at[NEEDY_AXES];
    Frame frame = Frame::World;
    Metres length() const { return lengthOf(at); }
    template <class T>
    static Metres lengthOf(const T&) { return 0; }
};
}
