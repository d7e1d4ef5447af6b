// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The `<simple name="…" type="…"><value>…</value></simple>` elements of deployment XML. Each reader reports what is
// wrong (DEP003 no value, DEP004 wrong type, DEP005 bad value) and then returns nothing.
#ifndef OROFORGE_DEPLOYMENT_READ_VALUE_HPP
#define OROFORGE_DEPLOYMENT_READ_VALUE_HPP

#include "plan.hpp"

#include <diag/sink.hpp>

#include <optional>
#include <string>
#include <vector>

namespace OCL::deploy {

std::optional<bool> readBoolean(const xml::Element& element, diag::Sink& sink);
/** Any of the integer types; DEP005 if outside of [least, most]. `meaning` tells users what the numbers stand for. */
std::optional<long long> readInteger(const xml::Element& element, long long least, long long most, diag::Sink& sink,
                                     const std::string& meaning = {});
enum class TimeUnit { Seconds, Milliseconds };
/** A floating point or integer type, with the unit s, ms or us behind the number or in `unit`, as is the result. */
std::optional<double> readTime(const xml::Element& element, TimeUnit unit, diag::Sink& sink);
std::optional<Text> readString(const xml::Element& element, diag::Sink& sink);
/** A string that must not be empty (DEP003). */
std::optional<Text> readWord(const xml::Element& element, diag::Sink& sink);
/** Warns (DEP060) of elements of the same name, of those in `names` if that is not empty; of these the last counts. Structs give
    what they have. */
void checkTwice(const xml::Element& parent, const std::vector<std::string>& names, diag::Sink& sink);

/** The name attribute and its place; empty, at the element, if there is none. */
Text nameOf(const xml::Element& element);
/** The type attribute and its place; empty, at the element, if there is none. */
Text typeOf(const xml::Element& element);
/** True for a `<struct>` or `<sequence>`; else reports DEP004 that `what` must be one. */
bool requireStruct(const xml::Element& element, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
