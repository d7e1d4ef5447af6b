// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reads deployment XML into a plan. Reports all errors of form to the sink in one run; the plan has what is valid.
//
//     readPlan (files, includes, top level) → readComponent → readActivity
//                                           → readPolicy
#ifndef OROFORGE_DEPLOYMENT_XML_TO_PLAN_HPP
#define OROFORGE_DEPLOYMENT_XML_TO_PLAN_HPP

#include "plan.hpp"

#include <diag/sink.hpp>

#include <string>

namespace OCL::deploy {

/** Reads a file and the files that it includes. The plan of a malformed file is empty, and the sink has an error. */
Plan readPlanFile(const std::string& file, diag::Sink& sink);
/** Reads a text, which messages call `name`. */
Plan readPlanText(const std::string& text, const std::string& name, diag::Sink& sink);

// The steps, which have files of their own.
ComponentPlan readComponent(xml::Element&& element, diag::Sink& sink);
ActivityPlan readActivity(const xml::Element& element, diag::Sink& sink);
/** Members that are left out have the values of `policy`. */
PolicyPlan readPolicy(const xml::Element& element, const RTT::ConnPolicy& policy, diag::Sink& sink);
/** True for a struct, whose properties are checked for form; they are read when the component exists. */
bool readProperties(const xml::Element& element, diag::Sink& sink);
/** True if the struct is a connection policy and not a component, by its type or its members. */
bool isPolicy(const xml::Element& element);

/**
 * The path of a file that another one names. Relative names are looked up in the current directory and then beside the
 * file that names it.
 */
std::string resolveFile(const Text& file);
/** Why a file that another one names cannot be read; empty if it can. A pipe can be read only once. */
std::string whyUnreadable(const Text& file, bool readOnce = false);
/** Reports text between the children of `element`. */
void checkText(const xml::Element& element, diag::Sink& sink);
/** Warns of what is ignored in a struct: unknown attributes and elements, and a second value. */
void checkForm(const xml::Element& element, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
