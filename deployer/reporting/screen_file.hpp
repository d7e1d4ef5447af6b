// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPORTING_SCREEN_FILE_HPP
#define OROFORGE_REPORTING_SCREEN_FILE_HPP

#include <functional>
#include <iosfwd>
#include <string>

namespace OCL::reporting {

/** Writes what `screen` writes to the file `<component>.screen`. False, with an error in the log, if that fails. */
bool writeScreenFile(const std::string& component, const std::function<bool(std::ostream&)>& screen);

}  // namespace OCL::reporting

#endif
