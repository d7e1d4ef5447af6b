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
