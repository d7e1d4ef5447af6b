// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/ProgramInterface.hpp>

namespace RTT::scripting {

ProgramInterface::~ProgramInterface() = default;

std::string ProgramInterface::getText() const { return {}; }
int ProgramInterface::getFirstLine() const { return 1; }
std::string ProgramInterface::getError() const { return {}; }

std::string ProgramInterface::getProgramStatusStr() const {
    switch (getStatus()) {
        case Status::stopped: return "stopped";
        case Status::paused: return "paused";
        case Status::running: return "running";
        case Status::error: return "error";
        case Status::unknown: break;
    }
    return "unknown";
}

}  // namespace RTT::scripting
