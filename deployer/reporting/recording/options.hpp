// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_OPTIONS_HPP
#define OROFORGE_RECORDING_OPTIONS_HPP

#include "recording.hpp"

#include <string>

namespace OCL::recording {

/** Properties of the component. */
struct OptionTexts {
    std::string compression, split, ringSize, clock, schema;
    unsigned int chunkSize;
    double chunkTime, ring;
    bool reproducible;
};

/** False, with what is wrong, if a text or number is not valid. */
bool readOptions(const OptionTexts& texts, RecordingOptions& options, std::string& why);
}  // namespace OCL::recording

#endif
