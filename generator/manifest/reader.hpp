// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// A component manifest as a model.
#ifndef OROFORGE_GENERATOR_MANIFEST_READER_HPP
#define OROFORGE_GENERATOR_MANIFEST_READER_HPP

#include <optional>
#include <string>

#include <diag/sink.hpp>
#include <model/package.hpp>

namespace oroforge::manifest {

/// Nothing if the file is no XML or its root is not <package>. With other errors (see the sink) the model holds what
/// could be read, so that further checks can run and everything is reported at once.
std::optional<model::Package> readFile(const std::string& path, diag::Sink& sink);

/// `name` stands for the file name in diagnostics.
std::optional<model::Package> readText(const std::string& text, const std::string& name, diag::Sink& sink);

}  // namespace oroforge::manifest

#endif
