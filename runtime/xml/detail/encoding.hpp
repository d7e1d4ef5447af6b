// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Checks that a text is UTF-8.
#ifndef OROFORGE_XML_DETAIL_ENCODING_HPP
#define OROFORGE_XML_DETAIL_ENCODING_HPP

#include <string>

#include <diag/sink.hpp>

namespace oroforge::xml::detail {

/// The number of bytes of the UTF-8 letter at `at`; 0 if there is no valid one.
std::size_t letterAt(const std::string& text, std::size_t at);

/// True for UTF-8 without control characters other than tabs and line ends, unless the declaration names another
/// encoding; otherwise reports one error at its place. Another encoding that extends ASCII is no error if the text is
/// plain ASCII.
bool checkEncoding(const std::string& text, const std::string& name, diag::Sink& sink);

}  // namespace oroforge::xml::detail

#endif
