// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// States of components as text.
#ifndef OROFORGE_LIVE_CLIENT_STATE_TEXT_HPP
#define OROFORGE_LIVE_CLIENT_STATE_TEXT_HPP

#include "json.hpp"
#include "output.hpp"

#include <string>

namespace oroforge::live_client {

/** "2 Running, 1 Stopped" */
std::string stateSummary(const Json& components);
/** The style of a state: good for a running component, bad for one with an error. */
Style styleOfState(const std::string& state);

}  // namespace oroforge::live_client

#endif
