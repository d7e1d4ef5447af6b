// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_FILE_ABOUT_HPP
#define OROFORGE_MCAP_FILE_ABOUT_HPP

#include <reporting/mcap/format.hpp>

#include <string>

#include <sys/types.h>

namespace OCL::recording {

/** Of a process of this computer, for the metadata of a file: `start` (now), `command`, `folder`, `host`, `kernel`.
    What may not be read is empty. */
oroforge::mcap::Texts aboutProcess(pid_t process);

/** "Arm.gripper.force" is "/Arm/gripper/force". */
std::string topicOf(std::string path);

}  // namespace OCL::recording

#endif
