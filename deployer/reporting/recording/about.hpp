// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_RECORDING_ABOUT_HPP
#define OROFORGE_RECORDING_ABOUT_HPP

#include "recording.hpp"

#include <reporting/mcap/records.hpp>

#include <vector>

namespace OCL::recording {

/** Where a recording comes from: the process, unless the recording is to be reproducible, and its deployment. */
std::vector<oroforge::mcap::Metadata> aboutRecording(const RecordingOptions& options);

}  // namespace OCL::recording

#endif
