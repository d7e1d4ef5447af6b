// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_FAILURE_HPP
#define OROFORGE_LIVE_FAILURE_HPP

#include <stdexcept>
#include <string>

namespace OCL::live {

// deployer/explain has a text for each.
inline constexpr const char* kMalformed = "LIV001";
inline constexpr const char* kUnknownVerb = "LIV002";
inline constexpr const char* kUnknownName = "LIV003";
inline constexpr const char* kNoAnswer = "LIV004";
inline constexpr const char* kNotAllowed = "LIV005";
inline constexpr const char* kWrongValue = "LIV006";
inline constexpr const char* kReadOnly = "LIV007";
inline constexpr const char* kGone = "LIV008";
inline constexpr const char* kFailed = "LIV009";
inline constexpr const char* kTooMany = "LIV010";
inline constexpr const char* kNoForm = "LIV011";

/** Why a request cannot be answered: becomes an "oro.error". */
class Failure : public std::runtime_error {
public:
    Failure(const char* code, const std::string& message) : std::runtime_error(message), code_(code) {}
    const char* code() const { return code_; }

private:
    const char* code_;
};

}  // namespace OCL::live

#endif
