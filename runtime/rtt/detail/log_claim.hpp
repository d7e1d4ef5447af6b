// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_CLAIM_HPP
#define RTT_DETAIL_LOG_CLAIM_HPP

#include <string>

#include <sys/stat.h>

namespace RTT {
namespace detail {

/** An open log file. */
struct ClaimedLog {
    int descriptor = -1;
    int error = 0;         // an errno, if there is none
    std::string name;      // may differ from the one that was asked for
    std::string path;      // of the file itself, behind links; empty: it is no regular file
    std::string heldBy;    // why the name differs, such as "another process"
    bool rotated = false;  // earlier lines are in `path`.1
    int rotateError = 0;   // an errno: earlier lines stay in the file
};

/**
 * Opens the log file for adding and claims it for this process: the file is locked (flock) until all its descriptors
 * are closed, also in children of fork(). Lines of an earlier process move to `<name>.1`, those to `.2`, …, up to
 * `keep`; with 0 they are deleted. The file of a living process is not touched: this one gets
 * `<stem>-<process id><extension>`. `again`: a file with this identity is added to as it is.
 *
 * What is no regular file, or where the standard output goes, is only opened. A FIFO that nobody reads takes 64 KiB,
 * and no more lines then.
 */
ClaimedLog claimLog(const std::string& name, unsigned keep, const struct stat* again);

/**
 * Replaces the claimed file `descriptor` at `path` by an empty one that is claimed as well; the lines are in `path`.1
 * then. Returns its descriptor; −1 and errno if nothing has changed, with EAGAIN if another process was faster.
 */
int rotateLog(const std::string& path, int descriptor, unsigned keep);

/** True if `name` still leads to the file of this identity. */
bool leadsTo(const std::string& name, const struct stat& file);

}  // namespace detail
}  // namespace RTT
#endif
