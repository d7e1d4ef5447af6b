// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_SHORT_PATH_HPP
#define OROFORGE_LIVE_SHORT_PATH_HPP

#include <string>

namespace oroforge::live_client {

/** A path that fits into the address of a socket. One that is too long leads through its open folder, in /proc/self/fd,
    as long as this object exists. */
class ShortPath {
public:
    explicit ShortPath(const std::string& path);
    ~ShortPath();
    ShortPath(const ShortPath&) = delete;
    ShortPath& operator=(const ShortPath&) = delete;

    /** The path itself if the folder cannot be opened. */
    const std::string& text() const { return text_; }

private:
    std::string text_;
    int folder_ = -1;
};

}  // namespace oroforge::live_client

#endif
