#pragma once
namespace odd_files {
/// How full
/// it is.
struct Crlf {
    double level;  ///< in the tank @unit m
};
}
