// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reads the fields of requests, which may be any JSON, and makes texts that JSON can carry.
#ifndef OROFORGE_LIVE_FIELDS_HPP
#define OROFORGE_LIVE_FIELDS_HPP

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace OCL::live {

/** True if it nests deeper than requests may, so that functions of the JSON library that recurse must not get it. */
bool isTooDeep(const nlohmann::json& value);

// They throw Failure. The request is an object.
std::string textField(const nlohmann::json& request, const char* name);
std::string textField(const nlohmann::json& request, const char* name, const std::string& otherwise);
/** A number of seconds above 0, at most an hour. */
double secondsField(const nlohmann::json& request, const char* name, double otherwise);

/** "a text", "a number" …, to put after "found". */
const char* kindOf(const nlohmann::json& value);

/** At most `most` bytes of the text; "…" at its end, which counts, says that it was longer. No letter is cut. */
std::string cut(const std::string& text, std::size_t most);
/** Replaces what is not UTF-8 in all texts; names and values of components may be anything. */
void makeUtf8(nlohmann::json& value);

}  // namespace OCL::live

#endif
