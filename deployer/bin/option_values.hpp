// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The options of the command line that belong together.
#ifndef OROFORGE_DEPLOYER_OPTION_VALUES_HPP
#define OROFORGE_DEPLOYER_OPTION_VALUES_HPP

#include "deployer_options.hpp"

#include <boost/program_options/variables_map.hpp>

#include <string>

namespace OCL::deploy {

/** Takes what concerns the live window. `error` is set if something is invalid. */
void takeLive(const boost::program_options::variables_map& values, Options& options, std::string& error);
/** Takes what concerns a replay. Call it after the other options are taken. */
void takeReplay(const boost::program_options::variables_map& values, Options& options, std::string& error);

}  // namespace OCL::deploy

#endif
