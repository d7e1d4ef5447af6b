// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reads deployment XML into a plan. Everything wrong with its form is reported to the sink, all in one run; the plan
// holds what could be understood.
//
//     readPlan (files, includes, top level) → readComponent → readActivity
//                                           → readPolicy
#ifndef OROFORGE_DEPLOYMENT_XML_TO_PLAN_HPP
#define OROFORGE_DEPLOYMENT_XML_TO_PLAN_HPP

#include "plan.hpp"

#include <diag/sink.hpp>

#include <string>

namespace OCL::deploy {

/** Reads a file and the files it includes. A plan of a malformed file is empty; look at the sink. */
Plan readPlanFile(const std::string& file, diag::Sink& sink);
/** Reads a text; `name` stands for the file in messages. */
Plan readPlanText(const std::string& text, const std::string& name, diag::Sink& sink);

// The steps, for the files that implement them.
ComponentPlan readComponent(xml::Element&& element, diag::Sink& sink);
ActivityPlan readActivity(const xml::Element& element, diag::Sink& sink);
/** Members that are left out are those of `policy`. */
PolicyPlan readPolicy(const xml::Element& element, const RTT::ConnPolicy& policy, diag::Sink& sink);
/** True for a struct. Its properties are looked through; they are read when there is a component that has them. */
bool readProperties(const xml::Element& element, diag::Sink& sink);
/** True if the struct says or shows that it is a connection policy and not a component. */
bool isPolicy(const xml::Element& element);

/**
 * The path of a file named in another: relative names count from the current directory; what is not there is looked
 * up beside the file that names it.
 */
std::string resolveFile(const Text& file);
/** Why a file that is named in another cannot be read; empty if it can. A pipe can be read only once. */
std::string whyUnreadable(const Text& file, bool readOnce = false);
/** Reports text that stands between the elements of `element`. */
void checkText(const xml::Element& element, diag::Sink& sink);
/** Warns of what stands in a struct and is not looked at: attributes and elements that mean nothing, a second value. */
void checkForm(const xml::Element& element, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
