// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPLAY_REPLAY_OPTIONS_HPP
#define OROFORGE_REPLAY_REPLAY_OPTIONS_HPP

#include "../player.hpp"

#include <string>
#include <vector>

namespace OCL::replay {

/** How a recording is replayed, as properties say it. */
struct ReplayOptions {
    std::string file = "recording.mcap";
    double speed = 1, start = 0, end = 0;  ///< seconds; an end of 0 is that of the recording
    bool loop = false, tolerate = false;
    std::string topics;  ///< patterns; all ports if it is empty
};

bool isSpeed(double speed);

/** What is wrong with Speed, Start and End, with the code; empty if nothing is. */
std::string whatIsWrong(const ReplayOptions& options, double duration);

/** The topics that one of the patterns names. None, with the reason, if a pattern names none. */
std::vector<Topic> chooseTopics(const std::vector<Topic>& all, const std::string& patterns, std::string& why);

}  // namespace OCL::replay

#endif
