// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#pragma once
#include "library.hpp"

namespace arm {

struct Arm {
    library::Point base = library::Point::origin();
    library::Path path;
};

}  // namespace arm
