// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Refuses what is no text in UTF-8.
#ifndef OROFORGE_XML_DETAIL_ENCODING_HPP
#define OROFORGE_XML_DETAIL_ENCODING_HPP

#include <string>

#include <diag/sink.hpp>

namespace oroforge::xml::detail {

/// How many bytes the letter at `at` takes in UTF-8; 0 if there is none.
std::size_t letterAt(const std::string& text, std::size_t at);

/// True for UTF-8 without control characters other than tabs and line ends, whose declaration, if there is one, does not name
/// another encoding; else one error at its place. A declared encoding whose first half is ASCII is no error if the text has no more.
bool checkEncoding(const std::string& text, const std::string& name, diag::Sink& sink);

}  // namespace oroforge::xml::detail

#endif
