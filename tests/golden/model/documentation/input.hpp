#pragma once
namespace demo {
/// How fast something turns.
///
/// Second paragraph.
struct Speed {
    /** @brief about the axis
     *  @unit rad/s
     */
    double turn = 0;
    double along = 0;  ///< forward @unit m/s
    // not documentation
    double other = 0;
    int grüße = 0;  ///< "quoted" \ and Umlaute: äöü
};
/// What is going on.
enum class State {
    Idle,  ///< nothing
    Busy   ///< something
};
}
#ifdef __orogen
#define UNIT(text) [[oro::unit(text)]]
#else
#define UNIT(text)
#endif
namespace demo {
struct Annotated {
    [[oro::unit("m")]] double height;
    [[oro::range(-1, 2.5)]] UNIT("rad") double angle;  ///< of the arm @unit deg
    [[oro::doc("how – full")]] double level;  // Füllstand
    double pressure;  ///< in the tank @range 0..5 @unit bar
    __attribute__((annotate("oro.unit=s"))) double time;
    double behind [[oro::unit("no")]];
    [[maybe_unused, oro::unit("A")]] double current = 0;
    double plain = 0;
};
}
