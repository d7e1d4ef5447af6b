#pragma once
#include "library.hpp"

struct User {
    library::Vector vector;
    library::Ring<float, 2> ring;
    library::Mover mover;
    library::Sound sound;
};
