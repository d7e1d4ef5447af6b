#ifndef USER_TYPES_HPP
#define USER_TYPES_HPP
#include <classic/classic-types.hpp>
namespace user {
struct Map {
    std::vector<classic::Track> tracks;
    classic::Point origin;
};
}
#endif
