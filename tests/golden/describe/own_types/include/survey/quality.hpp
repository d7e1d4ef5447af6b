#pragma once

namespace survey {

enum class Quality { Bad, Good };

template <class T>
struct Rated {
    T value;
    Quality quality;
};

}  // namespace survey
