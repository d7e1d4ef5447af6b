// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_LOG_FILE_NAME_HPP
#define ORO_INTERNAL_LOG_FILE_NAME_HPP

#include <rtt/rtt-config.h>

#include <string>

namespace RTT {
namespace internal {

/** The path of the file that the log writes, with all lines that were logged before. Empty if it writes none, or one
    that cannot be read again, such as /dev/null. Any thread that is not real-time. */
RTT_API std::string flushedLogFile();

}  // namespace internal
}  // namespace RTT
#endif
