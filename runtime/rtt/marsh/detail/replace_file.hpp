// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_REPLACE_FILE_HPP
#define ORO_REPLACE_FILE_HPP

#include <rtt/rtt-config.h>
#include <string>
#include <system_error>

namespace RTT {
namespace marsh {

/**
 * Replaces the content of the file as a whole or not at all, whether the process crashes or the machine: the text is
 * written beside it first, and the disk is waited for. What earlier processes left there is removed. The file keeps its
 * permissions, and its owner and group as far as this process may set them; a symbolic link stays one and its target is
 * replaced. Devices and pipes are written to. So are files beside which none can be added and those that cannot be
 * replaced, such as mount points; only these may be left half-written. Refuses read-only files.
 */
RTT_API std::error_code replaceFile(const std::string& file, const std::string& text);

}  // namespace marsh
}  // namespace RTT

#endif
