// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_LEFTOVERS_HPP
#define RTT_DETAIL_LOG_LEFTOVERS_HPP

#include <cstddef>
#include <string>

namespace RTT {
namespace detail {

/**
 * The name of a log file of this process, beside the one of that name, which another process writes:
 * `<stem>-<process id>[-<number>]<extension>`.
 */
std::string ownLogName(const std::string& name, int number);

/**
 * Deletes files with such names that processes which have ended left behind, with their earlier files (`.1`, `.2`, …),
 * but for the `keep` latest. Returns how many processes' files that were.
 *
 * A file stays if it is locked, is another user's, is no regular file, or is of the process with the id of this one. It
 * also stays unless its first line says that it was written instead of `name`, since a copy may have such a name.
 */
std::size_t removeLogLeftovers(const std::string& name, unsigned keep);

}  // namespace detail
}  // namespace RTT
#endif
