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
 * Replaces the content of the file as a whole or not at all, even if the process or the machine crashes: it writes the
 * text to a temporary file beside it, syncs that to disk, and renames it. It removes temporary files that earlier
 * processes left. The file keeps its permissions, and its owner and group if this process may set them; a symbolic link
 * stays, and its target is replaced. Devices and pipes are written in place. So are files in a folder where none can be
 * created and files that cannot be replaced, such as mount points; only these may be left half-written. Read-only files
 * are refused.
 */
RTT_API std::error_code replaceFile(const std::string& file, const std::string& text);

}  // namespace marsh
}  // namespace RTT

#endif
