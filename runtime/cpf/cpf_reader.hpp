// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reads property files into bags, with the place of each property.
#ifndef ORO_CPF_READER_HPP
#define ORO_CPF_READER_HPP

#include <rtt/PropertyBag.hpp>

#include <diag/sink.hpp>
#include <xml/document.hpp>

#include <optional>
#include <string>
#include <unordered_map>

namespace RTT {
namespace marsh {

namespace diag = oroforge::diag;
namespace xml = oroforge::xml;

/** The place in the file of each property of a bag. */
typedef std::unordered_map<const base::PropertyBase*, diag::Location> Places;

/**
 * Adds the properties that the children of `parent` describe; the bag owns them. Reports all errors (codes CPF…) and
 * returns false if there was one.
 */
RTT_API bool readBag(const xml::Element& parent, PropertyBag& into, diag::Sink& sink, Places* places = nullptr);

/** Reports what is wrong with one child, and keeps no property. */
RTT_API void checkProperty(const xml::Element& child, diag::Sink& sink);

/** As readBag() for a file, whose root must be <properties>. */
RTT_API bool readFile(const std::string& file, PropertyBag& into, diag::Sink& sink, Places* places = nullptr);
/** As readBag() for the text of a file, which diagnostics call `name`. Nothing if there was an error. */
RTT_API std::optional<xml::Document> readText(const std::string& text, const std::string& name, PropertyBag& into,
                                              diag::Sink& sink, Places* places = nullptr);

/** In this process, text after a number and between elements is ignored with a warning instead of being an error. The
    original ignores it silently. */
RTT_API void setLenientReading(bool lenient);
RTT_API bool lenientReading();

/**
 * Reports text after a number (CPF007). `what` names the value and its owner in messages, `taken` is the number without
 * that text. True if the number is used, because of setLenientReading() or because it is whole and has the fraction 0.
 */
RTT_API bool reportTextBehindNumber(const diag::Location& where, const std::string& what, const std::string& text,
                                    const std::string& taken, const std::string& expected, diag::Sink& sink);

/** Reports text in an element that may have none: an error, or in a lenient process a warning. */
RTT_API void reportStrayText(const xml::Element& element, const char* code, diag::Sink& sink);

/** Logs each diagnostic of the sink on a line. */
RTT_API void logDiagnostics(const diag::Sink& sink);

}  // namespace marsh
}  // namespace RTT

#endif
