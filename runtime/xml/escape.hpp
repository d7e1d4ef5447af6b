// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Text that is written into XML.
#ifndef OROFORGE_XML_ESCAPE_HPP
#define OROFORGE_XML_ESCAPE_HPP

#include <string>

namespace oroforge::xml {

// Bytes that are no UTF-8 become the letters that they are in Latin-1, so that what is written is UTF-8.

/// That alone, for text that is written elsewhere.
std::string asUtf8(const std::string& text);

/// For character data: & < > escaped; control characters XML cannot carry are dropped.
std::string escapeText(const std::string& text);

/// For a value between double quotes: also the quotes, tabs and line ends, so that they survive reading.
std::string escapeAttribute(const std::string& text);

/// For character data, or a value between double quotes, that must be read back exactly: blanks that reading would cut
/// off or join, and control characters, become character references.
std::string escapeExactly(const std::string& text, bool inAttribute = false);

}  // namespace oroforge::xml

#endif
