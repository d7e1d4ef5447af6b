// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Completion in shells: the scripts of the shells ask `oro __complete WORD…`.
#ifndef OROFORGE_LIVE_CLIENT_COMPLETION_HPP
#define OROFORGE_LIVE_CLIENT_COMPLETION_HPP

#include <string>
#include <vector>

namespace oroforge::live_client {

/** A word that fits, and what it means. The next word does not begin behind one that ends with a point. */
struct Candidate {
    std::string word, text;
};

/** What can be in place of the last one of the words behind `oro`. Asks the running deployment for names, for a short
    time, and is silent if it does not know. */
std::vector<Candidate> candidatesFor(const std::vector<std::string>& words);

/** The script of a shell; empty if there is none for it. */
std::string scriptOf(const std::string& shell);

}  // namespace oroforge::live_client

#endif
