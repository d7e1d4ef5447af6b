// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The interface of a component as lines of text: of one that runs, and of one that is described. Equal lines, equal
/// interfaces.
#ifndef OROFORGE_TESTS_DESCRIBE_INTERFACE_LINES_HPP
#define OROFORGE_TESTS_DESCRIBE_INTERFACE_LINES_HPP

#include <string>
#include <vector>

#include <model/package.hpp>

namespace RTT {
class Service;
class TaskContext;
}  // namespace RTT

namespace oroforge::test {

using Lines = std::vector<std::string>;

/// Without what every component has.
Lines linesOf(RTT::TaskContext& component);
Lines linesOf(RTT::Service& service);

Lines linesOf(const model::Component& component);
Lines linesOf(const model::ServicePlugin& service);

/// One spelling for each type, whether a compiler or a user wrote it.
std::string commonSpelling(std::string type);

}  // namespace oroforge::test

#endif
