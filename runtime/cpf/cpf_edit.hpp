// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Changes values within the text of an existing property file.
#ifndef ORO_CPF_EDIT_HPP
#define ORO_CPF_EDIT_HPP

#include <rtt/PropertyBag.hpp>

#include <xml/element.hpp>

#include <string>

namespace RTT {
namespace marsh {

/**
 * Returns `text`, a property file with the root element `root`, with the values of `bag`, whose items were taken apart
 * by types::decomposePropertyBag(). With `addNew`, adds the properties that only the bag has. All else stays: comments,
 * layout, descriptions, and what only the file has. A struct or sequence is written as a whole, whatever `addNew` is:
 * the file then has all of its members and no others. Its elements in the file stay if they are the first members in
 * their order, or all members of a type that finds them by name; otherwise they are written anew, after the comments.
 */
RTT_API std::string editedCpf(const std::string& text, const oroforge::xml::Element& root, const PropertyBag& bag,
                              bool addNew);

}  // namespace marsh
}  // namespace RTT

#endif
