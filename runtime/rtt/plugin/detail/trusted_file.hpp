// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_PLUGIN_TRUSTED_FILE_HPP
#define OROFORGE_PLUGIN_TRUSTED_FILE_HPP

#include <string>

namespace RTT::plugin {

/**
 * Why code is not to be loaded from this file; empty if it may be, or does not exist. The file and its folder must belong to
 * the user of this process (or of `sudo`), to root, or to an owner that ORO_TRUSTED_OWNERS names (names or numbers, separated by blanks,
 * ',' or ':'), and nobody else may write to them: a folder such as /tmp, where everybody may make files, is none to load from.
 * No folder above may be one where others can put another folder in the place of the present one.
 */
std::string whyNotTrusted(const std::string& path);

}  // namespace RTT::plugin

#endif
