// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "recording_player.hpp"

#include <exception>

OCL::replay::Player* oroOpenRecording(const char* file, const OCL::replay::PlayerOptions& options,
                                      std::string& error) noexcept {
    try {
        return OCL::replay::RecordingPlayer::open(file, options, error).release();
    } catch (const std::exception& thrown) {
        error = std::string(file) + ": error: [MCP010] the recording cannot be read: " + thrown.what();
    }
    return nullptr;
}
