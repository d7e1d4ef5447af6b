// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Property files to bags, with the place of each property.
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

/** Where in the file the properties of a bag stand. */
typedef std::unordered_map<const base::PropertyBase*, diag::Location> Places;

/**
 * Adds the properties that the children of `parent` describe, in the form of property files; the bag owns them.
 * Reports all errors (codes CPF…), false if there was one.
 */
RTT_API bool readBag(const xml::Element& parent, PropertyBag& into, diag::Sink& sink, Places* places = nullptr);

/** Reports what is wrong with one of the children, whose property is not kept. */
RTT_API void checkProperty(const xml::Element& child, diag::Sink& sink);

/** The same for a file, whose root must be <properties>. */
RTT_API bool readFile(const std::string& file, PropertyBag& into, diag::Sink& sink, Places* places = nullptr);
/** The same for its text; `name` stands for the file in diagnostics. Nothing if there was an error. */
RTT_API std::optional<xml::Document> readText(const std::string& text, const std::string& name, PropertyBag& into,
                                              diag::Sink& sink, Places* places = nullptr);

/** In this process, text behind a number and between elements is left out with a warning, as the original did without one; else
    it is an error. */
RTT_API void setLenientReading(bool lenient);
RTT_API bool lenientReading();

/**
 * Reports text behind a number (CPF007). `what` is the value and its owner for messages, `taken` the number without that text.
 * True if the number counts, because of
 * setLenientReading() or because it is a whole one with the fraction 0.
 */
RTT_API bool reportTextBehindNumber(const diag::Location& where, const std::string& what, const std::string& text,
                                    const std::string& taken, const std::string& expected, diag::Sink& sink);

/** Reports the text of an element that has none: an error, or in a lenient process a warning. */
RTT_API void reportStrayText(const xml::Element& element, const char* code, diag::Sink& sink);

/** Writes what the sink has to the log, one line each. */
RTT_API void logDiagnostics(const diag::Sink& sink);

}  // namespace marsh
}  // namespace RTT

#endif
