// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Escapes text for XML.
#ifndef OROFORGE_XML_ESCAPE_HPP
#define OROFORGE_XML_ESCAPE_HPP

#include <string>

namespace oroforge::xml {

// Bytes that are not UTF-8 are read as Latin-1, so that the result is always UTF-8.

/// The text in UTF-8, without escaping, to be written elsewhere.
std::string asUtf8(const std::string& text);

/// For character data: escapes & < > and drops control characters that XML cannot have.
std::string escapeText(const std::string& text);

/// For a value between double quotes: also escapes the quotes, tabs and line ends, so that they survive reading.
std::string escapeAttribute(const std::string& text);

/// For character data, or a value between double quotes, that must be read back exactly: blanks that reading would cut
/// off or join, and control characters, become character references.
std::string escapeExactly(const std::string& text, bool inAttribute = false);

}  // namespace oroforge::xml

#endif
