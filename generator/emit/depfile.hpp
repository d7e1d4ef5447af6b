// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Dependency files for make and ninja.
#ifndef OROFORGE_GENERATOR_EMIT_DEPFILE_HPP
#define OROFORGE_GENERATOR_EMIT_DEPFILE_HPP

#include <filesystem>
#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::emit {

/// Returns "out1 out2: in1 \" with the characters special to make escaped.
std::string depfileText(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

/// Returns false and reports an error EMIT001 if the file cannot be written.
bool writeDepfile(const std::filesystem::path& file, const std::vector<std::string>& outputs,
                  const std::vector<std::string>& inputs, diag::Sink& sink);

}  // namespace oroforge::emit

#endif
