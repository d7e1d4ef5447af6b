#pragma once
#include <array>
#include <chrono>
#include <cstdint>
// What recorders take as the time of a struct, and what they do not.
namespace remarks {
struct Time {
    std::int32_t sec;
    std::uint32_t nanosec;
};
struct Parts {
    double seconds;
    long long nanoseconds;
};
struct Long {
    long long made;  ///< @stamp
};
struct Unsigned {
    /// When it was taken. @stamp
    std::uint64_t made;
};
struct Header {
    Time stamp;  ///< When. @stamp
};
struct Within {
    Header header;
    double other;  ///< Not the first one. @stamp
};
struct Other {
    double time;  ///< Not @stamped.
};
struct Base {
    float made;  ///< @stamp
};
struct Derived : Base {
    int value;
};
struct Short {
    int made;  ///< @stamp
};
struct InParts {
    Parts made;  ///< @stamp
};
struct Many {
    std::int64_t made[2];          ///< @stamp
    std::array<Header, 2> headers;
};
struct Chrono {  // good
    std::chrono::nanoseconds made;  ///< @stamp
};
}
