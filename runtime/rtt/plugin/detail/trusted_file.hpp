// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_PLUGIN_TRUSTED_FILE_HPP
#define OROFORGE_PLUGIN_TRUSTED_FILE_HPP

#include <string>

namespace RTT::plugin {

/**
 * Why code must not be loaded from this file; empty if it may be, or if the file does not exist. The file and its
 * folder must belong to the user of this process (or of `sudo`), to root, or to an owner in ORO_TRUSTED_OWNERS (names
 * or numbers, separated by blanks, ',' or ':'), and nobody else may write to them; this rules out folders such as /tmp.
 * In no folder above may others be able to replace the one below it.
 */
std::string whyNotTrusted(const std::string& path);

}  // namespace RTT::plugin

#endif
