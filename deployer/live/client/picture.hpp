// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_CLIENT_PICTURE_HPP
#define OROFORGE_LIVE_CLIENT_PICTURE_HPP

#include "output.hpp"

#include <string>
#include <vector>

namespace oroforge::live_client {

/** Lines that are drawn again and again at the same place of a terminal. Without a terminal they follow each other. */
class Picture {
public:
    explicit Picture(Output& out) : out_(out) {}

    /** Replaces what was drawn before, with as many of the lines as the terminal has. */
    void draw(const std::vector<std::string>& lines);

private:
    Output& out_;
    std::size_t drawn_ = 0;  // lines
};

}  // namespace oroforge::live_client

#endif
