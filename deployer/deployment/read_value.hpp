// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Readers of the `<simple name="…" type="…"><value>…</value></simple>` elements of deployment XML. Each reports errors
// (DEP003 no value, DEP004 wrong type, DEP005 bad value) and then returns nothing.
#ifndef OROFORGE_DEPLOYMENT_READ_VALUE_HPP
#define OROFORGE_DEPLOYMENT_READ_VALUE_HPP

#include "plan.hpp"

#include <diag/sink.hpp>

#include <optional>
#include <string>
#include <vector>

namespace OCL::deploy {

std::optional<bool> readBoolean(const xml::Element& element, diag::Sink& sink);
/** Reads any integer type; DEP005 if it is outside of [least, most]. Messages explain the numbers by `meaning`. */
std::optional<long long> readInteger(const xml::Element& element, long long least, long long most, diag::Sink& sink,
                                     const std::string& meaning = {});
enum class TimeUnit { Seconds, Milliseconds };
/** Reads a floating point or integer type with the unit s, ms or us after the number, by default `unit`. Returns it in
    `unit`. */
std::optional<double> readTime(const xml::Element& element, TimeUnit unit, diag::Sink& sink);
std::optional<Text> readString(const xml::Element& element, diag::Sink& sink);
/** Reads a string that must not be empty (DEP003). */
std::optional<Text> readWord(const xml::Element& element, diag::Sink& sink);
/** Warns (DEP060) of several elements of one name, because only the last is used. Checks only `names` unless that is
    empty. All elements of structs are used. */
void checkTwice(const xml::Element& parent, const std::vector<std::string>& names, diag::Sink& sink);

/** The name attribute and its place; if there is none, an empty text with the place of the element. */
Text nameOf(const xml::Element& element);
/** The type attribute and its place; if there is none, an empty text with the place of the element. */
Text typeOf(const xml::Element& element);
/** True for a `<struct>` or `<sequence>`; otherwise reports DEP004, that `what` must be one. */
bool requireStruct(const xml::Element& element, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
